/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One cycle of an endless train: its events, its times, and its state at a tilt. A cycle ends with the next
 * hit, or where the train comes to rest. */
#ifndef DOM_MOTION_H
#define DOM_MOTION_H

#include "motion/segment.h"

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
    real tol; /* tolerance of times; larger than requested if the margin is small */
    bool stops;
    /* Parameters of slowness_before, set by its callers: the integral begins at the tilt `smooth`, and u is
     * root + span x. */
    real smooth, root, span;
    struct room room; /* memory for the computation of forces */
};

/*
 * Prepares the motion of a train up to theta_c, or up to its stop. Returns DOM_NO_MARGIN if the margin is too
 * small to compute times. Always call motion_end afterwards.
 */
KERNEL enum dom_status motion_begin(const struct request *train, struct motion *motion);
KERNEL void motion_end(struct motion *motion);

/* Returns dt/du, the integrand of the time before a stop, as a smooth function of x (motion.c). The context
 * is a struct motion. */
KERNEL real slowness_before(real x, void *context);

/* Finds the time from one tilt to another, in tau. */
KERNEL enum dom_status motion_time(struct motion *motion, real from, real to, real *time);

/* An event without its time. Unlike in struct dom_event, theta has the full precision of the kernel. */
struct instant {
    enum dom_event_kind kind;
    real theta;
    size_t domino;
};

/* Lists the events of the motion in the order in which they happen. There are at most DOM_EVENTS_MAX. */
KERNEL enum dom_status motion_events(const struct motion *motion, struct instant *events, int *count);

/* Finds the state at a tilt. `time` is the time at this tilt, or NaN if it is not known. */
KERNEL enum dom_status motion_state(struct motion *motion, real theta, real time, struct dom_state *state);

#endif
