/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the files of a proof share: the chain of dominoes, the energies of a train, and proofs for all tilts
 * of a cycle and all growths in an interval. */
#pragma once

#pragma GCC visibility push(default) /* precision/shared.awk */
#include "domino_proof.h"
#pragma GCC visibility pop
#include "numerics/interrupt.h"
#include "proof/model/span.h"
#include <stddef.h>

/* ---- The chain (chain.c) ---- */

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
    /* v and 2 sin(theta/2) at theta_c, the tilt of domino 1 while the head is upright: sin theta_c = r s */
    struct span v_hit, hit;
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

/* ---- Energies (energy.c), in units of m g h / 2 of the head ---- */

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

/* ---- Proofs (cover.c) ---- */

enum outcome {
    OUTCOME_PROVED,  /* the train keeps falling for all growths in the interval */
    OUTCOME_REFUTED, /* the train stops at the upper end of the interval */
    OUTCOME_OPEN,    /* the proof failed; it may succeed for a narrower interval of growths */
    OUTCOME_LIMIT,   /* the proof would need too many dominoes or boxes */
    OUTCOME_INTERRUPTED
};

/* A proof in progress. */
struct proof {
    struct shape shape;
    /* the train for the whole interval of growths, and for the upper end of the interval */
    struct upright box, point;
    size_t boxes, chains; /* how many boxes have been tried, and how many chains have been computed */
    const volatile sig_atomic_t *interrupt;
};

/* Returns false if memory is exhausted. The caller frees proof->box.link, in which `point` has links, too. */
bool proof_begin(struct proof *proof, const struct shape *shape);

/* Tries to prove that the train keeps falling for all growths from r_low to r_high, by showing that K > D at
 * every tilt of the cycle. If `most` is not NULL, tries to prove that D < *most instead. */
enum outcome proof_strip(struct proof *proof, double r_low, double r_high, const double *most);

/*
 * Returns an estimate of the margin K - B, where B is the height of the barrier. Sets *top to an estimate of
 * 2 sin(theta/2), where theta is the tilt at the top of the barrier. These estimates prove nothing; they only
 * tell which proof to try. Returns NaN if the train cannot be computed, or after an interrupt.
 */
double proof_guess(struct proof *proof, double r, double *top);

/* Tries to enclose the smallest growth at which the train stops, as dom_prove_rmax says. If the proof remains
 * incomplete (DOM_PROVED_PARTLY), the result is the reason. */
enum outcome limit_prove(struct proof *proof, double tol, struct dom_proof *found);
