/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Describes a train for all growths in an interval, and its dominoes for all tilts in an interval.
 *
 * A tilt theta is represented by v = 1 - cos theta, which increases with theta. The sine is sqrt(v (2 - v)),
 * so no function of libm is needed.
 *
 * The follower of a domino with the tilt theta leans on it at the tilt
 *
 *     theta_1(theta, r) = theta + asin X,   X = r (L cos theta - d).
 *
 * theta_1 increases with theta up to min(theta_leave, theta_inf). Beyond that, the follower has detached and
 * keeps its tilt. So the tilt of the follower is F(theta, r), the maximum of theta_1(t, r) over all t <=
 * theta.
 *
 * F increases with theta, because it is a running maximum. F also increases with r, because theta_1(t, r)
 * increases with r for every t <= theta_inf, where X >= 0. Therefore theta_i = F(F(... theta)) increases with
 * both theta and r.
 *
 * A box consists of an interval of tilts and an interval of growths. Every chain in a box lies between the
 * chains at its lower and its upper corner.
 */
#ifndef DOM_PROOF_CHAIN_H
#define DOM_PROOF_CHAIN_H

#include "proof/span.h"

/* All parameters of a train except its growth. The intervals contain all decimal numbers that round to the
 * given doubles. */
struct shape {
    struct span s, d, L, q;
    /* v at the tilt theta_inf; it is s/L, because cos theta_inf = d/L (40; A16) */
    struct span v_inf;
    /* v at the tilt theta_u, at which the energy h of a domino is largest; tan theta_u = d */
    struct span v_top;
    struct span g_top; /* h(theta_u) - 1 */
    double steepest;   /* sqrt(1 + d^2), which is the largest |dh/dtheta| */
    bool paper;        /* true to use the paper's closed form of the fuel */
    bool pair;         /* true for a train of two dominoes instead of the endless train */
};

/* The quantities of a chain at one growth r. */
struct corner {
    double r;
    struct span rs, rL, short_of; /* r s, r L, 1 - r s */
    struct span leave;            /* v of the tilt min(theta_leave, theta_inf), beyond which F is constant */
    /* upper bound on the v of every follower: the v of theta_f or of theta_inf */
    double last;
};

/* A train for all growths r in an interval, where r s <= 1. */
struct growth {
    const struct shape *shape;
    struct span r;
    struct corner low, high; /* the quantities at the two ends of the interval of growths */
    /* v of the tilt min(theta_leave, theta_inf), for all growths in the interval */
    struct span leave;
    bool detaches_never;             /* true if theta_inf < theta_leave for all growths in the interval */
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

/* Returns an interval that contains sin theta for every tilt theta with 1 - cos theta in v. */
struct span tilt_sine(struct span v);

/* For all tilts theta with 1 - cos theta in v: tilt_height returns g = d sin theta - (1 - cos theta) =
 * h(theta) - 1, and tilt_rise returns dh/dtheta. */
struct span tilt_height(const struct shape *shape, struct span v);
struct span tilt_rise(const struct shape *shape, struct span v);

/* Given 1 - cos theta of a domino, returns 1 - cos theta of its follower. */
struct span chain_follow(const struct growth *growth, struct span v);

/* Returns the contact of a domino with its follower. v is 1 - cos theta of the domino. */
struct contact chain_contact(const struct growth *growth, struct span v);

/* Returns the follower of `leader`, including derivatives. */
struct domino chain_next(const struct growth *growth, const struct domino *leader,
                         const struct contact *contact);

/* Returns a domino at theta_last, the largest tilt that any follower reaches (theta_f or theta_inf). Its
 * `shift` is dtheta_last/dr. */
struct domino chain_last(const struct growth *growth);

/* Returns 1 - cos theta_c, where sin theta_c = r s. Domino 1 has the tilt theta_c while the head is
 * upright. */
struct span chain_hit(const struct growth *growth);

#endif
