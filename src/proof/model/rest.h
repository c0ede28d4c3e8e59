/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Computes upper bounds on the remainders of sums. A sum over the infinitely many dominoes of a train is
 * computed only up to domino n - 1. The terms for domino n and all later dominoes are its remainder.
 *
 * A remainder is bounded by a geometric series. Let p = 1 - r L sin theta_n, for the smallest r and the
 * smallest theta_n. For i >= n, Y_i <= 1 and x_i >= x_n. Therefore,
 *
 *     dF/dtheta = 1 - r L x_i / Y_i <= p.
 *
 * If no follower detaches, theta_inf is a fixed point of F. So the distance to theta_inf decreases at least
 * by the factor p from domino to domino:
 *
 *     theta_inf - theta_(i+1) <= p (theta_inf - theta_i).
 *
 * The numbers c_i = L (cos theta_i - cos theta_inf) = X_i / r decrease by the same factor, c_(i+1) <= p c_i.
 * This follows from
 *
 *     c_i - c_(i+1) >= L x_i (theta_(i+1) - theta_i) >= L x_i X_i = r L x_i c_i.
 */
#ifndef DOM_PROOF_REST_H
#define DOM_PROOF_REST_H

#include "proof/model/chain.h"

struct rest {
    double p; /* upper bound on dF/dtheta for domino n and all later dominoes */
    /* Upper bound on the ratio of successive terms of the energy: p r^-q if no follower detaches, and r^-q if
     * followers may detach. */
    double ratio;
    double series; /* upper bound on 1 + x + x^2 + ... for x = `ratio` */
    double power;  /* upper bound on r^(-q n) */
    double drop;   /* h(theta_(n+k)) - h(theta_last) <= `drop` * p^k, or <= `drop` if followers may detach */
    double drops;  /* upper bound on the sum of i r^(-q i) (h(theta_i) - h(theta_last)) q / r */
    double slides; /* upper bound on the sum of r^(-q i) |dh/dtheta| dtheta_i/dr */
    double tilts;  /* upper bound on the sum of r^(-q i) |dh/dtheta| dtheta_i/dtheta */
    double shift;  /* upper bound on every dtheta_i/dr */
};

/* The arguments `domino` and `contact` belong to domino n, `power` is an upper bound on r^(-q n), and `fall`
 * is an upper bound on h(theta_n) - h(theta_last). */
struct rest rest_find(const struct growth *growth, const struct domino *domino, const struct contact *contact,
                      double power, double fall, int n);

#endif
