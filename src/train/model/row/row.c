/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Runs a finite row of dominoes. Each domino has its own size, weight and gap. The dominoes behind the head
 * lean on it in a chain. Energies, motion and collisions are computed as for a train, with two differences:
 * - In a train, the same cycle repeats. In a row, each head begins with the energy that the previous head
 * leaves to it.
 * - If a domino detaches, all dominoes that lean on it detach from the chain as well.
 *
 * The unit of length is the height of the current head, the unit of energy is its m g h / 2, and the unit of
 * time is its tau.
 */
#include "row/row.h"
#include "dynamics/dynamics.h"
#include <stdlib.h>

/* Returns tau of domino k in s. */
static real row_tau(const struct row *row, size_t k)
{
    const struct geometry *self = &row->geometry[k];
    return sqrt((real)row->given.domino[k].height / (3 * (real)row->given.g) * (1 + self->d * self->d) *
                self->inertia_factor);
}

/* Returns the unit of energy of domino k, its m g h / 2 in J. */
static real row_unit(const struct row *row, size_t k)
{
    const struct dom_domino *self = &row->given.domino[k];
    return (real)self->mass * (real)row->given.g * (real)self->height / 2;
}

/* Finds the tilt at which the motion of a head ends early, either because its energy is `used_up`, or because
 * friction stops or locks the head. */
static enum dom_status descent_rest(struct descent *d, bool used_up)
{
    struct tilt head;
    struct equation_of_motion equation = {.C = 0};
    if (used_up) {
        d->stops = true;
        return segment_rest(&d->st, &d->to);
    }
    enum dom_status status = geometry_tilt(&d->st.geometry, d->st.hi, &head);
    /* Near the tilt at which friction locks the motion, A tends to 0, so the acceleration (C - B w) / A grows
     * without limit. If C < 0, it slows the head down, and the head stops before this tilt. */
    if (status == DOM_OK)
        status = chain_equation(&d->st.geometry, head, &equation);
    d->stops = equation.C < 0;
    d->locks = !d->stops;
    return status;
}

/* Follows the motion over the segment and prepares the next one. If the head has stopped in an earlier
 * segment, only finds the energy that it would need for this one. */
static enum dom_status descent_move(struct descent *d, struct segment *next)
{
    struct segment *st = &d->st;
    const struct run_options *options = d->run->options;
    enum dom_status status = DOM_OK;
    /* The margin is the energy to spare at the launch of the head. If omegasq at the launch changes, omegasq
     * at the beginning of this segment changes by st->gain times as much. */
    const real margin = (st->start.omegasq - st->barrier.height / st->start.J) / st->gain * d->J0;
    if (margin < d->least_margin || st->locks) {
        d->least_margin = st->locks ? -(real)INFINITY : margin;
        d->theta_m = st->locks ? st->hi : st->barrier.theta_m;
    }
    /* Prepare the next segment now, because descent_rest may replace the solution of the current one. */
    if (!st->locks)
        status = segment_next(st, next);
    if (d->stops || status != DOM_OK)
        return status;
    d->to = st->hi;
    if (margin < 0 || st->locks)
        status = descent_rest(d, margin < 0);
    const bool ends = d->stops || d->locks, moves = st->lo < d->to;
    d->lasts = ends ? REAL_NAN : 0;
    if (status == DOM_OK && moves && (options->forces || !st->end.pushes))
        status = segment_contact(st, d->to, &d->least_force);
    if (status == DOM_OK && options->times && (!ends || options->moves)) {
        struct clock *clock = &d->run->clock;
        status = clock_begin(clock, st, d->to, d->stops, st->geometry.tol);
        d->lasts = status == DOM_OK ? clock_time(clock, d->to) : REAL_NAN;
    }
    if (status == DOM_NO_MARGIN) /* then the time is NaN */
        status = DOM_OK;
    if (status == DOM_OK && moves && options->moves)
        status = options->moves(d->run, d);
    if (!ends) {
        d->climbed += st->end.dH;
        d->time += d->lasts;
    }
    return status;
}

/* Computes the motion of the head up to the next tilt at which dominoes detach, or to its end. */
static enum dom_status descent_segment(struct descent *d, real end)
{
    struct segment *st = &d->st, next;
    const struct run_options *options = d->run->options;
    st->geometry.n = d->moving;
    st->hi = end;
    enum dom_status status = segment_cut(st, &d->moving);
    if (status == DOM_OK)
        status = segment_begin(st);
    const bool moves = st->locks || st->lo < st->hi;
    if (status == DOM_OK && moves)
        status = descent_move(d, &next);
    if (status == DOM_OK && !d->stops && !d->locks && options->detaches && d->moving < st->geometry.n)
        status = options->detaches(d->run, d);
    if (status == DOM_OK && moves && !st->locks)
        *st = next;
    return status;
}

/* Runs head k from its first tilt to its last, and stores the final state in *d, but no verdict. */
static enum dom_status row_descend(struct run *run, size_t k, struct descent *d, struct dom_fall *fall)
{
    const struct geometry *self = &run->row->geometry[k];
    const real unit = row_unit(run->row, k), tau = row_tau(run->row, k), end = tilt_angle(self->c),
               before = run->carried;
    const size_t moving = run->moving;
    struct sums at = {0};
    *d = (struct descent){.run = run,
                          .head = k,
                          .begins = run->time,
                          .tau = tau,
                          .st = {.geometry = *self,
                                 .lo = self->lean,
                                 .start = {.from = geometry_rest(self), .omegasq = run->omegasq},
                                 .summed = moving,
                                 .gain = 1,
                                 .inertia_ratio = run->inertia_ratio},
                          .moving = moving,
                          .least_margin = (real)INFINITY,
                          .least_force = (real)INFINITY};
    d->st.geometry.n = moving;
    enum dom_status status = chain_sum(&d->st.geometry, d->st.start.from, false, &at);
    const real kinetic = at.J * run->omegasq;
    /* if the head touches the next domino from the start, there is no segment, and these values remain */
    d->J0 = d->st.start.J = at.J;
    d->st.start.kinetic = kinetic;
    while (status == DOM_OK && d->st.lo < end && !d->st.locks)
        status = descent_segment(d, end);
    if (status != DOM_OK)
        return status;
    const bool ends = d->stops || d->locks;
    run->moving = d->moving;
    run->carried = d->st.start.kinetic * unit;
    *fall = (struct dom_fall){.domino = k + 1,
                              .time = d->begins,
                              .duration = run->options->times && !ends ? d->time * tau : REAL_NAN,
                              .omega = sqrt(run->omegasq) / tau,
                              .kinetic = kinetic * unit,
                              .margin = fmin(d->least_margin, kinetic) * unit,
                              .theta_m = d->theta_m,
                              .theta = ends ? d->to : end,
                              .moving = moving};
    fall->barrier = fall->kinetic - fall->margin;
    fall->lost = k > 0 ? before - fall->kinetic : 0;
    fall->friction_work = ends ? REAL_NAN
                          : self->conservative
                              ? 0
                              : fmax((real)fall->kinetic - d->climbed * unit - run->carried, 0);
    return DOM_OK;
}

/* Runs a first domino that is tipped over its edge and let go. When it hits the next domino, its kinetic
 * energy is the potential energy that it has lost (9; b5). */
static enum dom_status tip_run(struct run *run, struct descent *d, struct dom_fall *fall)
{
    const struct geometry *geometry = &run->row->geometry[0];
    const struct tilt top = tilt_half(geometry_half_u(geometry));
    const real unit = row_unit(run->row, 0), theta_u = geometry_theta_u(geometry),
               hit = tilt_angle(geometry->c), J = geometry_inertia(geometry, geometry->c);
    const bool tips = geometry_lift(geometry, geometry->c) < 0, alone = geometry->drag == 0;
    real omegasq = tips ? geometry_tipped_omegasq(geometry) : 0;
    const real released = J * omegasq * unit,
               barrier = geometry->lean == 0
                             ? geometry_rise_u(geometry)
                             : geometry->steepest - geometry_height(geometry, geometry_rest(geometry));
    enum dom_status status = DOM_OK;
    *d = (struct descent){.run = run,
                          .tau = row_tau(run->row, 0),
                          .st = {.geometry = *geometry,
                                 .lo = theta_u,
                                 .hi = hit,
                                 .start = {.from = top, .J = geometry_inertia(geometry, top)},
                                 .gain = 1},
                          .to = hit};
    if (alone) /* the first domino has no follower */
        d->st.geometry.conservative = true;
    else if (tips)
        status = dynamics_tipped(geometry, &omegasq);
    if (status == DOM_OK && run->options->moves)
        status = run->options->moves(run, d);
    d->st.start = (struct start){.from = geometry->c, .J = J, .omegasq = omegasq};
    run->carried = J * omegasq * unit;
    run->verdict.end = tips ? DOM_ROW_FALLS : DOM_ROW_LEANS;
    *fall = (struct dom_fall){.domino = 1,
                              .time = REAL_NAN,
                              .duration = REAL_NAN,
                              .kinetic = barrier * unit,
                              .barrier = barrier * unit,
                              .friction_work = alone ? 0 : released - run->carried,
                              .theta_m = theta_u,
                              .theta = hit,
                              .moving = 1};
    return status;
}

/*
 * Computes the collision of head k with domino k + 1, which then becomes the head. The arguments *at and
 * *hitting are the state and the geometry of head k at the hit. If the fall ends here, sets run->verdict.end.
 */
static enum dom_status row_hit(struct run *run, size_t k, const struct geometry *hitting,
                               const struct start *at)
{
    const struct geometry *geometry = &run->row->geometry[k + 1];
    run->verdict.end = joint_ends(run->row, k);
    if (run->verdict.end != DOM_ROW_FALLS)
        return DOM_OK;
    real inertia_ratio = 0, velocity_ratio;
    enum dom_status status = dynamics_inertia_ratio(geometry, hitting, at->from, at->J, &inertia_ratio);
    if (status == DOM_LOCKS) {
        run->verdict.end = DOM_ROW_LOCKS;
        return DOM_OK;
    }
    velocity_ratio = collision_velocity_ratio(inertia_ratio) / geometry_hit_slope(geometry);
    real slower = row_tau(run->row, k + 1) / row_tau(run->row, k);
    run->inertia_ratio = inertia_ratio;
    run->omegasq = velocity_ratio * velocity_ratio * slower * slower * at->omegasq;
    run->moving++;
    return status;
}

KERNEL_SHARED struct run row_launch(struct row *row, const struct run_options *options)
{
    const real push = row->given.push, omega = isnan(push) ? 0 : push * row_tau(row, 0);
    return (struct run){.row = row,
                        .options = options,
                        .moving = 1,
                        .omegasq = omega * omega,
                        .verdict = {.end = DOM_ROW_FALLS, .spare = (dom_real)INFINITY}};
}

/* A domino that would stop gets this much more energy than it needs if the run must go on. */
#define CARRY_ON (1 + (real)1e-4)

/* Runs head k from the hit, or a first domino from its push. Updates the verdict. */
static enum dom_status row_head(struct run *run, size_t k, struct descent *d, struct dom_fall *fall)
{
    struct dom_verdict *v = &run->verdict;
    const size_t moving = run->moving;
    enum dom_status status = row_descend(run, k, d, fall);
    if (status == DOM_OK && run->options->carries_on && d->stops && !d->locks) {
        struct dom_fall carried;
        run->omegasq = (run->omegasq - d->least_margin / d->J0) * CARRY_ON;
        run->moving = moving;
        status = row_descend(run, k, d, &carried);
    }
    if (status != DOM_OK)
        return status;
    const bool ends = d->stops || d->locks;
    const real spare = fall->barrier > 0 ? fall->margin / fall->barrier : (real)INFINITY;
    if (!ends)
        run->time += fall->duration;
    if (ends || d->least_force < 0)
        v->end = d->least_force < 0                         ? DOM_ROW_PARTS
                 : d->locks                                 ? DOM_ROW_LOCKS
                 : k == 0 && row_releases(&run->row->given) ? DOM_ROW_BACK
                                                            : DOM_ROW_STOPS;
    if (v->end == DOM_ROW_STOPS || v->end == DOM_ROW_BACK)
        v->short_by = -fall->margin;
    else if (fall->margin >= 0 && fall->kinetic > 0 && (v->weakest == 0 || spare < v->spare)) {
        v->weakest = k + 1;
        v->spare = spare;
    }
    return DOM_OK;
}

/* ---- The run ---- */

/* By how many the equal dominoes up to the head must outnumber the longest pass along a chain. */
enum { STEADY_MORE = 2 };

/* The relative change of omegasq over all further heads together must be at most this fraction of the
 * tolerance. */
#define STEADY_SHARE ((real)1 / 64)

/* Returns true if later heads would move like *d, were all dominoes equal. The last `alike` dominoes
 * are equal. */
static bool row_is_steady(const struct run *run, const struct run *before, const struct descent *d,
                          size_t alike)
{
    const struct row *row = run->row;
    const real after = run->omegasq, lambda = d->st.gain * after / d->st.start.omegasq,
               left = fabs(after - before->omegasq) * lambda / (1 - lambda);
    return !run->options->ends && !run->options->detaches &&
           row->compute.work->longest + STEADY_MORE <= alike && run->moving - before->moving <= 1 &&
           lambda < 1 && left <= STEADY_SHARE * row->compute.tol * after;
}

/* In a long sequence of equal dominoes, all heads eventually move alike. From then on, the motion of a head
 * is not computed, but copied from the head before, if the head and the next domino both equal the head
 * before: 10,000 equal dominoes take a tenth of the time. */
KERNEL_SHARED enum dom_status row_falls(struct run *run, size_t k, dom_fall_visit *visit, void *context)
{
    struct row *row = run->row;
    const struct run_options *options = run->options;
    const size_t count = row->given.count;
    struct dom_fall fall;
    /* the number of equal dominoes up to the head, and by how many the number of moving dominoes grew */
    size_t alike = 0, grew = 0;
    for (bool ends = false, steady = false; k < count && !ends && run->verdict.end == DOM_ROW_FALLS; k++) {
        struct descent d;
        struct start at;
        const struct run before = *run;
        const bool last = k + 1 == count, tips = k == 0 && isnan(row->given.push);
        enum dom_status status = dom_interrupted(row->compute.interrupt) ? DOM_INTERRUPTED : DOM_OK;
        if (status != DOM_OK)
            return status;
        alike = k > 0 && row_repeats(&row->given, k) ? alike + 1 : 1;
        run->verdict.domino = k + 1;
        const bool was_steady = steady;
        steady = steady && alike > 1 && !last && row_repeats(&row->given, k + 1);
        if (steady) {
            fall.domino = k + 1;
            fall.moving = run->moving;
            fall.time = run->time;
            run->moving += grew;
            run->time += (real)fall.duration;
            ends = visit && !visit(&fall, context);
            continue;
        }
        /* After steady heads, leaves out the geometry of the dominoes that no later sum along the chain
         * visits: the last one that was filled in equals them, and takes the place of all of them. */
        const size_t visited = row->compute.work->longest + STEADY_MORE;
        if (was_steady && k > row->made + visited) {
            struct geometry *all = &row->geometry[k - visited];
            *all = row->geometry[row->made - 1];
            all->follower = all;
            row->made = k - visited + 1;
        }
        for (; row->made <= (last ? k : k + 1) && status == DOM_OK; row->made++)
            status = row_geometry(row, row->made);
        if (status != DOM_OK)
            return status;
        const bool passes = options->passes && options->passes(run, k, &at);
        if (!passes && options->begins)
            options->begins(run, k);
        if (!passes)
            status = tips ? tip_run(run, &d, &fall) : row_head(run, k, &d, &fall);
        if (status != DOM_OK)
            return status;
        ends = visit && !visit(&fall, context);
        if (!ends && run->verdict.end == DOM_ROW_FALLS && !last)
            status = passes ? row_hit(run, k, &row->geometry[k], &at)
                            : row_hit(run, k, &d.st.geometry, &d.st.start);
        if (status != DOM_OK)
            return status;
        const size_t grows = run->moving - before.moving;
        ends = ends || (!passes && options->ends && options->ends(run, k, &before, &d, &fall));
        steady = !passes && run->verdict.end == DOM_ROW_FALLS && grows == grew &&
                 row_is_steady(run, &before, &d, alike);
        grew = grows;
    }
    return DOM_OK;
}

/* ---- Public ---- */

KERNEL_SHARED enum dom_status row_run(const struct dom_row *given, const struct dom_compute *compute,
                                      const struct run_options *options, dom_fall_visit *visit, void *context,
                                      struct dom_verdict *verdict)
{
    struct row row;
    enum dom_status status = row_begin(given, compute, &row, &verdict->domino);
    if (status == DOM_OK) {
        struct run run = row_launch(&row, options);
        status = row_falls(&run, 0, visit, context);
        if (status == DOM_OK && options->rests)
            status = options->rests(&run);
        run.verdict.seconds = options->times ? run.time : REAL_NAN;
        if (status == DOM_OK)
            *verdict = run.verdict;
        clock_free(&run.clock);
    }
    row_free(&row);
    return status;
}
