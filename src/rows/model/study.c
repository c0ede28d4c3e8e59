/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A study runs a planned row many times, with changes. If a few neighbouring dominoes of a planned row are
 * changed, the run begins at the stored state of the first head that the change can affect. It ends as soon
 * as omegasq equals that of the planned row again, because from then on both rows move alike.
 *
 * The effects of a change decrease from head to head. The omegasq of a later head differs by the fraction
 * `off`, which a head multiplies by lambda. The changed dominoes still lean on the head, and change its
 * motion by an amount of the same order, which decays as these dominoes come down. So the run ends when `off`
 * is small at two heads in a row: small compared with `clear`, the change of omegasq that could change the
 * verdict on the planned row.
 *
 * If the planned row stops, the heads after the stop have no marks until a changed row falls to the end. That
 * run then makes their marks, and takes the place of the planned row for them.
 */
#include "rows/model/study.h"
#include "dynamics/dynamics.h"
#include "effects/effects.h"
#include "row/row.h"
#include <stdlib.h>

/* The headers of the kernel declare functions that only its own sources define. */
#pragma GCC diagnostic ignored "-Wunused-function"

/* The planned row at the moment when a head is hit: its state, and how clear the verdict is from there on. */
struct mark {
    real omegasq, inertia_ratio; /* values of the members of struct run */
    size_t moving;
    /* the derivative of ln omegasq of the next head with respect to ln omegasq of this head */
    real lambda;
    /* A change of omegasq by less than this fraction can change neither the sign of the margin nor that of a
     * contact force, here and at later heads. */
    real clear;
};

struct study {
    struct row row;    /* between two runs, the geometry that is filled in is that of the planned row */
    struct mark *mark; /* of the planned row, whose first `known` heads have marks */
    size_t known;
    struct dom_verdict verdict;
    /* ---- The current run ---- */
    size_t last; /* index of the last domino that differs from the planned row */
    real off;    /* by which fraction omegasq of the last head differs from the planned one */
};

/* ---- Runs that end early ---- */

/* omegasq counts as equal if it differs by less than this fraction of `clear`. */
#define STUDY_EQUAL ((real)1 / 16)

/* With friction, `clear` is at most this, because it does not tell how close the row is to locking. */
#define STUDY_LOCKING ((real)1e-3)

/* Makes the mark of head k, with the part of `clear` that concerns this head alone. */
static struct mark mark_of(const struct run *before, size_t k, const struct descent *d,
                           const struct dom_fall *fall)
{
    struct mark m = {.omegasq = before->omegasq,
                     .inertia_ratio = before->inertia_ratio,
                     .moving = before->moving,
                     .clear = 1};
    if (k == 0 && before->omegasq == 0) /* the first domino starts at rest, and has no margin */
        return m;
    m.lambda = d->st.gain * before->omegasq / d->st.start.omegasq;
    m.clear = fmin(fabs((real)fall->margin / (real)fall->kinetic), fabs(d->least_force));
    if (!before->row->geometry[0].conservative)
        m.clear = d->locks ? 0 : fmin(m.clear, STUDY_LOCKING);
    return m;
}

/* Goes back from mark[to - 1] to mark[from], so that `clear` accounts for all later heads, too. */
static void marks_join(struct mark *mark, size_t from, size_t to)
{
    for (size_t k = to; k-- > from;)
        if (k + 1 < to)
            mark[k].clear = fmin(mark[k].clear, mark[k + 1].clear / fmax(mark[k].lambda, 1));
}

/* Called after a head of a changed row. Returns true if the row moves as planned again. */
static bool settles(struct study *s, struct run *run, size_t k)
{
    if (run->verdict.end != DOM_ROW_FALLS || k + 1 >= s->known)
        return false;
    const struct mark *next = &s->mark[k + 1];
    const real last = s->off;
    s->off = fabs(run->omegasq / next->omegasq - 1);
    if (!(k > s->last && fmax(last, s->off) <= STUDY_EQUAL * next->clear))
        return false;
    if (k + 1 < s->verdict.domino)
        run->verdict.end = s->verdict.end;
    return true;
}

static bool study_ends(struct run *run, size_t k, const struct run *before, const struct descent *d,
                       const struct dom_fall *fall)
{
    struct study *s = run->options->context;
    if (run->verdict.end == DOM_ROW_STOPS)
        run->verdict.spare = fall->margin / fall->barrier;
    if (k < s->known)
        return settles(s, run, k);
    s->mark[k] = mark_of(before, k, d, fall);
    return false;
}

/* Runs the row from head k on. */
static enum dom_status study_falls(struct study *s, size_t k, struct dom_verdict *verdict)
{
    const struct run_options options = {.forces = s->known <
                                                  s->row.given.count, /* a mark needs the smallest force */
                                        .every = true,
                                        .ends = study_ends,
                                        .context = s};
    struct run run = row_launch(&s->row, &options);
    s->off = (real)INFINITY;
    if (k > 0) {
        run.omegasq = s->mark[k].omegasq;
        run.inertia_ratio = s->mark[k].inertia_ratio;
        run.moving = s->mark[k].moving;
    }
    const enum dom_status status = row_falls(&run, k, NULL, NULL);
    *verdict = run.verdict;
    return status;
}

enum dom_status row_study_begin(const struct dom_row *row, const struct dom_compute *compute,
                                struct study **study, struct dom_verdict *verdict)
{
    struct study *s = *study = calloc(1, sizeof *s);
    enum dom_status status = s ? row_begin(row, compute, &s->row, &verdict->domino) : DOM_NO_MEMORY;
    if (status == DOM_OK && !(s->mark = malloc(row->count * sizeof *s->mark)))
        status = DOM_NO_MEMORY;
    if (status == DOM_OK)
        status = study_falls(s, 0, verdict);
    if (status == DOM_OK) {
        s->known = verdict->domino;
        s->verdict = *verdict;
        marks_join(s->mark, 0, s->known);
    }
    return status;
}

enum dom_status row_study(struct study *s, const struct dom_row *row, size_t first, size_t last,
                          struct dom_verdict *verdict)
{
    const size_t from = first > 0 ? first - 1 : 0, count = row->count;
    enum dom_status status = DOM_OK;
    s->row.given = *row;
    *verdict = s->verdict;
    for (size_t k = first; k <= last && status == DOM_OK; k++)
        status = row_domino_check(&s->row.given, k);
    /* the fall ends before it reaches a head that the change can affect */
    if (status != DOM_OK || (s->verdict.end != DOM_ROW_FALLS && from >= s->verdict.domino))
        return status;
    s->last = last + 1;
    s->row.made = s->row.made < from ? s->row.made : from;
    if (from == 0) { /* the launch needs the first domino */
        status = row_geometry(&s->row, 0);
        s->row.made = 1;
    }
    if (status == DOM_OK)
        status = study_falls(s, from, verdict);
    s->row.made = s->row.made < from ? s->row.made : from;
    if (status == DOM_OK && verdict->end == DOM_ROW_FALLS && verdict->domino == count && s->known < count) {
        marks_join(s->mark, s->known, count);
        s->known = count;
    }
    return status;
}

void row_study_end(struct study *s)
{
    if (s) {
        row_free(&s->row);
        free(s->mark);
    }
    free(s);
}
