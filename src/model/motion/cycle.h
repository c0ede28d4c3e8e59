/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One cycle of the endless train: from the launch over the barrier to the next hit, or to where it comes to
 * rest. */
#ifndef DOM_CYCLE_H
#define DOM_CYCLE_H

#include "energy/barrier.h"

/* A cycle that has begun: the train, its kinetic energy after the collision, and its barrier. */
struct cycle {
    struct geometry geometry;
    struct barrier barrier;
    struct launch launch, launch_error;
    enum dom_status status; /* of the function that is being integrated or searched */
};

/*
 * Begins the cycle and finds its barrier over [0, theta_c], at a tolerance at which the margin is known. flow
 * is room for the motion with friction; errors: with launch_error.  DOM_NO_FUEL if the cycle does not begin.
 */
KERNEL enum dom_status cycle_whole(const struct request *train, struct flow *flow, struct cycle *cycle,
                                   bool errors);

/* tau^2 omega^2 at a tilt (c3), and unless error is NULL the bound of its error. */
KERNEL enum dom_status cycle_speed(const struct cycle *cycle, real theta, real *omegasq, real *error);

/* Returns true when the train does not get over the barrier: every answer of a cycle takes its verdict here.
 */
KERNEL bool cycle_stops(const struct cycle *cycle);

/* Finds the tilt at which the cycle ends: theta_c, or where the train comes to rest. */
KERNEL enum dom_status cycle_end(const struct cycle *cycle, real *end);

/* The tilt at which a cycle that stops has used up its energy. */
KERNEL enum dom_status cycle_rest(struct cycle cycle, real *theta);

/* 1 / (tau omega) at a tilt, and the bound of its error, for integrals; context is the cycle. */
KERNEL real slowness(real theta, void *context);
KERNEL real slowness_error(real theta, void *context);

/*
 * Integrates f, which is as smooth as the slowness, from one tilt to another, piece by piece between the
 * edges of the barrier; unless NULL, error gets the bound.
 */
KERNEL enum dom_status cycle_integral(struct cycle *cycle, num_function *f, real from, real to, real tol,
                                      real *sum, real *error);

#endif
