/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "motion/cycle.h"

/* DOM_NO_FUEL if the cycle does not begin. */
static enum dom_status cycle_begin(const struct dom_train *train, struct flow *flow, struct cycle *cycle,
                                   bool errors)
{
    enum dom_status status = lean_make(train, &cycle->lean);
    if (status == DOM_OK)
        lean_flow(&cycle->lean, flow);
    if (status == DOM_OK)
        status =
            collision_launch(&cycle->lean, train->fuel, &cycle->launch, errors ? &cycle->launch_error : NULL);
    return status != DOM_OK || cycle->launch.fuel > 0 ? status : DOM_NO_FUEL;
}

/* The barrier over [0, end]. */
static enum dom_status cycle_climb(struct cycle *cycle, real end)
{
    return barrier_search(&cycle->lean, end, cycle->lean.tol / 8, &cycle->barrier);
}

/* The cycle from its beginning to theta_c, with its barrier. */
KERNEL enum dom_status cycle_whole(const struct dom_train *train, struct flow *flow, struct cycle *cycle,
                                   bool errors)
{
    struct lean *g = &cycle->lean;
    cycle->status = DOM_OK;
    enum dom_status status = lean_make(train, g);
    if (status == DOM_OK)
        lean_flow(g, flow);
    if (status == DOM_OK)
        status = barrier_balance(g, train->fuel, tilt_angle(g->c), &cycle->launch,
                                 errors ? &cycle->launch_error : NULL, &cycle->barrier);
    return status != DOM_OK || cycle->launch.fuel > 0 ? status : DOM_NO_FUEL;
}

/* (c3), solved for tau^2 omega(theta)^2. */
KERNEL enum dom_status cycle_speed(const struct cycle *cycle, real theta, real *omegasq, real *error)
{
    struct tilt head;
    struct sums at = {0}, e = {0};
    enum dom_status status = lean_tilt(&cycle->lean, theta, &head);
    if (status == DOM_OK && cycle->lean.mu > 0) {
        *omegasq = friction_omegasq(&cycle->lean, cycle->launch.omegasq, theta);
        if (error)
            *error = REAL_NAN;
        return DOM_OK;
    }
    if (status == DOM_OK)
        status = chain_rise(&cycle->lean, head, &at, error ? &e : NULL);
    if (status != DOM_OK)
        return status;
    *omegasq = (cycle->launch.kinetic - at.dH) / at.J;
    if (error)
        *error = (cycle->launch_error.kinetic + e.dH + fabs(*omegasq) * (e.J + 3 * UNIT * at.J)) / at.J;
    return DOM_OK;
}

KERNEL enum dom_status cycle_omegasq(const struct dom_train *train, dom_real theta_, dom_real *omegasq,
                                     dom_real *error)
{
    struct cycle cycle;
    struct flow flow;
    struct tilt head;
    real theta = (real)theta_, w = REAL_NAN, w_error = 0;
    *omegasq = DOM_NAN;
    enum dom_status status = cycle_begin(train, &flow, &cycle, error != NULL);
    if (status != DOM_OK && status != DOM_NO_FUEL)
        return status;
    enum dom_status tilt_status = lean_tilt(&cycle.lean, theta, &head);
    if (tilt_status != DOM_OK)
        return tilt_status;
    if (status == DOM_OK)
        status = cycle_climb(&cycle, theta);
    if (status == DOM_OK && cycle.barrier.height > cycle.launch.kinetic)
        status = DOM_STOPS;
    if (status == DOM_OK)
        status = cycle_speed(&cycle, theta, &w, error ? &w_error : NULL);
    real asked = cycle.lean.tol;
    if (status == DOM_OK)
        cycle.lean.tol = balance_tol(asked, w, cycle.launch.omegasq);
    if (cycle.lean.tol < asked / 4) {
        status =
            collision_launch(&cycle.lean, train->fuel, &cycle.launch, error ? &cycle.launch_error : NULL);
        if (status == DOM_OK)
            status = cycle_speed(&cycle, theta, &w, error ? &w_error : NULL);
    }
    *omegasq = w;
    if (error)
        *error = w_error;
    return status;
}

/* How much of the kinetic energy the highest point up to theta has used; it never falls with theta. */
static real energy_short(real theta, void *context)
{
    struct cycle *cycle = context;
    cycle->status = cycle_climb(cycle, theta);
    return cycle->status == DOM_OK ? cycle->barrier.height - cycle->launch.kinetic : REAL_NAN;
}

/*
 * The tilt where the energy is used up, of a cycle that stops; on a copy, since the search climbs anew.  With
 * friction the flow may not reach farther than that any more.
 */
KERNEL enum dom_status cycle_rest(struct cycle cycle, real *theta)
{
    const struct barrier *b = &cycle.barrier;
    real lo = b->edge[0], hi = b->theta_m;
    enum dom_status status = DOM_OK;
    if (cycle.lean.mu > 0 && hi <= b->edge[1]) /* nobody falls off before */
        status = friction_flow_spent(&cycle.lean, standing, lo, cycle.launch.omegasq, &hi);
    if (status != DOM_OK)
        return status;
    enum num_status solver = num_root(energy_short, &cycle, lo, hi, cycle.lean.tol / 8, theta);
    return model_status(cycle.status, solver);
}

/* Of the tilt where the energy is used up: what is left of it and may be wrong with it, over its slope. */
static enum dom_status stop_error(const struct cycle *cycle, real theta, dom_real *error)
{
    struct tilt head;
    struct sums at, e;
    enum dom_status status = lean_tilt(&cycle->lean, theta, &head);
    if (status == DOM_OK)
        status = chain_rise(&cycle->lean, head, &at, &e);
    if (status == DOM_OK)
        *error = (fabs(cycle->launch.kinetic - at.dH) + cycle->launch_error.kinetic + e.dH) / fabs(at.H1) *
                     (1 + 4 * cycle->lean.tol) + /* to second order in a loose tolerance */
                 4 * UNIT * theta;
    return status;
}

KERNEL enum dom_status cycle_stop(const struct dom_train *train, dom_real *theta, dom_real *error)
{
    struct cycle cycle;
    struct flow flow;
    real stop;
    enum dom_status status = cycle_whole(train, &flow, &cycle, error != NULL);
    if (status != DOM_OK)
        return status;
    *theta = DOM_NAN;
    if (cycle.barrier.height <= cycle.launch.kinetic)
        return DOM_OK;
    status = cycle_rest(cycle, &stop);
    if (status == DOM_OK && error && cycle.lean.mu > 0)
        *error = DOM_NAN;
    else if (status == DOM_OK && error)
        status = stop_error(&cycle, stop, error);
    if (status == DOM_OK)
        *theta = stop;
    return status;
}

/* 1 / (tau omega), and a bound of its error. */
KERNEL real slowness(real theta, void *context)
{
    struct cycle *cycle = context;
    real omegasq = 0;
    cycle->status = cycle_speed(cycle, theta, &omegasq, NULL);
    return cycle->status == DOM_OK && omegasq > 0 ? 1 / sqrt(omegasq) : REAL_NAN;
}

KERNEL real slowness_error(real theta, void *context)
{
    struct cycle *cycle = context;
    real omegasq = 0, error = 0;
    cycle->status = cycle_speed(cycle, theta, &omegasq, &error);
    return cycle->status == DOM_OK && omegasq > error
               ? error / (2 * (omegasq - error) * sqrt(omegasq - error))
               : REAL_NAN;
}

/*
 * The integral of f, which is as smooth as the slowness, from one tilt to another, over the pieces between
 * the edges of the barrier; unless NULL, error gets its bound.
 */
KERNEL enum dom_status cycle_integral(struct cycle *cycle, num_function *f, real from, real to, real tol,
                                      real *sum, real *error)
{
    const struct barrier *b = &cycle->barrier;
    real width = barrier_width(&cycle->lean, standing, b, cycle->launch.kinetic - b->height);
    *sum = 0;
    for (int i = 1; i < b->edges; i++) {
        real lo = fmax(b->edge[i - 1], from), hi = fmin(b->edge[i], to), part = 0, part_error = 0;
        if (lo >= hi)
            continue;
        enum num_status solver =
            num_peak_integral(f, cycle, lo, hi, b->theta_m, width, tol, &part, error ? &part_error : NULL);
        enum dom_status status = model_status(cycle->status, solver);
        if (status != DOM_OK)
            return status;
        *sum += part;
        if (error)
            *error += part_error;
    }
    return DOM_OK;
}

KERNEL enum dom_status cycle_duration(const struct dom_train *train, dom_real *duration, dom_real *error)
{
    struct cycle cycle;
    struct flow flow;
    enum dom_status status = cycle_whole(train, &flow, &cycle, error != NULL);
    if (status != DOM_OK)
        return status;
    real margin = cycle.launch.kinetic - cycle.barrier.height;
    if (margin < 0)
        return DOM_STOPS;
    /* kinetic and height each carry a few roundings: what they leave of the margin bounds the accuracy. */
    real noise = 8 * REAL_EPSILON * cycle.launch.kinetic / margin;
    if (!(noise < (real)0.125))
        return DOM_NOT_CONVERGED;
    real sum, sum_error = 0, of_speed = 0, end = tilt_angle(cycle.lean.c);
    real share = fmax((real)train->tol / 8, noise);
    status = cycle_integral(&cycle, slowness, 0, end, share, &sum, error ? &sum_error : NULL);
    if (cycle.lean.mu > 0)
        sum_error = REAL_NAN;
    else if (status == DOM_OK && error)
        status = cycle_integral(&cycle, slowness_error, 0, end, (real)0.125, &of_speed, NULL);
    if (status != DOM_OK)
        return status;
    *duration = sum;
    if (error)
        *error = sum_error + 2 * of_speed;
    return DOM_OK;
}
