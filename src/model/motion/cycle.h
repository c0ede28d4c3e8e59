/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One cycle of the endless train: from the launch over the barrier to the next hit, or to where it comes to
 * rest. */
#ifndef DOM_CYCLE_H
#define DOM_CYCLE_H

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

#endif
