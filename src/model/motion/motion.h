/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * One cycle of the endless train, from the launch over the barrier to the next hit, or to the tilt where the
 * train comes to rest: its events, its times, and its state at a tilt.
 */
#ifndef DOM_MOTION_H
#define DOM_MOTION_H

#include "motion/segment.h"

/* A cycle: its motion from upright to theta_c, and its beginning. */
struct cycle {
    struct segment segment;
    struct launch launch, launch_error;
};

/*
 * Begins the cycle and finds its barrier over [0, theta_c], with a tolerance at which the sign of the margin
 * is known, and launch_error if `errors` is set. Returns DOM_NO_FUEL if the cycle does not begin. cycle_free
 * frees the memory, also after a failure.
 */
KERNEL enum dom_status cycle_begin(const struct request *train, struct cycle *cycle, bool errors);
KERNEL void cycle_free(struct cycle *cycle);

/* Returns true if the train does not get over the barrier. Every answer about a cycle uses this verdict. */
KERNEL bool cycle_stops(const struct cycle *cycle);

/* Finds the tilt at which the cycle ends: theta_c, or where the train comes to rest. */
KERNEL enum dom_status cycle_end(struct cycle *cycle, real *end);

/* Finds tau^2 omega^2 at theta. Returns DOM_STOPS if the train does not reach theta. At the tilt where the
 * train comes to rest the value is exactly 0. */
KERNEL enum dom_status cycle_speed(const struct cycle *cycle, real end, real theta, real *omegasq,
                                   real *error);

/*
 * Finds the error bound of the tilt where a cycle has used up its energy, or NaN if no bound is known.
 * *energy, unless it is NULL, gets the error of the energy at that tilt.
 */
KERNEL enum dom_status stop_error(const struct cycle *cycle, real theta, dom_real *error, real *energy);

struct motion {
    struct cycle cycle;
    real end; /* theta_c, or the tilt where the train comes to rest */
    real tol; /* tolerance of times, which is larger than that of the request if the margin is small */
    bool stops;
    real smooth, root, span; /* parameters of the integral before a stop: see slowness_before */
    struct room room;        /* for forces */
};

/*
 * Begins the motion of a train, up to theta_c or to the tilt where it comes to rest. Returns DOM_NO_MARGIN if
 * times have no value. motion_end frees the memory, also after a failure.
 */
KERNEL enum dom_status motion_begin(const struct request *train, struct motion *motion, bool errors);
KERNEL void motion_end(struct motion *motion);

/* Returns the slowness before a stop as a smooth function of x, which motion.c defines. */
KERNEL real slowness_before(real x, void *context);

/* Finds the time from one tilt to another, in tau. */
KERNEL enum dom_status motion_time(struct motion *motion, real from, real to, real *time);

/* An event without its time. theta has the precision of the kernel, not that of struct dom_event. */
struct instant {
    enum dom_event_kind kind;
    real theta;
    size_t domino;
};

/* Lists the events of the motion in their order, at most DOM_EVENTS_MAX. */
KERNEL enum dom_status motion_events(const struct motion *motion, struct instant *events, int *count);

/* Finds the state at a tilt. `time` is NaN if it is not known yet. */
KERNEL enum dom_status motion_state(struct motion *motion, real theta, real time, struct dom_state *state,
                                    bool errors);

#endif
