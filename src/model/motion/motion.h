/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One cycle as it runs in time: events, times, the state at a tilt. */
#ifndef DOM_MOTION_H
#define DOM_MOTION_H

#include "motion/cycle.h"

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
