/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Upper bounds of what sums over dominoes leave out: all dominoes from number n on.
 *
 * Contraction. Let p = 1 - r L sin theta_n, for the smallest r and theta_n. For i >= n, dF/dtheta = 1 - r L
 * x_i / Y_i
 * <= p, since Y <= 1 and x_i >= x_n. Where nothing detaches, theta_inf is a fixed point, so theta_inf -
 * theta_i+1
 * <= p (theta_inf - theta_i); and c_i = L (cos theta_i - cos theta_inf) contracts by p, too, because cos
 * theta_i
 * - cos theta_i+1 >= x_i (theta_i+1 - theta_i) >= x_i X_i = r x_i c_i.
 */
#ifndef DOM_PROOF_REST_H
#define DOM_PROOF_REST_H

#include "proof/chain.h"

struct rest {
    double p; /* see above */
    double
        ratio; /* largest ratio of neighbouring terms of the energy: p r^-q, or r^-q where followers detach */
    double series; /* 1 + ratio + ratio^2 + ... */
    double power;  /* r^(-q n) */
    double drop;   /* h(theta_n+k) - h(theta_last) <= drop p^k, or <= drop where followers detach */
    double drops;  /* sum of i r^(-q i) (h(theta_i) - h(theta_last)) q / r */
    double slides; /* sum of r^(-q i) |dh/dtheta| dtheta_i/dr */
    double tilts;  /* sum of r^(-q i) |dh/dtheta| dtheta_i/dtheta */
    double shift;  /* of each dtheta_i/dr */
};

/* Finds the bounds from domino n and its contact. fall: h(theta_n) - h(theta_last). */
struct rest rest_find(const struct growth *growth, const struct domino *domino, const struct contact *contact,
                      double power, double fall, int n);

#endif
