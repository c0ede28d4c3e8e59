/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Computes the chain of leaning dominoes of a train. A proof must hold for all growths in an interval, and
 * for all tilts of the head in an interval. So most numbers are intervals, which contain the true value for
 * all these growths and tilts.
 *
 * A tilt theta is represented by v = 1 - cos theta, which increases with theta. The sine of the tilt is
 * sqrt(v (2 - v)), so no trigonometric function is needed.
 *
 * The follower of a domino with the tilt theta leans on it at the tilt
 *
 *     theta_1(theta, r) = theta + asin X,   X = r (L cos theta - d).
 *
 * This tilt increases with theta up to theta_leave, where the follower detaches. From then on, the follower
 * keeps its tilt. (If theta_inf < theta_leave, no domino tilts beyond theta_inf, so no follower detaches.) So
 * the tilt of the follower is F(theta, r), defined as the maximum of theta_1(t, r) over all t <= theta.
 *
 * F increases with theta, because it is a running maximum. F also increases with r: for every t <= theta_inf,
 * X >= 0, so theta_1(t, r) increases with r. Domino i has the tilt theta_i = F(F(... theta)), where F is
 * applied i times. Therefore theta_i increases with both theta and r.
 *
 * An interval of tilts and an interval of growths form a box. The lower corner of the box is the smallest
 * tilt with the smallest growth, and the upper corner is the largest tilt with the largest growth. Every
 * chain in a box lies between the chains at these two corners.
 */
#ifndef DOM_PROOF_CHAIN_H
#define DOM_PROOF_CHAIN_H

#include "proof/model/span.h"

/* All parameters of a train except its growth. A parameter is given as a double, but it stands for a decimal
 * number. So its interval contains all numbers that round to this double. If q is a whole number up to 64, it
 * is exact. */
struct shape {
    struct span s, d, L, q;
    /* v at the tilt theta_inf; it is s/L, because cos theta_inf = d/L (40; A16) */
    struct span v_inf;
    /* v at the tilt theta_u, at which the energy h of a domino is largest; tan theta_u = d */
    struct span v_top;
    struct span g_top; /* h(theta_u) - 1 */
    bool paper;        /* true to use the paper's closed form of the fuel */
    bool pair;         /* true for a train of two dominoes instead of the endless train */
};

/* The quantities of a chain at one growth r. */
struct corner {
    double r;
    struct span rs, rL, short_of; /* r s, r L, 1 - r s */
    /* v of the tilt min(theta_leave, theta_inf), beyond which a domino has no follower that leans on it */
    struct span leave;
    double last; /* upper bound on the v of every follower: the v of theta_f or of theta_inf */
};

/* A train whose growth r can be any number in an interval. For all these numbers, r s <= 1. */
struct growth {
    const struct shape *shape;
    struct span r;
    struct corner low, high;         /* the quantities at the two ends of the interval of growths */
    struct span leave;               /* as in struct corner, but for all growths in the interval */
    struct span rq, weight, inertia; /* r^q, r^-q, r^-(q+1) */
};

/* One domino of a chain, for all tilts of the head and all growths in a box. */
struct domino {
    struct span v;
    struct span slope; /* dtheta_i/dtheta >= 0 */
    struct span shift; /* dtheta_i/dr >= 0, for a head with a fixed tilt */
};

/* One contact: from domino i to domino i + 1. */
struct contact {
    struct span X, Y;  /* sine and cosine of theta_(i+1) - theta_i */
    struct span x;     /* sin theta_i */
    struct span slope; /* dF/dtheta */
    struct span shift; /* dF/dr */
    /* true if theta_i is beyond theta_leave in the whole box; the follower then stays at theta_f */
    bool held;
    bool may_hold; /* true if theta_i may be beyond theta_leave in a part of the box */
};

struct shape shape_make(double s, double d, double q);
struct growth growth_make(const struct shape *shape, double r_low, double r_high);

/* Returns sin theta, given v = 1 - cos theta. */
struct span tilt_sine(struct span v);

/* tilt_height returns g = d sin theta - (1 - cos theta), which is h(theta) - 1. tilt_rise returns the
 * derivative dh/dtheta. */
struct span tilt_height(const struct shape *shape, struct span v);
struct span tilt_rise(const struct shape *shape, struct span v);

/* Given v of a domino, returns v of its follower. */
struct span chain_follow(const struct growth *growth, struct span v);

/* Given v of a domino, returns its contact with its follower. */
struct contact chain_contact(const struct growth *growth, struct span v);

/* Returns the follower of `leader`, including derivatives. */
struct domino chain_next(const struct growth *growth, const struct domino *leader,
                         const struct contact *contact);

/*
 * Returns a domino that stands at theta_last, the largest tilt that any follower reaches. This tilt is
 * theta_f if followers detach, and theta_inf otherwise. The member `shift` of the domino is dtheta_last/dr.
 */
struct domino chain_last(const struct growth *growth);

/* Returns v of theta_c, the tilt of domino 1 while the head is upright: sin theta_c = r s. */
struct span chain_hit(const struct growth *growth);

/* ---- Powers (power.c) ---- */

/* Returns x^q for x >= 1 and q > 0. Integers q up to 64 need only multiplications. */
struct span span_power(struct span x, struct span q);

/* Returns ln x for x >= 1. */
struct span span_log(struct span x);

/* Returns e^x for 0 <= x <= 700. */
struct span span_exp(struct span x);

#endif
