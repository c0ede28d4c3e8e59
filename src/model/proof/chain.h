/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A train for a whole interval of growths, and its dominoes for a whole interval of tilts.
 *
 * A tilt theta is represented by v = 1 - cos theta, which is 0 for an upright domino and increases with
 * theta. The sine is sqrt(v (2 - v)), so that no function of libm is needed.
 *
 * Monotony. The tilt of the follower, theta_1(theta, r) = theta + asin X with X = r (L cos theta - d),
 * increases with theta up to min(theta_leave, theta_inf). Beyond that tilt the follower has detached and
 * keeps its tilt. So the tilt of the follower is F(theta, r) = max over t <= theta of theta_1(t, r). F
 * increases with theta as every running maximum does, and with r because theta_1(t, r) increases with r for
 * every t <= theta_inf, where X >= 0. Therefore theta_i = F(F(... theta)) increases with both: the chain from
 * the lower corner of a box is a lower bound, and the chain from the upper corner an upper bound, of every
 * chain of the box.
 */
#ifndef DOM_PROOF_CHAIN_H
#define DOM_PROOF_CHAIN_H

#include "proof/span.h"

/* A train without its growth. Its numbers are intervals around the given doubles, so that they also contain
 * the decimals that were rounded to these doubles. */
struct shape {
    struct span s, d, L, q;
    struct span v_inf; /* v of theta_inf: cos theta_inf = d/L (40; A16), so v = s/L */
    struct span v_top; /* v of theta_u, at which a domino has its highest energy: tan theta_u = d */
    struct span g_top; /* h(theta_u) - 1 */
    double steepest;   /* sqrt(1 + d^2), the largest |dh/dtheta| */
    bool paper;        /* use the paper's closed form of the fuel */
    bool pair;         /* a train of two dominoes instead of the endless train */
};

/* The quantities of a chain at one growth r. */
struct corner {
    double r;
    struct span rs, rL, short_of; /* r s, r L, 1 - r s */
    struct span leave;            /* v at min(theta_leave, theta_inf), beyond which F is constant */
    double last;                  /* upper bound on v for all followers, from theta_f or theta_inf */
};

/* A train for all growths r of an interval with r s <= 1. */
struct growth {
    const struct shape *shape;
    struct span r;
    struct corner low, high;         /* the chain at the two ends of the interval */
    struct span leave;               /* v at min(theta_leave, theta_inf) for all growths of the interval */
    bool detaches_never;             /* theta_inf < theta_leave for all growths of the interval */
    struct span rq, weight, inertia; /* r^q, r^-q, r^-(q+1) */
};

/* One domino of a chain, for all tilts of the head and all growths of an interval. */
struct domino {
    struct span v;
    struct span slope; /* dtheta_i/dtheta >= 0 */
    struct span shift; /* dtheta_i/dr >= 0, for a head with a fixed tilt */
};

/* One contact: from domino i to domino i + 1. */
struct contact {
    struct span X, Y;  /* sine and cosine of theta_i+1 - theta_i */
    struct span x;     /* sin theta_i */
    struct span step;  /* dF/dtheta */
    struct span shift; /* dF/dr */
    bool held;         /* theta_i is beyond theta_leave in the whole box, so the follower stays at theta_f */
    bool may_hold;     /* theta_i is beyond theta_leave in a part of the box */
};

struct shape shape_make(double s, double d, double q);
struct growth growth_make(const struct shape *shape, double r_low, double r_high);

/* Returns sin theta for the tilts v. */
struct span tilt_sine(struct span v);

/* These two functions return g = h(theta) - 1 = d sin theta - v, and the derivative dh/dtheta, for the tilts
 * v. */
struct span tilt_height(const struct shape *shape, struct span v);
struct span tilt_rise(const struct shape *shape, struct span v);

/* Returns v of the follower of a domino with the tilts v. */
struct span chain_follow(const struct growth *growth, struct span v);

/* Returns the contact of a domino with its follower, including the derivatives. */
struct contact chain_contact(const struct growth *growth, struct span v);

/* Returns the follower of `leader`, including the derivatives. */
struct domino chain_next(const struct growth *growth, const struct domino *leader,
                         const struct contact *contact);

/* Returns the largest tilt that any follower reaches, theta_f or theta_inf, with its derivative dtheta/dr in
 * `shift`. */
struct domino chain_last(const struct growth *growth);

/* Returns v of theta_c, the tilt of domino 1 while the head is upright: sin theta_c = r s. */
struct span chain_hit(const struct growth *growth);

#endif
