/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Running error bounds: how far rounding can move the quantities of a domino, to first order in the unit
 * roundoff. The bounds are updated from domino to domino, from the head down the train. On the way from a
 * leader to its follower, the error of the angle is multiplied by the slope of the contact. Computing the
 * contact adds a few more rounding errors.
 */
#ifndef DOM_BOUND_H
#define DOM_BOUND_H

#include "geometry/link.h"

struct bound {
    real angle;                 /* error bound on theta_i */
    real Y, arm, contact_slope; /* error bounds on the contact of domino i with its follower */
    real slope;                 /* error bound on theta_i' */
    real weight;                /* relative error bound on r^(-q i) */
    real inertia;               /* relative error bound on r^(-(q+1) i) */
};

KERNEL struct bound bound_head(const struct geometry *geometry, const struct link *head, real angle);

/* Replaces the bounds on the leader in *bound by the bounds on its follower. */
KERNEL void bound_next(const struct geometry *geometry, const struct link *leader,
                       const struct link *follower, struct bound *bound);

/* These two functions return error bounds for one domino's terms in J and in dH/dtheta. */
KERNEL real bound_J(const struct link *link, const struct bound *bound);
KERNEL real bound_H1(const struct geometry *geometry, const struct link *link, const struct bound *bound);

/* Returns an error bound on h(A) - h(B) for one domino. A and B are the angles that belong to the tilts a and
 * b. t is tan((A - B)/2). The arguments angle_a, angle_b and t_error are error bounds on A, B and t. */
KERNEL real bound_energy_change(const struct geometry *geometry, struct tilt a, struct tilt b, real angle_a,
                                real angle_b, real t, real t_error);

/*
 * Let theta_a and theta_b be the tilts of one domino in two chains, and t = tan((theta_a - theta_b)/2).
 * energy_change_between computes the t of each follower from the t of its leader. The arguments a and b are
 * the leader in the two chains, and t_error is the error bound on its t. Returns the error bound on the t of
 * the follower.
 */
KERNEL real bound_tan_half(const struct link *a, const struct link *b, const struct bound *bound_a,
                           const struct bound *bound_b, real t, real t_error);

/* Returns an error bound on t_f, the result of leaving_half_turn in sharp_change.c. */
KERNEL real bound_leaving(const struct geometry *geometry, const struct link *leader,
                          const struct bound *bound, real t_f);

#endif
