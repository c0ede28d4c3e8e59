/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reads the measurements of 'fit'. */
#include "fit/fit.h"
#include "tables/csv.h"
#include <stdlib.h>

enum { POINTS_MOST = 20000 };

/* The columns of both kinds of files, and then those that only files of times have. */
enum { GAP, MEASURED, ERROR, DOMINO, DOMINOES, FRAME, RATE, RUN };

#define SPEED             "m/s", "m/s, cm/s, mm/s, ft/s", "m/s", "write a speed such as 1.3 m/s"
#define TIME              "s", "s, ms", "s", "write a time such as 0.12 s"
#define PLAIN             "", "none", "", "write a plain number"
#define FRAMES            "", "none", "", "write the number of frames per second, such as 240"
#define GAP_LENGTH        CSV_LENGTH, "write a length such as 9 mm", CSV_ABOVE_0, 1e9, "more than 0, up to 1e9 m"
#define UP_TO(most, unit) CSV_ABOVE_0, most, "more than 0, up to " #most unit

static const struct csv_column speed_columns[] = {
    [GAP] = {"gap", CSV_REQUIRED, GAP_LENGTH},
    [MEASURED] = {"speed", CSV_REQUIRED, SPEED, UP_TO(3e8, " m/s")},
    [ERROR] = {"error", CSV_EMPTY, SPEED, UP_TO(3e8, " m/s")},
};
static const struct csv_column time_columns[] = {
    [GAP] = {"gap", 0, GAP_LENGTH},
    [MEASURED] = {"time", CSV_REQUIRED | CSV_ONE_OF | CSV_EMPTY | CSV_BARE, TIME, -1e9, 1e9, "-1e9 .. 1e9 s"},
    [ERROR] = {"error", CSV_EMPTY, TIME, UP_TO(1e9, " s")},
    [DOMINO] = {"domino", CSV_WHOLE, PLAIN, 1, 1e6, "1 .. 1e6"},
    [DOMINOES] = {"dominoes", CSV_WHOLE, PLAIN, 2, 1e5, "2 .. 100000"},
    [FRAME] = {"frame", CSV_ONE_OF | CSV_EMPTY, PLAIN, -1e12, 1e12, "-1e12 .. 1e12"},
    [RATE] = {"rate", 0, FRAMES, UP_TO(1e9, "")},
    [RUN] = {"run", 0, PLAIN, -1e12, 1e12, "-1e12 .. 1e12"},
};

static const struct csv_kind times = {
    .column = time_columns,
    .columns = sizeof time_columns / sizeof *time_columns,
    .rows_most = POINTS_MOST,
    .item = "measurement",
    .items = "measurements",
    .names = "domino, time (s) or frame, and, if needed, rate, run, gap (mm), error (s)",
    .example = "domino, time (s)",
};
static const struct csv_kind speeds = {
    .column = speed_columns,
    .columns = sizeof speed_columns / sizeof *speed_columns,
    .rows_most = POINTS_MOST,
    .item = "measured row",
    .items = "speeds",
    .names = "gap (mm), speed (m/s), and, if known, error (m/s); or gap (mm), dominoes, time (s); or domino, "
             "time (s)",
    .example = "gap (mm), speed (m/s)",
    .otherwise = &times,
};

void fit_data_free(struct fit_data *data)
{
    free(data->point);
    free(data->run);
}

/* Adds a measurement to the last run or, if the row of the file has another number of a run, to a new run. */
static bool point_add(struct fit_data *d, struct csv_table *csv, struct fit_point point)
{
    const double number = csv->column[RUN] ? (double)csv->value[RUN] : 1,
                 gap = fit_has_rows(d) ? (double)NAN : point.gap;
    const bool known = point.error > 0;
    bool is_new = true;
    if (d->points > 0 && known != d->has_errors)
        return csv_wrong(&csv->file, csv_cell(csv, ERROR).at,
                         "some %s have an error and some have none; give an error to all of them, or to none",
                         csv->kind->items);
    for (size_t k = 0; k < d->runs && is_new; k++) {
        is_new = d->run[k].number != number;
        if (!is_new && k + 1 < d->runs)
            return csv_wrong(&csv->file, csv_cell(csv, RUN).at,
                             "the lines of run %g are interrupted by another run; put them together", number);
        if (!is_new && d->run[k].gap != gap && !isnan(gap))
            return csv_wrong(&csv->file, csv_cell(csv, GAP).at,
                             "run %g has two gaps; give each run a single gap, or leave out the column and "
                             "enter the row with 'set row'",
                             number);
    }
    struct fit_run *runs = is_new ? realloc(d->run, (d->runs + 1) * sizeof *runs) : d->run;
    d->run = runs ? runs : d->run;
    struct fit_point *points = realloc(d->point, (d->points + 1) * sizeof *points);
    d->point = points ? points : d->point;
    if (!runs || !points)
        return csv_wrong(&csv->file, csv->row.at, "out of memory");
    if (is_new)
        d->run[d->runs++] = (struct fit_run){.number = number, .gap = gap, .first = d->points};
    struct fit_run *run = &d->run[d->runs - 1];
    const struct fit_point *last = run->count > 0 ? &d->point[d->points - 1] : NULL;
    if (d->kind == FIT_HITS && last && last->domino >= point.domino)
        return csv_wrong(
            &csv->file, csv_cell(csv, DOMINO).at,
            "domino %zu comes after domino %zu; list the dominoes of a run in the order in which "
            "they are hit, each once",
            point.domino, last->domino);
    if (d->kind == FIT_HITS && last && last->measured >= point.measured)
        return csv_wrong(&csv->file, csv->row.at,
                         "the time %g s is not later than %g s, the time on the line above", point.measured,
                         last->measured);
    point.run = d->runs - 1;
    d->has_errors = known;
    d->point[d->points++] = point;
    run->count++;
    return true;
}

/* Adds the measurement in the current row of the file, unless its time is missing. */
static bool row_add(const struct query *query, struct fit_data *d, struct csv_table *csv, double rate)
{
    const domq_real *value = csv->value;
    const struct effect_state *row = &query->scene->effect[DOM_EFFECT_row];
    struct fit_point point = {.gap = (double)value[GAP],
                              .line = csv->row.at.line,
                              .measured = (double)value[MEASURED],
                              .error = (double)value[ERROR]};
    if (value[GAP] > query->scene->scale.h)
        return csv_wrong(&csv->file, csv_cell(csv, GAP).at,
                         "the gap %s is longer than the domino is tall, h = %s; 'set h' changes this height",
                         measured(value[GAP], "m", 6).text, measured(query->scene->scale.h, "m", 6).text);
    if (csv->column[RATE])
        rate = (double)value[RATE];
    if (csv->column[FRAME] && isnan(rate) && !isnan((double)value[FRAME]))
        return csv_wrong(&csv->file, csv_cell(csv, FRAME).at,
                         "frames need a frame rate: enter 'fit ... FILE 240' for 240 frames per second, or "
                         "add a column 'rate'");
    if (csv->column[FRAME])
        point.measured = (double)value[FRAME] / rate;
    if (isnan(point.measured))
        return true;
    if (d->kind == FIT_HITS)
        point.domino = (size_t)value[DOMINO];
    else if (d->kind == FIT_TOTALS && csv->column[DOMINOES])
        point.domino = (size_t)value[DOMINOES];
    else if (d->kind == FIT_TOTALS && row->on && !query->scene->listed.domino)
        point.domino = (size_t)row->value[0];
    if (d->kind == FIT_TOTALS && !csv->column[GAP])
        return csv_wrong(&csv->file, csv->head.at,
                         "which domino is hit at each time? Add a column 'domino', or, if these are times of "
                         "whole rows, the columns 'gap (mm)' and 'dominoes'");
    if (d->kind == FIT_TOTALS && point.domino == 0)
        return csv_wrong(&csv->file, csv->head.at,
                         "how many dominoes fell in this time? Add a column 'dominoes', or enter, for "
                         "example, 'set row 28'");
    if (d->kind == FIT_TOTALS && !(point.measured > 0))
        return csv_wrong(&csv->file, csv_cell(csv, MEASURED).at,
                         "the time in which a row falls must be more than 0");
    return point_add(d, csv, point);
}

bool fit_read(const struct query *query, const char *name, double rate, struct fit_data *data,
              struct problem *problem)
{
    *data = (struct fit_data){.points = 0};
    struct csv_table *csv = csv_named(query->scene, query->run_context, name, &speeds, problem);
    if (csv)
        data->kind = csv->kind == &speeds ? FIT_SPEEDS : csv->column[DOMINO] ? FIT_HITS : FIT_TOTALS;
    while (csv && csv_next(csv) && row_add(query, data, csv, rate)) {
    }
    return csv_end(csv, problem);
}
