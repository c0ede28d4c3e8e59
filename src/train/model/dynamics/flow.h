/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The equation of motion is (A/2) dw/dtheta + B w = C, where w = tau^2 omega^2. Its solution is
 *
 *     w = G (w(0) - u),
 *
 * where G and u depend on the tilt theta, but not on the launch. u(theta) is the smallest w(0) that takes the
 * head to the tilt theta. So the barrier, as an energy, is the maximum of J(0) u. Without friction, u =
 * [H(theta) - H(0)] / J(0).
 */
#ifndef DOM_FLOW_H
#define DOM_FLOW_H

#include "dynamics/dynamics.h"
#include "numerics/numerics.h"

struct flow {
    struct num_linear solution;
    real tol;           /* the tolerance at which `solution` was computed */
    real inertia_ratio; /* inertia ratio of the collision: A(0) - 1 = r^-(q+1) S_1(0) A(theta_c) */
    real J0, J_c;       /* J(0), and J(theta_c) of the hitting chain */
};

/* Frees a flow and its panels. `flow` may be NULL. */
KERNEL void flow_free(struct flow *flow);

/* Solves the equation of motion of a plumb head from upright to the tilt hi, with a few evaluations only.
 * Returns false if friction may lock the motion. */
KERNEL bool flow_rough(const struct geometry *geometry, real hi);

/* Finds ln G, unless it is NULL, and u at a tilt from the last solution. */
KERNEL void flow_at(const struct geometry *geometry, real theta, real *ln_G, real *u);

/* The functions of struct dynamics for laws of motion that need a flow. */
KERNEL enum dom_status flow_solve(const struct geometry *geometry);
KERNEL enum dom_status flow_solve_piece(const struct geometry *geometry, real J, real lo, real *hi);
KERNEL enum dom_status flow_spent(const struct geometry *geometry, const struct start *start,
                                  const real edge[2], real *hi);
KERNEL enum dom_status flow_collide(const struct geometry *geometry, enum dom_fuel fuel,
                                    struct launch *launch);
KERNEL enum dom_status flow_required(const struct geometry *geometry, struct tilt from, real p, real *energy);
KERNEL real flow_required_error(const struct geometry *geometry);
KERNEL enum dom_status flow_speed(const struct geometry *geometry, const struct start *start, real theta,
                                  real *omegasq);
KERNEL enum dom_status flow_near_rest(const struct geometry *geometry, real end, real by, real *slowness);
KERNEL real flow_gain(const struct geometry *geometry, const struct start *start, real gain, real theta,
                      real J_at);
KERNEL enum dom_status flow_braked(const struct geometry *geometry, struct tilt head, bool *braked);

/* Returns du/dtheta, with a reliable sign. */
KERNEL real flow_solved_slope(const struct geometry *geometry, real theta);

#endif
