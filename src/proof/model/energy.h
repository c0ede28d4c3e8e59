/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Computes intervals that contain the energies of a train, for all growths and tilts in a box. The unit of
 * energy is m g h / 2 of the head. */
#ifndef DOM_PROOF_ENERGY_H
#define DOM_PROOF_ENERGY_H

#include "proof/model/chain.h"
#include <stddef.h>

enum { LINKS_MOST = 20000 };

/* Domino i while the head of the train is upright; theta_i0 is the tilt of domino i. */
struct link {
    struct dual g;      /* h(theta_i0) - 1 */
    struct dual weight; /* r^(-q i) */
};

/* The train at the beginning of a cycle, when its head is upright. All energies are differences from the
 * energy in this state. */
struct upright {
    struct growth growth;
    struct link *link; /* array of LINKS_MOST + 1 dominoes */
    /* Sums run over dominoes 0 ... n - 1, and intervals include the remainder. If no domino reaches theta_u,
     * n is 0, and nothing is known except that P <= 0 and K <= 0. */
    int n;
    /* true if there is no domino n, or if domino n and all later ones stay at theta_f during the cycle; then
     * all remainders are 0 */
    bool exact_end;
    double g_last; /* lower bound on h - 1 for domino n and all later ones */
    /* P and T; for a pair, `fuel` is the energy that domino 1 releases, in m g h / 2 of domino 1, and
     * `inertia` is not set */
    struct span fuel, inertia;
    struct dual kinetic; /* the kinetic energy K, and the derivative of K_n, which may be infinite */
    bool by_r;           /* true if the derivatives with respect to r are finite */
};

/*
 * Computes the train with an upright head, for all growths from r_low to r_high. If n is 0, dominoes are
 * added to the sums until the remainder of the energy is at most `rest`, until more dominoes hardly reduce
 * it, or until the array is full. If the array is full and even its last domino may not lean beyond theta_u,
 * no remainder is known, and the function returns false. If n is the number of dominoes that was chosen for
 * an interval of growths that contains this one, the sums run over the same dominoes.
 */
bool upright_find(const struct shape *shape, double r_low, double r_high, double rest, int n,
                  struct upright *upright);

/* The energy D = H(theta) - H(0) that the train needs to tilt its head from upright to theta. */
struct climb {
    struct span height;  /* D */
    struct span by_tilt; /* derivative of D_n with respect to 2 sin(theta/2) */
    struct span by_r;    /* dD_n/dr, or an infinite interval where no bound is known */
};

/* Returns intervals that hold for all growths of the train, and for all theta <= theta_c for which
 * 2 sin(theta/2) lies between `low` and `high`. If `derivatives` is false, the intervals of the derivatives
 * are infinite. */
struct climb climb_find(const struct upright *upright, double low, double high, bool derivatives);

/* Upper and lower bounds on 2 sin(theta_c/2) for all growths of the train. */
double upright_hit_above(const struct upright *upright);
double upright_hit_below(const struct upright *upright);

#endif
