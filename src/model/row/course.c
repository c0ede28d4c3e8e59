/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Runs a row many times, each time with a change of a few neighbouring dominoes. Such a run is called a
 * trial. A trial is fast because it leaves out most of the row. It begins at the first head that the change
 * can affect, and ends as soon as the change can no longer affect the verdict. This happens soon, because the
 * effects of the change decrease from head to head. There are two effects.
 *
 * First, the head's omegasq deviates from its value in the unchanged row. Let D be the relative deviation.
 * The equation of motion is linear in omegasq. So for a head whose geometry is unchanged,
 *
 *     omegasq of the next head = gain * omegasq + offset.
 *
 * At the next head, the relative deviation is lambda D, where lambda = gain * omegasq / (omegasq of the next
 * head). If a fall releases energy, lambda < 1.
 *
 * Second, the changed dominoes lean on the next heads, and so they change the numbers `need`, `gain` and
 * `offset` of these heads. The size of this change (`off`) is computed at each head. It decays like a
 * geometric series from head to head. So its values at two successive heads give an estimate of the sum of
 * all further changes.
 *
 * A head keeps falling if omegasq >= need and no contact force is negative. Contact forces are linear in
 * omegasq. So if no force is negative at two values of omegasq, none is negative between these two values.
 * For this reason, each head of the unchanged row is run twice more: once with an omegasq that is barely
 * enough, and once with an omegasq that is FAST times as large as in the unchanged row.
 *
 * These runs give the limits `below` and `above` of each head. As long as omegasq deviates by less than these
 * limits, the verdict does not change. If the row falls, the limits are found from the last head to the
 * first, as
 *
 *     min(half the limit of the head itself, limit of the next head / max(lambda, 1)).
 *
 * The limits of a head are stored in its mark, together with `need`, `gain` and `offset`. The trial ends as
 * soon as D and all further changes together are within the limits. Its verdict is then the verdict on the
 * unchanged row. If the unchanged row stops, the heads after the stop have no marks until a trial falls to
 * the end of the row. This trial then makes their marks, and takes the place of the unchanged row for them.
 */
#include "row/run.h"
#include <stdlib.h>

/* Describes the unchanged row at the instant when a head is hit: its state, and how far this state may
 * deviate without changing the verdict. */
struct mark {
    real omegasq, inertia_ratio; /* values of the members of struct run when the head is hit */
    size_t moving;
    real need, gain, offset;
    real below, above; /* allowed deviations of omegasq downwards and upwards, as fractions of omegasq */
    /* the smallest contact force of this and all later heads, divided by the weight of the pushed domino */
    real pushes;
    bool falls; /* true if this domino and all later ones fall */
};

struct course {
    struct row_request request;
    struct geometry *geometry;
    size_t made; /* the first `made` elements of `geometry` describe the unchanged row */
    struct mark *mark;
    size_t known; /* number of marks that are filled in */
    struct dom_verdict verdict;
};

/*
 * The contact forces of a head are checked at two values of omegasq, one far above and one just above `need`.
 * The upper value is FAST times the actual omegasq. The lower value exceeds `need` by 1/FAST of the actual
 * excess.
 */
#define FAST 1000

/*
 * A trial may end early only if the changes that are still to come are small. Their sum must be below
 * LEFT_MOST and, if all later dominoes fall, also below LEFT_FORCE times the smallest contact force. With
 * friction, the program does not measure how close the row is to locking. So the sum must then be below the
 * tiny LEFT_MOST_LOCKING instead of LEFT_MOST.
 */
#define LEFT_MOST         ((real)0.01)
#define LEFT_FORCE        ((real)0.1)
#define LEFT_MOST_LOCKING ((real)1e-6)

/* A change below NOISE times the tolerance counts as a rounding error. */
#define NOISE 64

/* If the change at each head is at most this fraction of the change at the previous head, the changes count
 * as decaying. */
#define DECAYS ((real)0.9)

/* Runs head k as if it had been hit with this omegasq. Returns the smallest contact force, or -1 if the head
 * does not complete its motion or the run fails. */
static real least_force(const struct run *run, size_t k, real omegasq)
{
    struct run other = *run;
    struct descent d;
    struct dom_fall fall = {.domino = k + 1};
    other.omegasq = omegasq;
    bool ends = row_descend(&other, k, &d, &fall) != DOM_OK || d.stops || d.locks;
    return ends ? -1 : d.least_force;
}

/* Makes the mark of head k. `before` is the state when head k was hit, and `after` is the state when the next
 * head was hit. */
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

/* Sets the limits `below` and `above` of head k alone: within them, head k falls and no contact force is
 * negative. Later, marks_join reduces them to the limits of the heads after it. */
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

/*
 * Goes back from mark[to - 1] to mark[from]. At each head, sets the limits `below` and `above` so that no
 * deviation within these limits exceeds the limits of a later head. If `falls` is false, the fall ends at
 * head to - 1, and only the limits of this head count. If the fall of a changed row ends at an earlier head,
 * the verdict is the same: the row does not fall.
 */
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

/* Sets the limits `below` and `above` for the head at which the unchanged row stops falling. As long as
 * omegasq is within these limits, a changed row stops falling at the same head, and for the same reason. */
static void mark_end(struct mark *m, enum dom_row_end end)
{
    /* whether a head reaches the next domino depends only on the sizes, not on omegasq */
    bool reach = end == DOM_ROW_MISSES || end == DOM_ROW_PASSES;
    m->below = reach || end == DOM_ROW_STOPS ? (real)INFINITY : 0;
    m->above = reach ? (real)INFINITY : end == DOM_ROW_STOPS ? (m->need / m->omegasq - 1) / 2 : 0;
}

/*
 * Returns true if the heads after k can no longer change the verdict. On entry, *off is the relative change
 * of `need`, `gain` and `offset` at the previous head, or NaN if this change is unknown. On return, *off is
 * the relative change at head k.
 */
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

/* Runs the row from head `from`. Fills in the marks of heads that have none yet. If a change can no longer
 * affect the verdict, the run ends early. It ends at a head after `last`, since only the dominoes after
 * `last` are certain to be unchanged. */
static enum dom_status course_run(struct course *c, size_t from, size_t last, struct dom_verdict *verdict)
{
    const size_t count = c->request.count;
    struct run run = {.request = &c->request,
                      .geometry = c->geometry,
                      .forces = c->known < count, /* a new mark stores the smallest force */
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
    /* the fall ends before it reaches a head that the change can affect */
    if (c->verdict.end != DOM_ROW_FALLS && from >= c->verdict.domino)
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
