/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A row that is run many times, each time with other sizes of a few neighbouring dominoes.
 *
 * The dominoes before the change fall as in the unchanged row, so that a trial begins at the first head that
 * can be affected. A trial may also end early, because a head passes on little of what happened before. As
 * long as the geometry is that of the unchanged row, omegasq of the next head is gain omegasq + offset for
 * every law of motion here, since d omegasq / d omegasq(launch) depends on the geometry alone. Let D be the
 * relative deviation of omegasq from that of the unchanged row. At the next head it becomes lambda D, with
 * lambda = gain omegasq / (omegasq of the next head), which is < 1 if a fall releases energy. The changed
 * dominoes are still in the chain that leans on the head, and change its three numbers `need`, `gain` and
 * `offset`. The change is measured at each head (off). It decays with the slopes of the chain, so that the
 * ratio between two heads gives the sum of all changes still to come.
 *
 * A head goes on if omegasq >= need and no contact force is negative. At each tilt a contact force is linear
 * in omegasq, so that no force is negative on an interval of omegasq. Two runs of the head, one barely fast
 * enough and one FAST times as fast, show how far that interval reaches. From the end of the row backwards
 * this gives the deviations (below and above) that leave the verdict of the unchanged row as it is: half of
 * what each head allows, divided by lambda if that is > 1. Once the deviation and the sum of changes together
 * are smaller, no later head can change the verdict, and the trial has the verdict of the unchanged row.
 * Otherwise the trial goes on to the end of the row.
 */
#include "row/run.h"
#include <stdlib.h>

/* The unchanged row at one head, and how far a trial may deviate there. */
struct mark {
    real omegasq, inertia_ratio; /* when the head is hit: see struct run */
    size_t moving;
    real need, gain, offset;
    real below, above; /* relative deviations of omegasq that do not change the verdict */
    real pushes;       /* the smallest contact force from here on, over the weight of the pushed domino */
    bool falls;        /* from here on all dominoes fall; if not, the row ends as the unchanged row does */
};

struct course {
    struct row_request request;
    struct geometry *geometry;
    size_t made; /* number of dominoes that have the geometry of the unchanged row */
    struct mark *mark;
    size_t known; /* number of marks that are known */
    struct dom_verdict verdict;
};

/* How much faster a head is in the run that looks for negative contact forces. */
#define FAST 1000

/* The largest deviations that the changed dominoes themselves may still cause, also as a share of the
 * smallest contact force. With friction the limit is tiny, since nothing measures how close a row is to
 * locking. */
#define LEFT_MOST         ((real)0.01)
#define LEFT_FORCE        ((real)0.1)
#define LEFT_MOST_LOCKING ((real)1e-6)

/* A difference of fewer tolerances than this is noise. */
#define NOISE 64

/* Differences decay if the ratio of each to the one before is at most this. */
#define DECAYS ((real)0.9)

/* Returns the smallest contact force if head k has another omegasq, or a negative number if the row ends
 * there. */
static real least_force(const struct run *run, size_t k, real omegasq)
{
    struct run other = *run;
    struct descent d;
    struct dom_fall fall = {.domino = k + 1};
    other.omegasq = omegasq;
    bool ends = row_descend(&other, k, &d, &fall) != DOM_OK || d.stops || d.locks;
    return ends ? -1 : d.least_force;
}

/* Returns the numbers of head k from the run `before`, when head k was hit, and `after`, when the next head
 * was hit. */
static struct mark mark_of(const struct run *before, const struct run *after, size_t k,
                           const struct descent *d)
{
    bool tips = k == 0 && isnan(before->request->push), last = k + 1 == before->request->count;
    struct mark m = {
        .omegasq = before->omegasq, .inertia_ratio = before->inertia_ratio, .moving = before->moving};
    m.pushes = (real)INFINITY;
    if (tips) {
        m.offset = after->omegasq;
        return m;
    }
    m.pushes = d->least_force;
    m.need = d->least_margin < (real)INFINITY ? fmax(before->omegasq - d->least_margin / d->J0, 0) : 0;
    if (!last && after->verdict.end == DOM_ROW_FALLS) {
        real slower = block_of(before->request, k + 1).tau / block_of(before->request, k).tau,
             kept = collision_velocity_ratio(after->inertia_ratio) * slower /
                    geometry_hit_slope(&after->geometry[k + 1]);
        m.gain = kept * kept * d->st.gain;
        m.offset = after->omegasq - m.gain * before->omegasq;
    }
    return m;
}

/* Finds how far omegasq of a head that goes on may deviate, as far as this head alone decides. */
static void mark_local(const struct run *before, size_t k, struct mark *m)
{
    if (k == 0 && isnan(before->request->push))
        return;
    real low = m->need + (m->omegasq - m->need) / FAST;
    real slow = least_force(before, k, low), fast = least_force(before, k, FAST * m->omegasq);
    m->below = slow >= 0 ? (1 - low / m->omegasq) / 2 : 0;
    m->above = fast >= 0 ? (real)(FAST - 1) / 2 : 0;
    m->pushes = fmin(m->pushes, slow >= 0 ? slow : m->pushes);
    m->pushes = fmin(m->pushes, fast >= 0 ? fast : m->pushes);
}

/* Lowers the deviations of marks from ... to - 1 to what the marks after each of them allow. */
static void marks_join(struct mark *mark, size_t from, size_t to, bool falls)
{
    for (size_t k = to; k-- > from;) {
        struct mark *m = &mark[k];
        m->falls = falls;
        if (k + 1 == to)
            continue;
        real lambda = fmax(m->gain * m->omegasq / m[1].omegasq, 1);
        m->below = fmin(falls ? m->below : (real)INFINITY, m[1].below / lambda);
        m->above = fmin(falls ? m->above : (real)INFINITY, m[1].above / lambda);
        m->pushes = fmin(m->pushes, m[1].pushes);
    }
}

/* Sets how far a row that ends at mark m may deviate and still end there in the same way. */
static void mark_end(struct mark *m, enum dom_row_end end)
{
    bool reach = end == DOM_ROW_MISSES || end == DOM_ROW_PASSES; /* of sizes alone */
    m->below = reach || end == DOM_ROW_STOPS ? (real)INFINITY : 0;
    m->above = reach ? (real)INFINITY : end == DOM_ROW_STOPS ? (m->need / m->omegasq - 1) / 2 : 0;
}

/* Returns true if the heads after k cannot change the verdict. *off has the change of the numbers at the head
 * before, or NaN, and gets that at head k. */
static bool settled(const struct course *course, size_t k, const struct run *before, const struct run *after,
                    const struct descent *d, real *off)
{
    const struct mark self = mark_of(before, after, k, d), *m = &course->mark[k], *next = m + 1;
    real last = *off, w = before->omegasq, by = after->omegasq / next->omegasq - 1;
    bool conservative = course->geometry[0].dynamics->conservative;
    *off = fabs(self.need - m->need) / w +
           fabs(after->omegasq - (m->gain * w + m->offset)) / (self.gain * w) + fabs(self.gain / m->gain - 1);
    real ratio = *off / last, left = *off;
    if (!(*off <= NOISE * (real)course->request.tol))
        left = ratio <= DECAYS ? *off / (1 - ratio) : (real)INFINITY;
    real most = conservative ? LEFT_MOST : LEFT_MOST_LOCKING;
    if (!(left <= (next->falls ? fmin(most, LEFT_FORCE * next->pushes) : most)))
        return false;
    left *= 1 + fabs(by);
    return left - by <= next->below && left + by <= next->above && left <= fmin(next->below, next->above);
}

/*
 * Runs the row from head `from` on. Heads after `last` have the sizes of the unchanged row. A row that gets
 * farther than all rows before leaves marks at its heads.
 */
static enum dom_status course_run(struct course *c, size_t from, size_t last, struct dom_verdict *verdict)
{
    const size_t count = c->request.count;
    struct run run = {.request = &c->request,
                      .geometry = c->geometry,
                      .forces = c->known < count, /* for marks */
                      .verdict = {.end = DOM_ROW_FALLS, .spare = (dom_real)INFINITY}};
    real off = REAL_NAN;
    row_launch(&run);
    if (from > 0) {
        run.omegasq = c->mark[from].omegasq;
        run.inertia_ratio = c->mark[from].inertia_ratio;
        run.moving = c->mark[from].moving;
    }
    c->made = from;
    enum dom_status status = c->known > 0 ? row_geometry(&c->request, from, c->geometry) : DOM_OK;
    size_t k = from;
    for (; status == DOM_OK && k < count && run.verdict.end == DOM_ROW_FALLS; k++) {
        struct descent d;
        struct dom_fall fall;
        const struct run before = run;
        status = row_head(&run, k, &d, &fall);
        if (status == DOM_OK && run.verdict.end == DOM_ROW_FALLS && k + 1 < count) {
            status = c->known > 0 ? row_geometry(&c->request, k + 1, c->geometry) : DOM_OK;
            if (status == DOM_OK)
                status = row_hit(&run, k, &d.st.geometry, &d.st.start);
        }
        if (status != DOM_OK)
            break;
        if (run.verdict.end == DOM_ROW_STOPS && c->known > 0)
            run.verdict.spare = fall.margin / fall.barrier;
        if (k >= c->known) {
            c->mark[k] = mark_of(&before, &run, k, &d);
            if (run.verdict.end == DOM_ROW_FALLS)
                mark_local(&before, k, &c->mark[k]);
        } else if (run.verdict.end == DOM_ROW_FALLS && k > last && k + 1 < c->known &&
                   settled(c, k, &before, &run, &d, &off)) {
            *verdict = run.verdict;
            verdict->end = c->mark[k + 1].falls ? DOM_ROW_FALLS : c->verdict.end;
            return DOM_OK;
        }
    }
    if (status == DOM_OK && run.verdict.end == DOM_ROW_FALLS && c->known < count) {
        marks_join(c->mark, c->known, count, true);
        c->known = count;
    }
    *verdict = run.verdict;
    return status;
}

KERNEL enum dom_status row_course(const struct row_request *request, struct course **course,
                                  struct dom_verdict *verdict)
{
    *course = NULL;
    enum dom_status status = row_check(request, &verdict->domino);
    if (status != DOM_OK)
        return status;
    struct course *c = calloc(1, sizeof *c);
    if (!c)
        return DOM_NO_MEMORY;
    c->request = *request;
    c->geometry = malloc(request->count * sizeof *c->geometry);
    c->mark = calloc(request->count, sizeof *c->mark);
    status = c->geometry && c->mark ? DOM_OK : DOM_NO_MEMORY;
    if (c->geometry)
        c->geometry[0] = (struct geometry){.dynamics = &energy_balance};
    if (status == DOM_OK)
        status = row_make(request, request->count, c->geometry);
    if (status == DOM_OK)
        status = course_run(c, 0, 0, &c->verdict);
    c->made = request->count;
    if (status == DOM_OK && c->verdict.end != DOM_ROW_FALLS) {
        c->known = c->verdict.domino;
        mark_end(&c->mark[c->known - 1], c->verdict.end);
        marks_join(c->mark, 0, c->known, false);
    }
    *course = c;
    if (status == DOM_OK)
        *verdict = c->verdict;
    return status;
}

KERNEL enum dom_status row_again(struct course *c, const struct dom_domino *domino, size_t first, size_t last,
                                 struct dom_verdict *verdict)
{
    const size_t from = first > 0 ? first - 1 : 0;
    enum dom_status status = DOM_OK;
    *verdict = c->verdict;
    c->request.domino = domino;
    for (size_t k = first; k <= last && status == DOM_OK; k++)
        status = row_domino_check(&c->request, k);
    if (c->verdict.end != DOM_ROW_FALLS && from >= c->verdict.domino) /* the row ends before the change */
        return status;
    for (; c->made < from && status == DOM_OK; c->made++)
        status = row_geometry(&c->request, c->made, c->geometry);
    return status == DOM_OK ? course_run(c, from, last + 1, verdict) : status;
}

KERNEL enum dom_status row_course_end(struct course *c)
{
    if (c && c->geometry)
        dynamics_end(&c->geometry[0]);
    if (c) {
        free(c->geometry);
        free(c->mark);
    }
    free(c);
    return DOM_OK;
}
