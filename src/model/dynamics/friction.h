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

/*
 * A, B and C of a train whose head leans at theta_inf - e, a far follower, as A[0] - A[1] e + A[2] e^2 / 2;
 * of B the part that comes from theta_i'^2 of that head, since its theta_i'' counts as theta_i' does in A.
 */
struct far_rubbing {
    real A[3], B[3], C[3];
    bool known;
};

/* w over a part of the cycle, for every beginning; the lean's, made where it is asked for first. */
struct flow {
    struct num_linear solution;
    real tol; /* that it keeps */
    struct far_rubbing far;
    /*
     * A(0) - 1 = r^-(q+1) S_1(0) A(theta_c): of the momentum of the train the collision keeps A(0) - 1 of
     * A(0). It is not positive where friction locks: the force on the struck domino passes behind its hinge.
     */
    real inertia_ratio;
    real J0, J_c; /* J(0), and J(theta_c) of the hitting train */
};

/* Declares a flow without a solution, and gives back what it holds at the end of the block. */
#define FLOW(name) struct flow name __attribute__((cleanup(flow_free))) = {.solution = {.panel = NULL}}
KERNEL void flow_free(struct flow *flow);

struct equation_of_motion {
    real A, B, C;
    /* Of all terms, whatever their signs, and more where an arm b cancels: what roundings are relative to. */
    real A_size, B_size, C_size;
    bool locks; /* no acceleration fits the forces (Painleve): A <= 0, or an arm b of a follower is */
    size_t n;   /* dominoes followed */
};

KERNEL enum dom_status friction_equation_of_motion(const struct geometry *geometry, struct tilt head,
                                                   struct equation_of_motion *equation_of_motion);

/* C alone, which vanishes at the top of a barrier; at tol = 1 its sign is right, from few dominoes. */
KERNEL enum dom_status friction_drive(const struct geometry *geometry, struct tilt head, real tol, real *C);

/* The flow of the lean over [0, theta_c], unless it is there already, with the edges between smooth parts. */
KERNEL enum dom_status friction_flow(const struct geometry *geometry);

/*
 * The same over [lo, *hi] alone, with u from lo on, and J there in the place of J(0).  DOM_LOCKS: A vanishes
 * before *hi, which becomes the last tilt before that, to the tolerance; the flow holds up to there.
 */
KERNEL enum dom_status friction_flow_piece(const struct geometry *geometry, real J, real lo, real *hi);

/*
 * A slight motion from lo, the tilt `from`, that is used up before *hi is lost in the rounding of the whole
 * flow: then this one becomes that of the first part alone, and *hi its end.
 */
KERNEL enum dom_status friction_flow_spent(const struct geometry *geometry, struct tilt from, real lo,
                                           real omegasq, real *hi);

/* ln G and u at a tilt of the head. */
KERNEL void friction_at(const struct geometry *geometry, real theta, real *ln_G, real *u);

/* du/dtheta there. */
KERNEL enum dom_status friction_rate(const struct geometry *geometry, struct tilt head, real theta,
                                     real *rate);

/* J(0) u: the kinetic energy that it takes to come to a tilt. */
KERNEL real friction_climb(const struct geometry *geometry, real theta);

/* w at the tilt `by` before `end`, of a motion that is used up there: G (u(end) - u), where nothing cancels.
 */
KERNEL real friction_left(const struct geometry *geometry, real end, real by);

/* w = G (w(0) - u) at a tilt. */
KERNEL real friction_omegasq(const struct geometry *geometry, real omegasq_0, real theta);

#endif
