/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The law of motion of dominoes that lose energy while they move. An equation of motion takes the place of
 * the energy balance (21; c3). To obtain it, multiply the equation of motion of each domino i by a factor S_i
 * and add all equations. The factors are S_0 = 1 and S_(i+1) = S_i a_i / b_i (55; e4), where a_i and b_i are
 * the lever arms of a contact. They make the contact forces cancel in the sum. With w = tau^2 omega^2, the
 * sum is
 *
 *     (A/2) dw/dtheta + B w = C,
 *     A = sum of r^(-(q+1) i) S_i theta_i',   B = sum of r^(-(q+1) i) S_i (theta_i'' + k_i theta_i'^2),
 *     C = sum of r^(-q i) S_i (x_i - d y_i) / 2.
 *
 * The torque k I omega^2 brakes each domino (`drag` of struct geometry). Without friction, S_i = theta_i',
 * A = J and C = -H'/2. Without friction and drag, B = J'/2. The files of the effects say how they change
 * these terms. The solution of the equation is
 *
 *     w = G (w(0) - u),
 *
 * where G and u depend on the tilt theta, but not on the launch. u(theta) is the smallest w(0) that takes the
 * head to the tilt theta. So the barrier, as an energy, is the maximum of J(0) u. Without friction, u =
 * [H(theta) - H(0)] / J(0).
 *
 * Source: van Leeuwen, The domino effect, Am. J. Phys. 78, 721 (2010).
 */
#ifndef DOM_LOSSES_H
#define DOM_LOSSES_H

#include "dynamics/dynamics.h"
#include "numerics/numerics.h"

struct flow {
    struct num_linear solution;
    real tol;           /* the tolerance at which `solution` was computed */
    real inertia_ratio; /* inertia ratio of the collision: A(0) - 1 = r^-(q+1) S_1(0) A(theta_c) */
    real J0, J_c;       /* J(0), and J(theta_c) of the hitting chain */
};

/* Returns true if a domino loses no energy while it touches no other domino. */
KERNEL bool losses_end_alone(const struct geometry *geometry)
{
    return geometry->drag == 0;
}

/* Finds tau^2 omega^2 of a domino with drag that tips over at theta_u and falls alone to the tilt theta_c.
 * The flow of the geometry is then the solution of this motion. */
KERNEL enum dom_status losses_tipped(const struct geometry *geometry, real *omegasq);

/* Allocates and frees the flow of a geometry, if its law of motion needs one. dynamics_end may follow a
 * failed dynamics_begin. */
KERNEL enum dom_status dynamics_begin(struct geometry *geometry);
KERNEL void dynamics_end(struct geometry *geometry);

/* Solves the equation of motion over a whole cycle, unless an earlier call has already done so. */
KERNEL enum dom_status flow_solve(const struct geometry *geometry);

/* Solves the equation of motion over [lo, *hi]. J is the inertia at lo. If friction locks the motion inside
 * this interval, lowers *hi to the tilt at which it locks and returns DOM_LOCKS. */
KERNEL enum dom_status flow_solve_piece(const struct geometry *geometry, real J, real lo, real *hi);

/* Solves the equation of motion of a plumb head from upright to the tilt hi, with a few evaluations only.
 * Returns false if friction may lock the motion. */
KERNEL bool flow_rough(const struct geometry *geometry, real hi);

/* If the motion stops before *hi, lowers *hi to a tilt shortly after the stop. The motion starts in a smooth
 * piece, which extends from edge[0] to edge[1]. */
KERNEL enum dom_status flow_spent(const struct geometry *geometry, const struct start *start,
                                  const real edge[2], real *hi);

/* Finds ln G, unless it is NULL, and u at a tilt from the last solution. */
KERNEL void flow_at(const struct geometry *geometry, real theta, real *ln_G, real *u);

/* Returns du/dtheta, with a reliable sign. */
KERNEL real flow_solved_slope(const struct geometry *geometry, real theta);

/* Returns an estimate of the error of required energies, which may be large compared with a small barrier. It
 * is 0 for the energy balance. */
KERNEL real flow_required_error(const struct geometry *geometry);

/* dynamics_collide and dynamics_near_rest of this law. */
KERNEL enum dom_status flow_collide(const struct geometry *geometry, struct launch *launch);
KERNEL enum dom_status flow_near_rest(const struct geometry *geometry, real end, real by, real *slowness);

#endif
