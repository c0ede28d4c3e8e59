/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A train in intervals, which a proof needs: a proof must hold for all growths in an interval, and for all
 * tilts of the head in an interval. So most numbers are intervals, which contain the true value for all these
 * growths and tilts. Energies are in units of m g h / 2 of the head. */
#pragma once

#include "proof/model/span.h"

/* All parameters of a train except its growth. A parameter is given as a double, but it stands for a decimal
 * number. So its interval contains all numbers that round to this double. If q is a whole number up to 64, it
 * is exact. */
struct shape {
    struct span s, d, L, q;
    /* 1 - cos theta at the tilt theta_inf; it is s/L, because cos theta_inf = d/L (40; A16) */
    struct span v_inf;
    /* the same at the tilt theta_u, at which the energy h of a domino is largest; tan theta_u = d */
    struct span v_top;
    struct span g_top; /* h(theta_u) - 1 */
    bool paper;        /* true to use the paper's closed form of the fuel */
    bool pair;         /* true for a train of two dominoes instead of the endless train */
};

/* The quantities of a chain at one growth r. Tilts are given as v = 1 - cos theta. */
struct corner {
    struct span rs, rL, short_of; /* r s, r L, 1 - r s */
    /* v of the tilt min(theta_leave, theta_inf), beyond which a domino has no follower that leans on it */
    struct span leave;
    double last; /* upper bound on the v of every follower: the v of theta_f or of theta_inf */
};

/* The most dominoes that a sum has. */
enum { LINKS_MOST = 20000 };

/* Domino i while the head of the train is upright; theta_i0 is the tilt of domino i. */
struct link {
    struct dual g;      /* h(theta_i0) - 1 */
    struct dual weight; /* r^(-q i) */
};

/* The train at the beginning of a cycle, when its head is upright, for all growths in an interval. For all
 * these growths, r s <= 1. */
struct upright {
    const struct shape *shape;
    struct span r;
    struct corner low, high;         /* the quantities at the two ends of the interval of growths */
    struct span leave;               /* as in struct corner, but for all growths in the interval */
    struct dual rq, weight, inertia; /* r^q, r^-q, r^-(q+1) */
    /* v and 2 sin(theta/2) at theta_c, the tilt of domino 1 while the head is upright: sin theta_c = r s */
    struct span v_hit, hit;
    struct link *link; /* array of LINKS_MOST + 1 dominoes */
    /* Sums run over dominoes 0 ... n - 1. If no domino reaches theta_u, n is 0, and nothing is known except
     * that P <= 0 and K <= 0. */
    int n;
    double rest; /* the most energy that domino n and all later ones can release in a cycle */
    /* P and T with their remainders; for a pair, `fuel` is the energy that domino 1 releases, in m g h / 2 of
     * domino 1, and `T` is not set */
    struct span fuel, T;
    struct dual kinetic; /* the kinetic energy K, and the derivative of K_n */
};

struct shape shape_make(double s, double d, double q);

/*
 * Computes the train with an upright head, for all growths from r_low to r_high. If n is 0, dominoes are
 * added to the sums until the remainder of the energy is at most `rest`, until more dominoes hardly reduce
 * it, or until the array is full. If the array is full and even its last domino may not lean beyond theta_u,
 * no remainder is known, and the function returns false. If n is the number of dominoes that was chosen for
 * an interval of growths that contains this one, the sums run over the same dominoes.
 */
bool upright_find(const struct shape *shape, double r_low, double r_high, double rest, int n,
                  struct upright *upright);

/* The climb D = H(theta) - H(0): the energy that the train needs to tilt its head from upright to theta. */
struct climb {
    struct dual height;  /* D, and dD_n/dr */
    struct span by_tilt; /* derivative of D_n with respect to 2 sin(theta/2) */
};

/* Returns intervals that hold for all growths of the train, and for all theta <= theta_c for which
 * 2 sin(theta/2) lies between `low` and `high`. If `derivatives` is false, nothing is known about them. */
struct climb climb_find(const struct upright *upright, double low, double high, bool derivatives);
