/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "motion/cycle.h"

/* The barrier over [0, end]. */
static enum dom_status cycle_climb(struct cycle *cycle, real end)
{
    return barrier_search(&cycle->geometry, end, cycle->geometry.tol / 8, &cycle->barrier);
}

KERNEL enum dom_status cycle_whole(const struct request *train, struct flow *flow, struct cycle *cycle,
                                   bool errors)
{
    struct geometry *geometry = &cycle->geometry;
    cycle->status = DOM_OK;
    enum dom_status status = geometry_make(train, geometry);
    if (status == DOM_OK)
        geometry_flow(geometry, flow);
    if (status == DOM_OK)
        status = barrier_balance(geometry, train->fuel, tilt_angle(geometry->c), &cycle->launch,
                                 errors ? &cycle->launch_error : NULL, &cycle->barrier);
    if (status != DOM_OK)
        return status;
    return barrier_verdict(&cycle->launch, &cycle->barrier) == DOM_NO_FUEL ? DOM_NO_FUEL : DOM_OK;
}

KERNEL bool cycle_stops(const struct cycle *cycle)
{
    return barrier_verdict(&cycle->launch, &cycle->barrier) == DOM_STOPS;
}

/* (c3), solved for tau^2 omega(theta)^2. */
KERNEL enum dom_status cycle_speed(const struct cycle *cycle, real theta, real *omegasq, real *error)
{
    struct tilt head;
    struct sums at = {0}, e = {0};
    enum dom_status status = geometry_tilt(&cycle->geometry, theta, &head);
    if (status == DOM_OK && cycle->geometry.mu > 0) {
        *omegasq = friction_omegasq(&cycle->geometry, cycle->launch.omegasq, theta);
        if (error)
            *error = REAL_NAN;
        return DOM_OK;
    }
    if (status == DOM_OK)
        status = chain_energy_change(&cycle->geometry, head, &at, error ? &e : NULL);
    if (status != DOM_OK)
        return status;
    *omegasq = (cycle->launch.kinetic - at.dH) / at.J;
    if (error)
        *error = (cycle->launch_error.kinetic + e.dH + fabs(*omegasq) * (e.J + 3 * UNIT * at.J)) / at.J;
    return DOM_OK;
}

/* How much of the kinetic energy the highest point up to theta has used; it never falls with theta. */
static real energy_short(real theta, void *context)
{
    struct cycle *cycle = context;
    cycle->status = cycle_climb(cycle, theta);
    return cycle->status == DOM_OK ? cycle->barrier.height - cycle->launch.kinetic : REAL_NAN;
}

/* A slight motion that is used up before anybody falls off: *hi becomes a tilt soon behind the stop. */
static enum dom_status rubbing_spent(const struct cycle *cycle, real *hi)
{
    const struct geometry *geometry = &cycle->geometry;
    const struct barrier *b = &cycle->barrier;
    real first = fmin(*hi, b->edge[1]), spent = first;
    enum dom_status status =
        friction_flow_spent(geometry, standing, b->edge[0], cycle->launch.omegasq, &spent);
    if (status != DOM_OK || spent < first || first == *hi) {
        *hi = spent;
        return status;
    }
    geometry->flow->solution.panels = 0; /* it goes on over the edge: the whole flow is needed again */
    return friction_flow(geometry);
}

/*
 * The tilt where the energy is used up, of a cycle that stops; on a copy, since the search climbs anew.  With
 * friction the flow may not reach farther than that any more.
 */
KERNEL enum dom_status cycle_rest(struct cycle cycle, real *theta)
{
    const struct barrier *b = &cycle.barrier;
    real lo = b->edge[0], hi = b->theta_m;
    enum dom_status status = cycle.geometry.mu > 0 ? rubbing_spent(&cycle, &hi) : DOM_OK;
    if (status != DOM_OK)
        return status;
    enum num_status solver = num_root(energy_short, &cycle, lo, hi, cycle.geometry.tol / 8, theta);
    return model_status(cycle.status, solver);
}

/* The tilt where the cycle ends: theta_c, or where the train comes to rest. */
KERNEL enum dom_status cycle_end(const struct cycle *cycle, real *end)
{
    *end = tilt_angle(cycle->geometry.c);
    return cycle_stops(cycle) ? cycle_rest(*cycle, end) : DOM_OK;
}

/* cycle_speed of a train that comes as far, else DOM_STOPS; at the stop it is 0, which rounding hides. */
static enum dom_status cycle_speed_within(const struct cycle *cycle, real theta, real *omegasq, real *error)
{
    real end;
    enum dom_status status = cycle_end(cycle, &end);
    if (status == DOM_OK && cycle_stops(cycle) && theta > end * (1 + 4 * REAL_EPSILON))
        return DOM_STOPS;
    if (status == DOM_OK)
        status = cycle_speed(cycle, theta, omegasq, error);
    bool rests = cycle_stops(cycle) && theta >= end * (1 - 4 * REAL_EPSILON);
    *omegasq = rests ? 0 : fmax(*omegasq, 0);
    return status;
}

KERNEL enum dom_status cycle_omegasq(const struct request *train, dom_real theta_, dom_real *omegasq,
                                     dom_real *error)
{
    struct request finer = *train;
    struct cycle cycle;
    FLOW(flow);
    struct tilt head;
    real theta = (real)theta_, w = 0, w_error = 0;
    *omegasq = DOM_NAN;
    for (;;) {
        enum dom_status status = cycle_whole(&finer, &flow, &cycle, error != NULL);
        if (status != DOM_OK && status != DOM_NO_FUEL)
            return status;
        enum dom_status tilt_status = geometry_tilt(&cycle.geometry, theta, &head);
        if (tilt_status != DOM_OK || status != DOM_OK)
            return tilt_status != DOM_OK ? tilt_status : status;
        status = cycle_speed_within(&cycle, theta, &w, error ? &w_error : NULL);
        if (status != DOM_OK)
            return status;
        /* What is left near a stop is known as well as was asked only from finer sums. */
        real needed = balance_tol(cycle.geometry.tol, w, cycle.launch.omegasq);
        if (w == 0 || !(needed < cycle.geometry.tol / 4))
            break;
        finer.tol = needed;
    }
    *omegasq = w;
    if (error)
        *error = w_error;
    return DOM_OK;
}

/*
 * Of the tilt where the energy is used up: what is left of it and may be wrong with it, over its slope.
 * energy, unless NULL, gets what that tilt leaves open of the energy.
 */
static enum dom_status stop_error(const struct cycle *cycle, real theta, dom_real *error, real *energy)
{
    struct tilt head;
    struct sums at = {0}, e = {0};
    enum dom_status status = geometry_tilt(&cycle->geometry, theta, &head);
    if (status == DOM_OK)
        status = chain_energy_change(&cycle->geometry, head, &at, &e);
    if (status == DOM_OK)
        *error = (fabs(cycle->launch.kinetic - at.dH) + cycle->launch_error.kinetic + e.dH) / fabs(at.H1) *
                     (1 + 4 * cycle->geometry.tol) + /* to second order in a loose tolerance */
                 4 * UNIT * theta;
    if (energy)
        *energy = fabs(at.H1) * (real)*error;
    return status;
}

KERNEL enum dom_status cycle_stop(const struct request *train, dom_real *theta, dom_real *error)
{
    struct cycle cycle;
    FLOW(flow);
    real stop;
    enum dom_status status = cycle_whole(train, &flow, &cycle, error != NULL);
    if (status != DOM_OK)
        return status;
    *theta = DOM_NAN;
    if (!cycle_stops(&cycle))
        return DOM_OK;
    status = cycle_rest(cycle, &stop);
    if (status == DOM_OK && error && cycle.geometry.mu > 0)
        *error = DOM_NAN;
    else if (status == DOM_OK && error)
        status = stop_error(&cycle, stop, error, NULL);
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
    real width = barrier_width(&cycle->geometry, standing, b, cycle->launch.kinetic - b->height);
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

KERNEL enum dom_status cycle_duration(const struct request *train, dom_real *duration, dom_real *error)
{
    struct cycle cycle;
    FLOW(flow);
    enum dom_status status = cycle_whole(train, &flow, &cycle, error != NULL);
    if (status != DOM_OK)
        return status;
    if (cycle_stops(&cycle))
        return DOM_STOPS;
    real margin = cycle.launch.kinetic - cycle.barrier.height;
    /* kinetic and height each carry a few roundings: what they leave of the margin bounds the accuracy. */
    real noise = 8 * REAL_EPSILON * cycle.launch.kinetic / margin;
    if (!(noise < (real)0.125))
        return DOM_NO_MARGIN;
    real sum, sum_error = 0, of_speed = 0, end = tilt_angle(cycle.geometry.c);
    real share = fmax((real)train->tol / 8, noise);
    status = cycle_integral(&cycle, slowness, 0, end, share, &sum, error ? &sum_error : NULL);
    if (cycle.geometry.mu > 0)
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
