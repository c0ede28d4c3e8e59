/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "commands/rows/row_run.h"
#include "commands/rows/falling.h"
#include <stdlib.h>

bool row_run_begin(const struct query *query, struct problem *problem, struct row_run *run)
{
    struct scene_row *scene = &run->scene;
    *run = (struct row_run){.hits = 0};
    if (!scene_row_make(query->scene, scene, problem))
        return false;
    if (!scene->row.engine)
        return true;
    scene->engine.report = &scene->report;
    scene->report.hit = malloc(scene->row.count * sizeof *scene->report.hit);
    if (scene->report.hit)
        return true;
    row_run_free(run);
    return problem_status(problem, query->scene, DOM_NO_MEMORY);
}

static bool fall_keep(const struct domq_fall *fall, void *context)
{
    struct row_run *run = context;
    run->fall[run->hits++] = *fall;
    return true;
}

bool row_run(const struct query *query, struct problem *problem, bool timed, struct row_run *run)
{
    if (!row_run_begin(query, problem, run))
        return false;
    run->scene.row.floor = false; /* no picture shows it */
    run->fall = calloc(run->scene.row.count, sizeof *run->fall);
    enum dom_status status =
        run->fall ? domq_row_run(&run->scene.row, &run->scene.compute, timed, fall_keep, run, &run->verdict)
                  : DOM_NO_MEMORY;
    run->timeless = timed && status == DOM_NO_MARGIN; /* the row falls all the same */
    if (status == DOM_OK || run->timeless)
        return true;
    row_run_free(run);
    return row_status(query, problem, status);
}

void row_run_free(struct row_run *run)
{
    free(run->scene.report.hit);
    free(run->scene.domino);
    free(run->fall);
}

bool row_run_tipped(const struct row_run *run, size_t k)
{
    return k == 0 && isnan(run->scene.row.push);
}
