/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * One cycle of the endless train: from the launch over the barrier to the next hit, or to where it comes to
 * rest; and as it runs in time: events, times, the state at a tilt.
 */
#ifndef DOM_MOTION_H
#define DOM_MOTION_H

#include "motion/segment.h"

/* A cycle that has begun: its motion from upright to theta_c, and how it begins. */
struct cycle {
    struct segment segment;
    struct launch launch, launch_error;
};

/*
 * Begins the cycle and finds its barrier over [0, theta_c], at a tolerance at which the margin is known;
 * errors: with launch_error.  DOM_NO_FUEL if the cycle does not begin.  cycle_free gives back what it takes,
 * also after a failure.
 */
KERNEL enum dom_status cycle_begin(const struct request *train, struct cycle *cycle, bool errors);
KERNEL void cycle_free(struct cycle *cycle);

/* Returns true when the train does not get over the barrier: every answer of a cycle takes its verdict here.
 */
KERNEL bool cycle_stops(const struct cycle *cycle);

/* Finds the tilt at which the cycle ends: theta_c, or where the train comes to rest. */
KERNEL enum dom_status cycle_end(struct cycle *cycle, real *end);

/* tau^2 omega^2 of a train that comes as far as theta, else DOM_STOPS; at its end, where it comes to rest, it
 * is 0, which rounding hides. */
KERNEL enum dom_status cycle_speed(const struct cycle *cycle, real end, real theta, real *omegasq,
                                   real *error);

/*
 * Bound of the error of the tilt at which a cycle has used up its energy; energy, unless NULL, gets what that
 * tilt leaves open of the energy.  NaN where no bound is known.
 */
KERNEL enum dom_status stop_error(const struct cycle *cycle, real theta, dom_real *error, real *energy);

struct motion {
    struct cycle cycle;
    real end; /* theta_c, or where the train comes to rest */
    real tol; /* of times: what a small margin leaves of the one that was asked for */
    bool stops;
    real smooth, root, span; /* of the integral before a stop: see slowness_before */
    struct room room;        /* for forces */
};

/*
 * Begins the motion of a train, up to theta_c or to where it comes to rest; motion_end gives back what it
 * takes, also after a failure. DOM_NO_MARGIN where times have no value.
 */
KERNEL enum dom_status motion_begin(const struct request *train, struct motion *motion, bool errors);
KERNEL void motion_end(struct motion *motion);

/* The slowness before a stop, as a smooth function of x; see its definition. */
KERNEL real slowness_before(real x, void *context);

/* The time from one tilt to another, in tau. */
KERNEL enum dom_status motion_time(struct motion *motion, real from, real to, real *time);

/* An event without its time; theta is not rounded to that of struct dom_event. */
struct instant {
    enum dom_event_kind kind;
    real theta;
    size_t domino;
};

/* Lists the events of the motion in their order, at most DOM_EVENTS_MAX. */
KERNEL enum dom_status motion_events(const struct motion *motion, struct instant *events, int *count);

/* The state at a tilt; time NaN where it is not known yet. */
KERNEL enum dom_status motion_state(struct motion *motion, real theta, real time, struct dom_state *state,
                                    bool errors);

#endif
