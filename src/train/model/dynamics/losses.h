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
 * The torque k I omega^2 brakes each domino (`drag` of struct geometry). The equation is linear in w, so
 * flow.h solves it. Without friction, S_i = theta_i', A = J and C = -H'/2. Without friction and drag, B =
 * J'/2. The files of the effects say how they change these terms.
 *
 * Source: van Leeuwen, The domino effect, Am. J. Phys. 78, 721 (2010).
 */
#ifndef DOM_LOSSES_H
#define DOM_LOSSES_H

#include "dynamics/dynamics.h"

static const struct dynamics losses;

/* Returns true if a domino loses no energy while it touches no other domino. */
KERNEL bool losses_end_alone(const struct geometry *geometry)
{
    return geometry->drag == 0;
}

/* Finds tau^2 omega^2 of a domino with drag that tips over at theta_u and falls alone to the tilt theta_c.
 * The flow of the geometry is then the solution of this motion. */
KERNEL enum dom_status losses_tipped(const struct geometry *geometry, real *omegasq);

#endif
