/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs many rows with random errors, in batches that may run in parallel. */
#include "chance/model/draw.h"
#include "rows/model/study.h"
#include <stdatomic.h>
#include <stdlib.h>

/* Whether a row falls depends only on the signs of its margins, so their values need not be accurate. A
 * smaller tolerance would change about one verdict in a billion. */
#define VERDICT_TOL 1e-9

/* The data that all random rows of a study share. */
struct shared {
    const struct dom_row *row;
    struct dom_compute compute;
    const struct dom_placement *placement;
    atomic_size_t done, fall, unknown;
    atomic_size_t *stops; /* how many falls ended at each domino, or NULL if not requested */
};

/* A draw_visit that runs a random row and adds the result to the counts. */
static enum dom_status row_count(struct draw *draw, size_t i, void *context)
{
    struct shared *s = context;
    struct dom_verdict verdict;
    enum dom_status status = DOM_OK;
    draw_row(draw, s->row, s->placement, s->placement->first + i);
    if (s->row->engine)
        status = dom_row_run(&draw->row, &s->compute, false, NULL, NULL, &verdict);
    else {
        if (!draw->study)
            status = row_study_begin(s->row, &s->compute, &draw->study, NULL);
        if (status == DOM_OK)
            status = row_study(draw->study, &draw->row, 0, s->row->count - 1, &verdict);
    }
    if (status != DOM_OK)
        return status;
    const bool falls = verdict.end == DOM_ROW_FALLS,
               unknown = verdict.end == DOM_ROW_PASSES || verdict.end == DOM_ROW_PARTS;
    s->done++;
    s->fall += falls;
    s->unknown += unknown;
    if (s->stops && !falls && !unknown)
        s->stops[verdict.domino - 1]++;
    return DOM_OK;
}

/* Checks the arguments of a study. The model cannot check all of them. The study changes the gaps and the
 * tolerance before the model sees them, and could thereby hide bad values. */
static enum dom_status study_check(const struct dom_row *row, const struct dom_compute *compute,
                                   const struct dom_placement *p)
{
    enum dom_status status = p->rows == 0                                     ? DOM_BAD_ROWS
                             : row->count == 0                                ? DOM_BAD_COUNT
                             : !(compute->tol >= dom_arithmetic()->tol_floor) ? DOM_BAD_TOL
                                                                              : DOM_OK;
    for (int k = 0; k < DOM_ERROR_COUNT && status == DOM_OK; k++)
        if (!(p->error[k].size >= 0 && p->error[k].size < HUGE_VAL))
            status = DOM_BAD_ERROR;
    if (status == DOM_OK && p->error[DOM_ERROR_lean].size > 0 && (row->rho != 0 || row->engine))
        status = DOM_NO_LEAN;
    for (size_t k = 0; k < row->count && status == DOM_OK; k++)
        status = row->domino[k].gap >= 0 ? DOM_OK : DOM_BAD_GAP;
    return status;
}

enum dom_status dom_placement_study(const struct dom_row *row, const struct dom_compute *compute,
                                    const struct dom_placement *p, struct dom_study *study, size_t *stops)
{
    struct shared s = {.row = row, .compute = compute_or_default(compute), .placement = p};
    enum dom_status status = study_check(row, &s.compute, p);
    if (status != DOM_OK)
        return status;
    s.compute.work = NULL; /* rows may run in parallel and must not share the counters */
    if (s.compute.tol < VERDICT_TOL)
        s.compute.tol = VERDICT_TOL;
    if (stops && !(s.stops = calloc(row->count, sizeof *s.stops)))
        return DOM_NO_MEMORY;
    status = draw_run(row, p, row_count, &s);
    struct dom_study found = {.rows = s.done, .fall = s.fall, .unknown = s.unknown};
    /* after an interrupt, the rows that were run count */
    if ((status == DOM_OK || (status == DOM_INTERRUPTED && found.rows > 0)) &&
        dom_study_interval(&found) == DOM_OK) {
        *study = found;
        for (size_t k = 0; stops && k < row->count; k++)
            stops[k] = s.stops[k];
    }
    free(s.stops);
    return status;
}
