/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One cycle of an endless train: its events, its times, and its state at a tilt. A cycle ends with the next
 * hit, or where the train comes to rest. */
#ifndef DOM_MOTION_H
#define DOM_MOTION_H

#include "motion/clock.h"

/* The motion of the head from its upright position to theta_c, and the launch that begins it. */
struct cycle {
    struct segment segment;
    struct launch launch;
};

/*
 * Prepares a cycle and finds its barrier over [0, theta_c].
 * Returns DOM_NO_FUEL if the train has no energy for a launch. Always call cycle_free afterwards.
 */
KERNEL enum dom_status cycle_begin(const struct request *train, struct cycle *cycle);
KERNEL void cycle_free(struct cycle *cycle);

/* Returns true if the train does not get over the barrier. */
KERNEL bool cycle_stops(const struct cycle *cycle);

/* Finds the tilt at which the cycle ends: theta_c, or the tilt at which the train comes to rest. */
KERNEL enum dom_status cycle_end(struct cycle *cycle, real *end);

/* Finds tau^2 omega^2 at theta. `end` comes from cycle_end. Returns
 * DOM_STOPS if the train does not reach theta. Where the train comes to rest, *omegasq is exactly 0. */
KERNEL enum dom_status cycle_speed(const struct cycle *cycle, real end, real theta, real *omegasq);

struct motion {
    struct cycle cycle;
    real end; /* the last tilt: theta_c, or the tilt of rest if the train stops */
    bool stops;
    struct clock clock; /* only if motion_begin is asked for times */
    struct room room;   /* memory for the computation of forces */
};

/*
 * Prepares the motion of a train up to theta_c, or up to its stop, and its clock if `timed` is true. Returns
 * DOM_NO_MARGIN if the margin is too small to compute times. Always call motion_end afterwards.
 */
KERNEL enum dom_status motion_begin(const struct request *train, bool timed, struct motion *motion);
KERNEL void motion_end(struct motion *motion);

#endif
