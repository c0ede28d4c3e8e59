/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Where a segment ends, its barrier, the state at its end, and where a motion that stops comes to rest. */
#include "dynamics/dynamics.h"
#include "motion/motion.h"

/* Returns the tilt of the head at which domino i behind it has the given tilt. */
static struct tilt tilt_of_head(const struct geometry *head, size_t i, struct tilt tilt)
{
    const struct geometry *next = head->follower ? head->follower : head;
    return i == 0 ? tilt : geometry_leader(head, tilt_of_head(next, i - 1, tilt));
}

/* Each pass lowers hi to the tilt at which a domino detaches, until none has detached even earlier. */
KERNEL enum dom_status segment_cut(struct segment *st, size_t *moving)
{
    const struct geometry *geometry = &st->geometry;
    *moving = geometry->n;
    for (;;) {
        struct tilt head;
        enum dom_status status = geometry_tilt(geometry, st->hi, &head);
        if (status != DOM_OK)
            return status;
        struct link k = link_head(geometry, head, geometry->rolls);
        const struct link *link = &k;
        /* The first search ends at a domino whose motion is smaller than the rounding errors. A later search
         * visits all dominoes up to the one that detaches at hi. */
        bool last = false, all = *moving < geometry->n;
        while (!last && ((*moving < geometry->n && link->i < *moving) || link->tilt.x < 0 ||
                         link->tilt.v < link->geometry->leave.v)) {
            last = link->i + 1 >= geometry->n || (!all && link->slope < REAL_EPSILON * REAL_EPSILON);
            if (!last)
                link_on(&k);
        }
        if (last || link->i + 1 >= geometry->n)
            return DOM_OK;
        *moving = link->i + 1;
        const real leaves = tilt_angle(tilt_of_head(geometry, link->i, link->geometry->leave));
        st->hi = fmin(fmax(leaves, st->lo), st->hi);
    }
}

KERNEL enum dom_status segment_begin(struct segment *st)
{
    struct start *start = &st->start;
    struct sums at = {.J = start->J};
    enum dom_status status =
        st->summed == st->geometry.n ? DOM_OK : chain_sum(&st->geometry, start->from, false, &at);
    /* If r s = 1, a domino detaches as soon as the motion begins. It takes no kinetic energy away. So J
     * decreases, and omegasq grows by the same factor. */
    real kept = at.J > 0 && start->J > 0 ? start->J / at.J : 1;
    start->omegasq *= kept;
    st->gain *= kept;
    start->J = at.J;
    st->summed = st->geometry.n;
    start->kinetic = start->J * start->omegasq;
    if (st->geometry.n == 1 && st->geometry.drag == 0)
        st->geometry.conservative = true;
    if (status == DOM_OK && !st->geometry.conservative && st->lo < st->hi)
        status = flow_solve_piece(&st->geometry, start->J, st->lo, &st->hi);
    st->locks = status == DOM_LOCKS;
    status = st->locks ? DOM_OK : status;
    if (status != DOM_OK || !(st->lo < st->hi))
        return status;
    st->barrier = (struct barrier){.edge = {st->lo, st->hi}, .edges = 2};
    return barrier_up_to(&st->geometry, start->from, st->hi, &st->barrier);
}

KERNEL enum dom_status segment_next(struct segment *st, struct segment *next)
{
    struct tilt head;
    real omegasq, gain, u;
    st->status = geometry_tilt(&st->geometry, st->hi, &head);
    if (st->status == DOM_OK)
        st->status = chain_change(&st->geometry, st->start.from, head, PASS_PUSHES, &st->end);
    if (st->status != DOM_OK)
        return st->status;
    const real J = st->end.J;
    if (st->geometry.conservative) {
        omegasq = (st->start.kinetic - st->end.dH) / J;
        gain = st->start.J / J;
    } else {
        flow_at(&st->geometry, st->hi, &gain, &u);
        gain = exp(gain);
        omegasq = gain * (st->start.omegasq - u);
    }
    *next = (struct segment){.geometry = st->geometry,
                             .lo = st->hi,
                             .summed = st->geometry.n,
                             .start = {.from = head, .J = J, .omegasq = omegasq, .kinetic = J * omegasq},
                             .gain = st->gain * gain};
    return st->status;
}

/* Returns the largest energy required up to theta, minus the kinetic energy at the start. */
static real segment_short(real theta, void *context)
{
    struct segment *st = context;
    struct barrier b = st->barrier;
    st->status = barrier_up_to(&st->geometry, st->start.from, theta, &b);
    /* A motion that starts at rest may lose height first. The tilts that it then passes need no energy, so
     * they are not roots. */
    const real kinetic = st->start.omegasq == 0 ? REAL_EPSILON * st->barrier.height : st->start.kinetic;
    return st->status == DOM_OK ? b.height - kinetic : REAL_NAN;
}

KERNEL enum dom_status segment_rest(struct segment *st, real *theta)
{
    const struct geometry *geometry = &st->geometry;
    const real *edge = st->barrier.edge;
    real hi = st->barrier.theta_m, slope = 0;
    if (st->start.omegasq == 0 &&
        (dynamics_slope(geometry, st->start.from, false, &slope) != DOM_OK || slope >= 0)) {
        *theta = st->lo;
        return DOM_OK;
    }
    /* The solution of the motion is as precise as the largest energy in a panel. A stop long before the first
     * panel ends needs a short solution. Up to the stop the required energy is then almost linear. */
    if (!geometry->conservative && dynamics_slope(geometry, st->start.from, true, &slope) == DOM_OK) {
        real close = edge[0] + 4 * st->start.omegasq / slope;
        if (close > edge[0] &&
            close - edge[0] < fmin(edge[1] - edge[0], edge[0] + geometry_finest(geometry)) / 16) {
            const enum dom_status status = flow_solve_piece(geometry, geometry->flow->J0, edge[0], &close);
            if (status != DOM_OK)
                return status;
            hi = close;
        }
    }
    const enum num_status solver = num_root(segment_short, st, edge[0], hi, geometry->tol / 8, theta);
    /* The energy is just enough for the highest point, to within a rounding error: the row rests there. */
    if (solver == NUM_NOT_BRACKETED && st->status == DOM_OK) {
        *theta = hi;
        return DOM_OK;
    }
    return model_status(st->status, solver);
}
