/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "interpreter/feature.h"
#include "io/io.h"
#include "tables/csv.h"
#include <errno.h>
#include <stdlib.h>
#include <string.h>

bool csv_end(struct csv_table *csv, struct problem *problem)
{
    bool good = csv && *csv->file.problem.text == '\0';
    if (csv && !good) {
        const char *path = strlen(csv->path) < 256 ? csv->path : names_shown(csv->path);
        problem_error(problem, "%s:%ld:%d: %s", path, csv->file.problem.at.line, csv->file.problem.at.column,
                      csv->file.problem.text);
    }
    csv_close(csv);
    return good;
}

struct csv_table *csv_named(const struct scene *scene, const struct run_context *run_context,
                            const char *name, const struct csv_kind *kind, struct problem *problem)
{
    const volatile sig_atomic_t *interrupt = scene->compute.interrupt;
    char *path = path_beside(run_context, name);
    FILE *in = path ? io_open_read(path, interrupt) : NULL;
    struct csv_table *csv = in ? csv_open(in, path, kind) : NULL;
    if (csv)
        csv->interrupt = interrupt;
    else
        problem_error(problem, "cannot read '%s': %s", names_shown(name), strerror(errno));
    if (in)
        fclose(in);
    if (!csv)
        free(path);
    else if (*csv->file.problem.text && !csv_end(csv, problem))
        csv = NULL;
    return csv;
}

/* Other features take rows and measurements from tables. */
const struct feature tables_feature = {.name = "tables"};
