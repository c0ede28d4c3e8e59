/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "commands/planning/measured.h"
#include "session/rowfile.h"
#include <math.h>
#include <stdlib.h>

enum { GAP, SPEED, ERROR, KINDS };

#define SPEEDS "m/s", "m/s, cm/s, mm/s, ft/s", "m/s", "write a speed such as 1.3 m/s"

static const struct csv_column columns[KINDS] = {
    {"gap", "spacing,distance,separation", CSV_REQUIRED, CSV_LENGTH, "write a length such as 9 mm",
     CSV_ABOVE_0, 1e9, "more than 0, up to 1e9 m"},
    {"speed", "velocity,v", CSV_REQUIRED, SPEEDS, CSV_ABOVE_0, 3e8, "more than 0, up to 3e8 m/s"},
    {"error", "errors,sigma,uncertainty,speed error", CSV_EMPTY, SPEEDS, CSV_ABOVE_0, 3e8,
     "more than 0, up to 3e8 m/s"},
};

static const struct csv_kind measurements = {
    .column = columns,
    .columns = KINDS,
    .rows_most = 10000,
    .item = "measured row",
    .items = "speeds",
    .names = "gap (mm), speed (m/s), and, if known, error (m/s)",
    .example = "gap (mm), speed (m/s)",
};

static bool row_keep(struct csv_table *csv, struct measured_rows *rows)
{
    const domq_real *value = csv->value;
    bool known = value[ERROR] > 0;
    if (rows->count > 0 && known != rows->errors)
        return csv_wrong(&csv->file, csv_cell(csv, ERROR).at,
                         "some speeds have an error and some have none; give all of them one, or none");
    struct measured_row *more = realloc(rows->row, (rows->count + 1) * sizeof *more);
    if (!more)
        return csv_wrong(&csv->file, csv->row.at, "out of memory");
    rows->errors = known;
    rows->row = more;
    rows->row[rows->count++] = (struct measured_row){value[GAP], value[SPEED], known ? value[ERROR] : 0};
    return true;
}

bool measured_read(const struct query *query, struct problem *problem, const char *path,
                   struct measured_rows *rows)
{
    struct csv_table *csv = csv_named(query->scene, query->means, path, false, &measurements, problem);
    *rows = (struct measured_rows){.row = NULL};
    while (csv && csv_next(csv) && row_keep(csv, rows))
        ;
    if (csv_end(csv, problem))
        return true;
    free(rows->row);
    rows->row = NULL;
    return false;
}
