/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Energies of a train for whole intervals of growths and tilts, in m g h / 2 of the head. */
#ifndef DOM_PROOF_ENERGY_H
#define DOM_PROOF_ENERGY_H

#include "proof/chain.h"
#include <stddef.h>

enum { LINKS_MOST = 20000 };

/* Domino i of the train with an upright head. */
struct link {
    struct span g;      /* h(theta_i0) - 1 */
    struct span slide;  /* dh/dr of the domino */
    struct span weight; /* r^(-q i) */
};

/* The train with an upright head, to which all energy differences refer, and its kinetic energy K. */
struct upright {
    struct growth growth;
    struct link *link; /* array with room for LINKS_MOST + 1 dominoes */
    int n;          /* the sums are taken over dominoes 0 ... n - 1, and bounds on the remainder are added */
    bool exact_end; /* all dominoes from n on stay at theta_f during the cycle: the remainder is 0 */
    double g_last;  /* lower bound on h - 1 of all dominoes from n on */
    double drop_rest;          /* upper bound on sum (q i/r) r^(-q i) (h(theta_i0) - h(theta_last)), i >= n */
    double slide_rest;         /* upper bound on -sum r^(-q i) dh(theta_i0)/dr, i >= n */
    struct span fuel, inertia; /* P, T */
    struct span kinetic, kinetic_by_r; /* K and dK/dr; the latter may be infinite */
    bool by_r;                         /* the derivatives with respect to r are finite */
};

/* Finds the train of `shape` with an upright head for the growths r_low to r_high. Dominoes are added until
 * the remainder of the energy is at most `rest`, or until further dominoes would not make the remainder
 * smaller. Returns false if more dominoes matter than there is room for, or if numbers are out of range. */
bool upright_find(const struct shape *shape, double r_low, double r_high, double rest,
                  struct upright *upright);

/* D = H(theta) - H(0) for tilts of the head with `low` <= 2 sin(theta/2) <= `high`, and for all growths of
 * the train. */
struct climb {
    struct span height;
    struct span by_tilt; /* the derivative of D with respect to 2 sin(theta/2) */
    struct span by_r;    /* dD/dr; infinite where no bound is known */
};

struct climb climb_find(const struct upright *upright, double low, double high, bool derivatives);

/* These two functions return an upper and a lower bound on 2 sin(theta_c/2) for all growths. */
double upright_hit_above(const struct upright *upright);
double upright_hit_below(const struct upright *upright);

#endif
