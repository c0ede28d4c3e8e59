/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The two laws of motion of a train; geometry->conservative says which of them applies. README.md in effects/
 * explains how to add an effect.
 *
 * The paper's law of motion: nothing dissipates energy during a cycle. So the sum of kinetic and potential
 * energy is constant; see (21; c3) and (51; d9). With w = tau^2 omega^2,
 *
 *     J(theta) w(theta) = J(0) w(0) - [H(theta) - H(0)].
 *
 * The collision at the start of the cycle does dissipate energy. It multiplies the angular velocity by
 * T / (1 + T), where T = J(0) - 1 is the inertia ratio (22; c4). During the cycle, the train releases the
 * fuel P (25; c7). If each cycle repeats the one before (23; c5), a cycle begins with the kinetic energy
 *
 *     K = P T / (r^q + T (r^q - 1)),
 *
 * which is J(0) times omega(0)^2 of (24; c6).
 *
 * Source: J. M. J. van Leeuwen, Domino Magnification.
 */
#pragma once

#include "geometry/chain.h"

/* Returns true if the paper's closed form of the fuel is valid: without losses, on a level floor, with sharp
 * edges. */
KERNEL bool dynamics_paper_holds(const struct geometry *geometry)
{
    return geometry->conservative && geometry->g.along == 0 && !geometry->rolls;
}

/* Finds the fuel (25; c7) from the energy balance and, unless it is NULL, the inertia ratio J(0) - 1 =
 * r^-(q+1) J(theta_c) (50; d8, corrected). */
KERNEL enum dom_status dynamics_fuel(const struct geometry *geometry, real *fuel, real *inertia_ratio);

/*
 * The collision (22; c4), derived as in (59; e8). The struck domino is upright. It moves on together with the
 * chain that hits it. The collision conserves the angular momentum that the contacts transmit:
 *
 *     (1 + T) omega(0) = T omega_1(theta_c).
 *
 * Here omega_1(theta_c) is the angular velocity of the hitting domino before the collision, and omega(0) is
 * the angular velocity of the struck domino afterwards. With sharp edges, the inertia ratio T is
 * r^-(q+1) J(theta_c), where J is the inertia of the hitting chain. With losses, the product S_1 A (below)
 * takes the place of J. This function returns omega(0) / omega_1(theta_c).
 */
KERNEL real collision_velocity_ratio(real inertia_ratio)
{
    return inertia_ratio / (1 + inertia_ratio);
}

/*
 * Finds the inertia ratio of the collision in which the head of the chain `hitting` hits the domino described
 * by `next`. In this collision, the head has the tilt `at`, and the chain has the inertia J. Returns
 * DOM_UNDERFLOW or DOM_LOCKS if the ratio is not positive.
 */
KERNEL enum dom_status dynamics_inertia_ratio(const struct geometry *next, const struct geometry *hitting,
                                              struct tilt at, real J, real *inertia_ratio);

/* The state in which a cycle begins, in units of the head. */
struct launch {
    real fuel;           /* P, the energy released in a cycle, by the chosen fuel formula */
    real J0;             /* J(0) */
    real inertia_ratio;  /* the inertia ratio T of the collision */
    real omegasq;        /* tau^2 omega(0)^2 */
    real kinetic;        /* J(0) tau^2 omega(0)^2 */
    real kinetic_at_hit; /* kinetic energy at theta_c, if the train gets that far */
};

/* Finds the launch of a train in which each cycle repeats the cycle before, scaled by r (24; c6). */
KERNEL enum dom_status dynamics_launch(const struct geometry *geometry, enum dom_fuel fuel,
                                       struct launch *launch);

/* The state in which a motion begins, with the head at the tilt `from`. */
struct start {
    struct tilt from;
    real J;       /* inertia of all moving dominoes (20; c2) */
    real omegasq; /* tau^2 omega^2 */
    real kinetic; /* J omegasq */
};

/* Finds dH/dtheta at a tilt of the head. If `rough` is true, only the sign of *slope is reliable. With
 * losses, *slope is a different number, which has the sign of the derivative of the required energy:
 * du/dtheta if `rough` is true, and -2 C otherwise. */
KERNEL enum dom_status dynamics_slope(const struct geometry *geometry, struct tilt head, bool rough,
                                      real *slope);

/* Finds tau^2 omega^2 at a tilt. */
KERNEL_SHARED enum dom_status dynamics_speed(const struct geometry *geometry, const struct start *start,
                                             real theta, real *omegasq);

/* Finds 1 / (tau^2 omega^2) at the tilt `end - by` of a motion whose energy is used up at `end`. If `by` is
 * negative, the motion starts at rest at `end`. *slowness is NaN if there is no energy at `end - by`. */
KERNEL enum dom_status dynamics_near_rest(const struct geometry *geometry, real end, real by, real *slowness);

/* ---- The other law of motion ---- */

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
 * head to the tilt theta. So the barrier, as an energy, is the maximum of J(0) u. Without losses, u =
 * [H(theta) - H(0)] / J(0).
 *
 * Source: van Leeuwen, The domino effect, Am. J. Phys. 78, 721 (2010).
 *
 * A geometry points to its flow, which begins as {0}. In the end, num_linear_free frees the solution.
 */
struct flow {
    struct num_linear solution;
    real tol;           /* the tolerance at which `solution` was computed */
    real inertia_ratio; /* inertia ratio of the collision: A(0) - 1 = r^-(q+1) S_1(0) A(theta_c) */
    real J0, J_c;       /* J(0), and J(theta_c) of the hitting chain */
};

/* Finds tau^2 omega^2 of a domino that tips over at theta_u and falls alone to theta_c. It is 0 if theta_u is
 * not below theta_c (5; b0). With drag, the flow of the geometry is then the solution of this motion. */
KERNEL enum dom_status dynamics_tipped(const struct geometry *geometry, real *omegasq);

/* Solves the equation of motion over a whole cycle, unless an earlier call has already done so. */
KERNEL enum dom_status flow_solve(const struct geometry *geometry);

/* Solves the equation of motion over [lo, *hi]. J is the inertia at lo. If friction locks the motion inside
 * this interval, lowers *hi to the tilt at which it locks and returns DOM_LOCKS. */
KERNEL enum dom_status flow_solve_piece(const struct geometry *geometry, real J, real lo, real *hi);

/* Solves the equation of motion of a plumb head from upright to the tilt hi, with a few evaluations only.
 * Returns false if friction may lock the motion. */
KERNEL_SHARED bool flow_rough(const struct geometry *geometry, real hi);

/* Finds ln G, unless it is NULL, and u at a tilt from the last solution. */
KERNEL_SHARED void flow_at(const struct geometry *geometry, real theta, real *ln_G, real *u);

/* Returns an estimate of the error of required energies, which may be large compared with a small barrier. It
 * is 0 for the energy balance. */
KERNEL real flow_required_error(const struct geometry *geometry);
