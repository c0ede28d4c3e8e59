/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One cycle as it runs in time. */
#ifndef DOM_MOTION_H
#define DOM_MOTION_H

#include "motion/cycle.h"

struct motion {
    struct cycle cycle;
    real end; /* theta_c, or where the train comes to rest */
    real tol; /* of times: what a small margin leaves of the one that was asked for */
    bool stops;
};

/* Begins the motion of a train, up to theta_c or to where it comes to rest. */
KERNEL enum dom_status motion_begin(const struct dom_train *train, struct flow *flow, struct motion *motion);

/*
 * tau^2 times the angular acceleration of the head at a tilt, where tau^2 omega^2 is w: half of dw/dtheta,
 * from (c3) differentiated; *n gets the dominoes that matter.
 */
KERNEL enum dom_status motion_acceleration(const struct lean *lean, struct tilt head, real w,
                                           real *acceleration, size_t *n);

#endif
