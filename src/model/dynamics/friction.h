/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A train whose dominoes rub (van Leeuwen, The domino effect, Am. J. Phys. 78, 721 (2010)): the tip of a
 * follower slides down its leader's face, and Coulomb's force mu N along the face turns against both.  Its
 * arms are a = Y/r - L x - mu d and b = (Y + mu X)/r (table 1).
 *
 * Energy is no longer kept, so (c3) gives way to the equation of motion.  With S_0 = 1, S_{i+1} = S_i a_i /
 * b_i, by which the torques of all dominoes add up without their contact forces, w = tau^2 omega^2 obeys
 *
 *     (A/2) dw/dtheta + B w = C,     A = sum r^-(q+1)i S_i theta_i',   B = sum r^-(q+1)i S_i theta_i'',
 *                                    C = sum r^-qi S_i (x_i - d y_i) / 2,
 *
 * which is linear in w: w = G (w(0) - u).  u is what tau^2 omega(0)^2 must be to come to theta; where it is
 * highest is the barrier, in energy J(0) u.  Without friction S_i = theta_i', A = J, C = -H'/2, u = dH /
 * J(0).
 *
 * Nothing in here is entered where mu = 0.
 */
#ifndef DOM_FRICTION_H
#define DOM_FRICTION_H

#include "geometry/chain.h"
#include "geometry/sums.h"
#include "numerics/linear.h"

/* w over a part of the cycle, for every beginning; the lean's, made where it is asked for first. */
struct flow {
    struct num_linear solution;
    real tol; /* that it keeps */
    /*
     * A(0) - 1 = r^-(q+1) S_1(0) A(theta_c): of the momentum of the train the collision keeps A(0) - 1 of
     * A(0). It is not positive where friction locks: the force on the struck domino passes behind its hinge.
     */
    real T;
    real J0, J_c; /* J(0), and J(theta_c) of the hitting train */
};

struct law {
    real A, B, C;
    real B_size, C_size; /* of all terms, whatever their signs: what their roundings are relative to */
};

KERNEL enum dom_status friction_law(const struct lean *lean, struct tilt head, struct law *law);

/* C alone, which vanishes at the top of a barrier; at tol = 1 its sign is right, from few dominoes. */
KERNEL enum dom_status friction_drive(const struct lean *lean, struct tilt head, real tol, real *C);

/* The flow of the lean over [0, theta_c], unless it is there already, with the edges between smooth parts. */
KERNEL enum dom_status friction_flow(const struct lean *lean);

/* The same over [lo, hi] alone, with u from lo on, and J there in the place of J(0). */
KERNEL enum dom_status friction_flow_piece(const struct lean *lean, real J, real lo, real hi);

/*
 * A slight motion from lo, the tilt `from`, that is used up before *hi is lost in the rounding of the whole
 * flow: then this one becomes that of the first part alone, and *hi its end.
 */
KERNEL enum dom_status friction_flow_spent(const struct lean *lean, struct tilt from, real lo, real omegasq,
                                           real *hi);

/* ln G and u at a tilt of the head. */
KERNEL void friction_at(const struct lean *lean, real theta, real *ln_G, real *u);

/* du/dtheta there. */
KERNEL enum dom_status friction_rate(const struct lean *lean, struct tilt head, real theta, real *rate);

/* J(0) u: the kinetic energy that it takes to come to a tilt. */
KERNEL real friction_climb(const struct lean *lean, real theta);

/* w = G (w(0) - u) at a tilt. */
KERNEL real friction_omegasq(const struct lean *lean, real omegasq_0, real theta);

#endif
