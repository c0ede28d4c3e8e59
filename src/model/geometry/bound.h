/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Running error bounds, from the head down the train: how far rounding can move the quantities of a domino
 * from their exact values, to first order in the unit roundoff. From a leader to its follower an error of the
 * angle shrinks by the slope, and the contact adds a few rounding errors.
 */
#ifndef DOM_BOUND_H
#define DOM_BOUND_H

#include "geometry/link.h"

struct bound {
    real angle;        /* of theta_i */
    real Y, arm, step; /* of the angle and the slope between leader and follower */
    real slope;        /* of theta_i' */
    real weight;       /* of r^(-q i), r^(-(q+1) i): relative */
    real inertia;
};

KERNEL struct bound bound_head(const struct geometry *geometry, const struct link *head, real angle);

/* Updates the bounds of domino i, from before link_next, to those of domino i + 1, from after link_next. */
KERNEL void bound_next(const struct geometry *geometry, const struct link *leader,
                       const struct link *follower, struct bound *bound);

/* Return bounds of the terms of J and of dH/dtheta. */
KERNEL real bound_J(const struct link *link, const struct bound *bound);
KERNEL real bound_H1(const struct geometry *geometry, const struct link *link, const struct bound *bound);

/* Returns a bound of h(A) - h(B) of one domino at the tilts a and b, from t = tan((A - B)/2) and the error of
 * t. */
KERNEL real bound_energy_change(const struct geometry *geometry, struct tilt a, struct tilt b, real angle_a,
                                real angle_b, real t, real t_error);

/* Returns a bound of t for the followers of a and b (energy_change_between). */
KERNEL real bound_half_turn(const struct link *a, const struct link *b, const struct bound *bound_a,
                            const struct bound *bound_b, real t, real t_error);

/* Returns a bound of the half angle t_f of a follower that detaches from its leader (energy_change_between).
 */
KERNEL real bound_leaving(const struct geometry *geometry, const struct link *leader,
                          const struct bound *bound, real t_f);

#endif
