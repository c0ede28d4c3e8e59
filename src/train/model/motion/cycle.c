/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A cycle without its times: its launch, its barrier and its verdict, the speed at a tilt, and the tilt at
 * which the train stops. motion.c and clock.c add the times. */
#include "motion/motion.h"

KERNEL enum dom_status cycle_begin(const struct request *train, struct cycle *cycle)
{
    struct segment *st = &cycle->segment;
    struct geometry *geometry = &st->geometry;
    const struct launch *launch = &cycle->launch;
    *cycle = (struct cycle){.launch.fuel = REAL_NAN};
    enum dom_status status = dynamics_make(train, geometry);
    if (status == DOM_OK)
        status = dynamics_begin(geometry);
    if (status == DOM_OK)
        status =
            barrier_balance(geometry, train->fuel, tilt_angle(geometry->c), &cycle->launch, &st->barrier);
    if (status != DOM_OK)
        return status;
    st->hi = tilt_angle(geometry->c);
    st->start = (struct start){
        .from = standing, .J = launch->J0, .omegasq = launch->omegasq, .kinetic = launch->kinetic};
    st->gain = 1;
    st->inertia_ratio = launch->inertia_ratio;
    return barrier_verdict(launch, &st->barrier) == DOM_NO_FUEL ? DOM_NO_FUEL : DOM_OK;
}

KERNEL void cycle_free(struct cycle *cycle)
{
    dynamics_end(&cycle->segment.geometry);
}

KERNEL bool cycle_stops(const struct cycle *cycle)
{
    return barrier_verdict(&cycle->launch, &cycle->segment.barrier) == DOM_STOPS;
}

KERNEL enum dom_status cycle_end(struct cycle *cycle, real *end)
{
    *end = cycle->segment.hi;
    return cycle_stops(cycle) ? segment_rest(&cycle->segment, end) : DOM_OK;
}

KERNEL enum dom_status cycle_speed(const struct cycle *cycle, real end, real theta, real *omegasq)
{
    if (theta > end * (1 + 4 * REAL_EPSILON))
        return DOM_STOPS;
    enum dom_status status = segment_speed(&cycle->segment, fmin(theta, end), omegasq);
    bool rests = cycle_stops(cycle) && theta >= end * (1 - 4 * REAL_EPSILON);
    *omegasq = rests ? 0 : fmax(*omegasq, 0);
    return status;
}

KERNEL enum dom_status barrier_find(const struct request *train, struct dom_barrier *barrier)
{
    struct cycle cycle;
    const struct barrier *b = &cycle.segment.barrier;
    enum dom_status status = cycle_begin(train, &cycle);
    bool fuelled = status != DOM_NO_FUEL;
    real stop = REAL_NAN;
    status = fuelled ? status : DOM_OK;
    if (status == DOM_OK && fuelled && cycle_stops(&cycle))
        status = segment_rest(&cycle.segment, &stop);
    cycle_free(&cycle);
    if (status != DOM_OK)
        return status;
    real kinetic = cycle.launch.kinetic;
    *barrier = (struct dom_barrier){
        .theta_m = b->theta_m,
        .barrier = b->height,
        .kinetic = fuelled ? kinetic : REAL_NAN,
        .margin = fuelled ? kinetic - b->height : REAL_NAN,
        .stop = stop,
    };
    return barrier_verdict(&cycle.launch, b);
}

KERNEL enum dom_status cycle_omegasq(const struct request *train, dom_real theta_, dom_real *omegasq)
{
    struct request finer = *train;
    real theta = (real)theta_, w = 0;
    for (;;) {
        struct cycle cycle;
        struct tilt head;
        enum dom_status status = cycle_begin(&finer, &cycle), tilt_status = DOM_OK;
        if (status == DOM_OK || status == DOM_NO_FUEL)
            tilt_status = geometry_tilt(&cycle.segment.geometry, theta, &head);
        if (tilt_status != DOM_OK)
            status = tilt_status;
        real end = 0;
        if (status == DOM_OK)
            status = cycle_end(&cycle, &end);
        if (status == DOM_OK)
            status = cycle_speed(&cycle, end, theta, &w);
        cycle_free(&cycle);
        if (status != DOM_OK)
            return status;
        /* Near a stop, the remaining energy is the small difference of two large terms. Then both terms are
         * computed again with a finer tolerance. */
        real tol = cycle.segment.geometry.tol, needed = balance_tol(tol, w, cycle.launch.omegasq);
        if (w == 0 || !(needed < tol / 4))
            break;
        finer.tol = needed;
    }
    *omegasq = w;
    return DOM_OK;
}

KERNEL enum dom_status cycle_duration(const struct request *train, dom_real *duration)
{
    struct cycle cycle;
    real time = REAL_NAN;
    enum dom_status status = cycle_begin(train, &cycle);
    if (status == DOM_OK)
        status = cycle_stops(&cycle) ? DOM_STOPS : segment_time(&cycle.segment, (real)train->tol, &time);
    cycle_free(&cycle);
    if (status == DOM_OK)
        *duration = time;
    return status;
}
