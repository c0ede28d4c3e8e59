/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A study runs a row many times. If a few neighbouring dominoes of a planned row are changed, the run begins
 * at the stored state of the first head that the change can affect. It ends as soon as omegasq equals that of
 * the planned row again, because from then on both rows move alike.
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
#include "row/study.h"
#include <stdlib.h>
#include <string.h>

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
    if (!before->geometry[0].conservative)
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

/* The relative tolerance of sums along the chain in a rough run. */
#define ROUGH_TOL ((real)1e-6)

KERNEL bool study_ends(struct run *run, size_t k, const struct run *before, const struct descent *d,
                       const struct dom_fall *fall)
{
    struct study *s = run->study;
    if (!s)
        return false;
    if (!s->mark) {
        const bool tips = k == 0 && before->omegasq == 0, pushes = fabs(d->least_force) > LEAST_CLEAR,
                   sure = fabs((real)fall->margin) > ROUGH_CLEAR * (real)fall->kinetic;
        s->doubt = s->rough && !tips && !(pushes && sure && !d->locks);
        return s->doubt;
    }
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
    const size_t count = s->row.request.count;
    struct run run = {.request = &s->row.request,
                      .geometry = s->row.geometry,
                      .made = s->row.made,
                      .forces = s->mark && s->known < count, /* a mark needs the smallest force */
                      .study = s,
                      .verdict = {.end = DOM_ROW_FALLS, .spare = (dom_real)INFINITY}};
    s->off = (real)INFINITY;
    s->doubt = false;
    row_launch(&run);
    if (k > 0) {
        run.omegasq = s->mark[k].omegasq;
        run.inertia_ratio = s->mark[k].inertia_ratio;
        run.moving = s->mark[k].moving;
    }
    const enum dom_status status = row_falls(&run, k, NULL, NULL);
    s->row.made = run.made;
    *verdict = run.verdict;
    return status;
}

KERNEL enum dom_status study_begin(const struct row_request *request, struct study **study,
                                   struct dom_verdict *verdict)
{
    struct study *s = *study = calloc(1, sizeof *s);
    size_t wrong = 0;
    if (!s)
        return DOM_NO_MEMORY;
    enum dom_status status = row_begin(request, &s->row, verdict ? &verdict->domino : &wrong);
    if (status != DOM_OK || !verdict)
        return status;
    s->row.request.block = NULL; /* dominoes will change */
    s->mark = malloc(request->count * sizeof *s->mark);
    if (!s->mark)
        return DOM_NO_MEMORY;
    status = study_falls(s, 0, verdict);
    s->known = verdict->domino;
    s->verdict = *verdict;
    marks_join(s->mark, 0, s->known);
    return status;
}

/* Runs the planned row with changes of the dominoes `first` to `last`. */
static enum dom_status study_change(struct study *s, size_t first, size_t last, struct dom_verdict *verdict)
{
    const size_t from = first > 0 ? first - 1 : 0, count = s->row.request.count;
    enum dom_status status = DOM_OK;
    *verdict = s->verdict;
    for (size_t k = first; k <= last && status == DOM_OK; k++)
        status = row_domino_check(&s->row.request, k);
    /* the fall ends before it reaches a head that the change can affect */
    if (status != DOM_OK || (s->verdict.end != DOM_ROW_FALLS && from >= s->verdict.domino))
        return status;
    s->last = last + 1;
    s->row.made = s->row.made < from ? s->row.made : from;
    status = study_falls(s, from, verdict);
    s->row.made = s->row.made < from ? s->row.made : from;
    if (status == DOM_OK && verdict->end == DOM_ROW_FALLS && verdict->domino == count && s->known < count) {
        marks_join(s->mark, s->known, count);
        s->known = count;
    }
    return status;
}

/* Runs a random row. If it has friction, first runs it roughly. If the verdict of this run is in doubt, runs
 * the row again, precisely. */
static enum dom_status study_random(struct study *s, struct dom_verdict *verdict)
{
    struct row_request *request = &s->row.request;
    const dom_real tol = request->tol;
    s->quick = true;
    for (size_t k = 0; k < request->count; k++)
        s->quick = s->quick && request->domino[k].lean == 0;
    s->rough = s->quick && dynamics_dissipate(request->effect);
    request->tol = s->rough && tol < (dom_real)ROUGH_TOL ? (dom_real)ROUGH_TOL : tol;
    enum dom_status status = row_read(&s->row, &verdict->domino);
    if (status == DOM_OK)
        status = study_falls(s, 0, verdict);
    request->tol = tol;
    if (status != DOM_OK || !s->doubt)
        return status;
    s->rough = false;
    for (size_t k = 0; k < s->row.made; k++)
        s->row.geometry[k].tol = (real)tol;
    return study_falls(s, 0, verdict);
}

enum dom_status row_study(struct study *s, const struct dom_row *row, size_t first, size_t last,
                          struct dom_verdict *verdict)
{
#define VALUE(effect, member, status) row->member,
    const dom_real effect[] = {DOM_DYNAMICS(VALUE)};
#undef VALUE
    s->row.request.domino = row->domino;
    s->row.request.push = row->push;
    s->row.request.release = row->release;
    memcpy(s->row.request.effect, effect, sizeof effect);
    return s->mark ? study_change(s, first, last, verdict) : study_random(s, verdict);
}

void row_study_end(struct study *s)
{
    if (s) {
        row_free(&s->row);
        free(s->mark);
    }
    free(s);
}
