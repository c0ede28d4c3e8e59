/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Upper bounds on the remainders of sums over dominoes. A remainder consists of the terms of domino n and all
 * later dominoes.
 *
 * Contraction. Let p = 1 - r L sin theta_n, for the smallest r and theta_n. For i >= n, dF/dtheta = 1 - r L
 * x_i / Y_i <= p, since Y <= 1 and x_i >= x_n. If no follower detaches, theta_inf is a fixed point, so
 * theta_inf - theta_i+1 <= p (theta_inf - theta_i). c_i = L (cos theta_i - cos theta_inf) also contracts by
 * p, because cos theta_i - cos theta_i+1 >= x_i (theta_i+1 - theta_i) >= x_i X_i = r x_i c_i.
 */
#ifndef DOM_PROOF_REST_H
#define DOM_PROOF_REST_H

#include "proof/chain.h"

struct rest {
    double p; /* the contraction factor defined above */
    /* largest ratio of neighbouring terms of the energy: p r^-q, or r^-q where followers detach */
    double ratio;
    double series; /* 1 + ratio + ratio^2 + ... */
    double power;  /* r^(-q n) */
    double drop;   /* h(theta_n+k) - h(theta_last) <= drop p^k, or <= drop where followers detach */
    double drops;  /* upper bound on the sum of i r^(-q i) (h(theta_i) - h(theta_last)) q / r */
    double slides; /* upper bound on the sum of r^(-q i) |dh/dtheta| dtheta_i/dr */
    double tilts;  /* upper bound on the sum of r^(-q i) |dh/dtheta| dtheta_i/dtheta */
    double shift;  /* upper bound on every dtheta_i/dr */
};

/* Finds the bounds from domino n, its contact, power = r^(-q n) and fall >= h(theta_n) - h(theta_last). */
struct rest rest_find(const struct growth *growth, const struct domino *domino, const struct contact *contact,
                      double power, double fall, int n);

#endif
