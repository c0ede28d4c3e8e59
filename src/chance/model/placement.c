/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs many rows with random errors, in batches that may run in parallel. */
#include "chance/model/draw.h"
#include "rows/model/study.h"
#include <stdatomic.h>
#include <stdlib.h>

/* Whether a row falls depends only on the signs of its margins, so their values need not be accurate. A
 * smaller tolerance would change about one verdict in a billion. */
#define VERDICT_TOL 1e-9

/* The data that all batches of a study share. */
struct shared {
    const struct dom_row *row;
    struct dom_compute compute;
    const struct dom_placement *placement;
    atomic_int status; /* DOM_OK, or the status of the first batch that failed */
    atomic_size_t done, fall, unknown;
    atomic_size_t *stops; /* how many falls ended at each domino, or NULL if not requested */
};

/* Runs random row number i and adds the result to the counts. `study` is NULL if an engine runs the rows. */
static enum dom_status row_count(struct shared *s, struct draw *draw, struct study *study, size_t i)
{
    struct dom_verdict verdict;
    draw_row(draw, s->row, s->placement, i);
    const enum dom_status status = study ? row_study(study, &draw->row, 0, s->row->count - 1, &verdict)
                                         : dom_row_run(&draw->row, &s->compute, false, NULL, NULL, &verdict);
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

/* A dom_task that runs batch number `index` of the rows, unless another batch has failed. */
static void batch_run(size_t index, void *context)
{
    struct shared *s = context;
    const struct dom_placement *p = s->placement;
    if (atomic_load(&s->status) != DOM_OK)
        return;
    struct draw draw;
    struct study *study = NULL;
    enum dom_status status = draw_begin(&draw, s->row);
    if (status == DOM_OK && !s->row->engine)
        status = row_study_begin(s->row, &s->compute, &study, NULL);
    for (size_t i = index * BATCH; i < p->rows && i < (index + 1) * BATCH && status == DOM_OK; i++)
        status = row_count(s, &draw, study, p->first + i);
    int none = DOM_OK;
    if (status != DOM_OK)
        atomic_compare_exchange_strong(&s->status, &none, (int)status);
    row_study_end(study);
    draw_end(&draw);
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

/* Runs the study. Copies its counts if it has ended or was interrupted. */
static enum dom_status study_run(struct shared *s, struct dom_study *study, size_t *stops)
{
    const struct dom_placement *p = s->placement;
    enum dom_status status = placement_run(p, batch_run, s);
    if (s->status != DOM_OK)
        status = (enum dom_status)s->status;
    else if (status == DOM_OK && s->done < p->rows) /* the thread pool has skipped some batches */
        status = DOM_INTERRUPTED;
    struct dom_study found = {.rows = s->done, .fall = s->fall, .unknown = s->unknown};
    const bool partial = status == DOM_INTERRUPTED && found.rows > 0;
    const enum dom_status counted = status == DOM_OK || partial ? dom_study_interval(&found) : status;
    if (counted == DOM_OK)
        *study = found;
    for (size_t k = 0; stops && counted == DOM_OK && k < s->row->count; k++)
        stops[k] = s->stops[k];
    return partial ? status : counted;
}

enum dom_status dom_placement_study(const struct dom_row *row, const struct dom_compute *compute,
                                    const struct dom_placement *p, struct dom_study *study, size_t *stops)
{
    struct shared shared = {.row = row, .compute = compute_or_default(compute), .placement = p};
    enum dom_status status = study_check(row, &shared.compute, p);
    if (status != DOM_OK)
        return status;
    shared.compute.work = NULL; /* rows may run in parallel and must not share the counters */
    if (shared.compute.tol < VERDICT_TOL)
        shared.compute.tol = VERDICT_TOL;
    if (stops && !(shared.stops = calloc(row->count, sizeof *shared.stops)))
        return DOM_NO_MEMORY;
    status = study_run(&shared, study, stops);
    free(shared.stops);
    return status;
}
