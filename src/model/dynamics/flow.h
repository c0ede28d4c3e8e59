/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The solution of an equation of motion (A/2) dw/dtheta + B w = C, for every beginning at once: w = G (w(0) -
 * u).  u is what tau^2 omega(0)^2 must be to come to theta; where it is highest is the barrier, in energy
 * J(0) u.  Without friction u = [H(theta) - H(0)] / J(0).
 */
#ifndef DOM_FLOW_H
#define DOM_FLOW_H

#include "dynamics/friction.h"
#include "numerics/linear.h"

struct flow {
    struct num_linear solution;
    real tol; /* that it keeps */
    struct far_rubbing far;
    real inertia_ratio; /* A(0) - 1 = r^-(q+1) S_1(0) A(theta_c), of the collision */
    real J0, J_c;       /* J(0), and J(theta_c) of the hitting train */
};

/* Gives back a flow and what it holds; NULL is none. */
KERNEL void flow_free(struct flow *flow);

/* As solve, solve_piece and spent in struct dynamics. */
KERNEL enum dom_status flow_solve(const struct geometry *geometry);
KERNEL enum dom_status flow_solve_piece(const struct geometry *geometry, real J, real lo, real *hi);
KERNEL enum dom_status flow_spent(const struct geometry *geometry, const struct start *start,
                                  const real edge[2], real *hi);

/* ln G and u at a tilt of the head. */
KERNEL void flow_at(const struct geometry *geometry, real theta, real *ln_G, real *u);

/* w at the tilt `by` before `end`, of a motion that is used up there: G (u(end) - u), where nothing cancels.
 */
KERNEL real flow_left(const struct geometry *geometry, real end, real by);

#endif
