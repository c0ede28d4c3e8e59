/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Friction between dominoes (van Leeuwen, The domino effect, Am. J. Phys. 78, 721 (2010)): the tip of a
 * follower slides down its leader's face, and Coulomb's force mu N along the face turns against both.  The
 * arms of the contact are a = Y/r - L x - mu d and b = (Y + mu X)/r (table 1).
 *
 * Energy is no longer kept, so (c3) gives way to the equation of motion.  With S_0 = 1, S_{i+1} = S_i a_i /
 * b_i, by which the torques of all dominoes add up without their contact forces, w = tau^2 omega^2 obeys
 *
 *     (A/2) dw/dtheta + B w = C,     A = sum r^-(q+1)i S_i theta_i',   B = sum r^-(q+1)i S_i theta_i'',
 *                                    C = sum r^-qi S_i (x_i - d y_i) / 2,
 *
 * which is linear in w (flow.h).  Without friction S_i = theta_i', A = J and C = -H'/2.
 */
#ifndef DOM_FRICTION_H
#define DOM_FRICTION_H

#include "dynamics/energy_balance.h"

/*
 * A, B and C of a train whose head leans at theta_inf - e, a far follower, as A[0] - A[1] e + A[2] e^2 / 2;
 * of B the part that comes from theta_i'^2 of that head, since its theta_i'' counts as theta_i' does in A.
 */
struct far_rubbing {
    real A[3], B[3], C[3];
    bool known;
};

struct equation_of_motion {
    real A, B, C;
    /* Of all terms, whatever their signs, and more where an arm b cancels: what roundings are relative to. */
    real A_size, B_size, C_size;
    bool locks; /* no acceleration fits the forces (Painleve): A <= 0, or an arm b of a follower is */
    size_t n;   /* dominoes followed */
};

KERNEL enum dom_status friction_equation_of_motion(const struct geometry *geometry, struct tilt head,
                                                   struct equation_of_motion *equation_of_motion);

/* As in struct dynamics; J is not used. */
KERNEL enum dom_status friction_inertia_ratio(const struct geometry *next, const struct geometry *hitting,
                                              struct tilt at, real J, real *inertia_ratio);

/* Turns the effect on: mu = value. */
KERNEL enum dom_status friction_apply(struct geometry *geometry, real value);

#endif
