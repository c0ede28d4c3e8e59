/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "barrier.h"
#include <float.h>

/* A cycle that has begun: the train, its kinetic energy after the collision, and its barrier. */
struct cycle {
    struct lean lean;
    struct barrier barrier;
    double kinetic;
    enum dom_status status; /* of the function that is being integrated or searched */
};

/* DOM_NO_FUEL if the cycle does not begin.  The barrier is the one over [0, end]. */
static enum dom_status cycle_begin(const struct dom_train *train, struct cycle *cycle)
{
    struct dom_launch launch;
    enum dom_status status = lean_make(train, &cycle->lean);
    if (status == DOM_OK)
        status = collision_launch(&cycle->lean, train->fuel, &launch);
    if (status != DOM_OK)
        return status;
    cycle->kinetic = launch.kinetic;
    return launch.fuel > 0 ? DOM_OK : DOM_NO_FUEL;
}

static enum dom_status cycle_climb(struct cycle *cycle, double end)
{
    return barrier_search(&cycle->lean, CHAIN_ENDLESS, end, &cycle->barrier);
}

/* The cycle from its beginning to theta_c, with its barrier. */
static enum dom_status cycle_whole(const struct dom_train *train, struct cycle *cycle)
{
    enum dom_status status = cycle_begin(train, cycle);
    return status == DOM_OK ? cycle_climb(cycle, tilt_angle(cycle->lean.c)) : status;
}

/* (c3), solved for tau^2 omega(theta)^2. */
static enum dom_status cycle_omegasq(const struct cycle *cycle, double theta, double *omegasq)
{
    struct tilt head;
    struct sums sums = {0};
    enum dom_status status = lean_tilt(&cycle->lean, theta, &head);
    if (status == DOM_OK)
        status = chain_rise(&cycle->lean, head, CHAIN_ENDLESS, &sums);
    if (status == DOM_OK)
        *omegasq = (cycle->kinetic - sums.dH) / sums.J;
    return status;
}

enum dom_status dom_cycle_omegasq(const struct dom_train *train, double theta, double *omegasq)
{
    struct cycle cycle;
    struct tilt head;
    *omegasq = DOM_NAN;
    enum dom_status status = cycle_begin(train, &cycle);
    if (status != DOM_OK && status != DOM_NO_FUEL)
        return status;
    enum dom_status tilt_status = lean_tilt(&cycle.lean, theta, &head);
    if (tilt_status != DOM_OK)
        return tilt_status;
    if (status == DOM_OK)
        status = cycle_climb(&cycle, theta);
    if (status == DOM_OK && cycle.barrier.height > cycle.kinetic)
        status = DOM_STOPS;
    return status == DOM_OK ? cycle_omegasq(&cycle, theta, omegasq) : status;
}

/* How much of the kinetic energy the highest point up to theta has used; it never falls with theta. */
static double energy_short(double theta, void *context)
{
    struct cycle *cycle = context;
    cycle->status = cycle_climb(cycle, theta);
    return cycle->status == DOM_OK ? cycle->barrier.height - cycle->kinetic : DOM_NAN;
}

enum dom_status dom_cycle_stop(const struct dom_train *train, double *theta)
{
    struct cycle cycle;
    enum dom_status status = cycle_whole(train, &cycle);
    if (status != DOM_OK)
        return status;
    *theta = DOM_NAN;
    if (cycle.barrier.height <= cycle.kinetic)
        return DOM_OK;
    double lo = cycle.barrier.edge[0], hi = cycle.barrier.theta_m;
    enum num_status solver = num_root(energy_short, &cycle, lo, hi, train->tol / 8, theta);
    return model_status(cycle.status, solver);
}

static double slowness(double theta, void *context)
{
    struct cycle *cycle = context;
    double omegasq = 0;
    cycle->status = cycle_omegasq(cycle, theta, &omegasq);
    return cycle->status == DOM_OK && omegasq > 0 ? 1 / sqrt(omegasq) : DOM_NAN;
}

enum dom_status dom_cycle_duration(const struct dom_train *train, double *duration)
{
    struct cycle cycle;
    enum dom_status status = cycle_whole(train, &cycle);
    if (status != DOM_OK)
        return status;
    const struct barrier *b = &cycle.barrier;
    double margin = cycle.kinetic - b->height;
    if (margin < 0)
        return DOM_STOPS;
    /* kinetic and height each carry a few roundings: what they leave of the margin bounds the accuracy. */
    double noise = 8 * DBL_EPSILON * cycle.kinetic / margin;
    if (!(noise < 0.125))
        return DOM_NOT_CONVERGED;

    /* The near-stop at theta_m goes to the end of a piece, where the subdivision meets it at once. */
    double knot[4], sum = 0;
    int knots = 0;
    for (int i = 0; i < b->edges; i++) {
        if (i > 0 && b->theta_m > b->edge[i - 1] && b->theta_m < b->edge[i])
            knot[knots++] = b->theta_m;
        knot[knots++] = b->edge[i];
    }
    for (int i = 1; i < knots; i++) {
        double part = 0;
        enum num_status solver =
            num_integral(slowness, &cycle, knot[i - 1], knot[i], fmax(train->tol / 8, noise), &part);
        status = model_status(cycle.status, solver);
        if (status != DOM_OK)
            return status;
        sum += part;
    }
    *duration = sum;
    return DOM_OK;
}
