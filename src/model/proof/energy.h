/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Computes energies for all growths and tilts in a box. The unit of energy is m g h / 2 of the head. */
#ifndef DOM_PROOF_ENERGY_H
#define DOM_PROOF_ENERGY_H

#include "proof/chain.h"
#include <stddef.h>

enum { LINKS_MOST = 20000 };

/* Domino i while the head of the train is upright; theta_i0 is the tilt of domino i. */
struct link {
    struct span g;      /* h(theta_i0) - 1 */
    struct span slide;  /* dh(theta_i0)/dr */
    struct span weight; /* r^(-q i) */
};

/* The train while its head is upright, at the beginning of a cycle. Energies are relative to this state. */
struct upright {
    struct growth growth;
    struct link *link; /* array of LINKS_MOST + 1 dominoes */
    int n;             /* sums run over dominoes 0 ... n - 1; bounds on the remainders are added */
    /* true if domino n and all later ones stay at theta_f during the cycle; remainders are then 0 */
    bool exact_end;
    double g_last; /* lower bound on h - 1 for domino n and all later ones */
    /* upper bound on the sum of (q i/r) r^(-q i) (h(theta_i0) - h(theta_last)) over i >= n */
    double drop_rest;
    double slide_rest;                 /* upper bound on the sum of -r^(-q i) dh(theta_i0)/dr over i >= n */
    struct span fuel, inertia;         /* P, T */
    struct span kinetic, kinetic_by_r; /* the kinetic energy K, and dK/dr, which may be infinite */
    bool by_r;                         /* true if the derivatives with respect to r are finite */
};

/* Computes the train with an upright head for r_low <= r <= r_high. Adds dominoes until the remainder of the
 * energy is at most `rest`, or no longer decreases. Returns false if the array has too little room. */
bool upright_find(const struct shape *shape, double r_low, double r_high, double rest,
                  struct upright *upright);

/* D = H(theta) - H(0) for all growths, and for all tilts theta of the head with
 * `low` <= 2 sin(theta/2) <= `high`. */
struct climb {
    struct span height;
    struct span by_tilt; /* derivative of D with respect to 2 sin(theta/2) */
    struct span by_r;    /* dD/dr, or an infinite interval where no bound is known */
};

struct climb climb_find(const struct upright *upright, double low, double high, bool derivatives);

/* Upper and lower bounds on 2 sin(theta_c/2) for all growths of the train. */
double upright_hit_above(const struct upright *upright);
double upright_hit_below(const struct upright *upright);

#endif
