/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * What is left of the kinetic energy behind the barrier, as a function of r: exactly, or as roughly as shows
 * its sign, or along a root.
 */
#ifndef DOM_MARGIN_H
#define DOM_MARGIN_H

#include "energy/barrier.h"

/* What a cycle, or a push, leaves to climb with, and the barrier. */
struct margin {
    real kinetic, barrier;
    bool most; /* the barrier is only the highest that it can be */
    real error;
};

KERNEL real margin_value(const struct margin *m)
{
    return m->kinetic - m->barrier;
}

/* Between -1 and 1. */
KERNEL real margin_share(const struct margin *m)
{
    return margin_value(m) / (fabs(m->kinetic) + m->barrier + REAL_MIN);
}

struct margin_context {
    const struct request *train;
    struct geometry geometry; /* of the train, for any s and r */
    size_t dominoes;          /* that are in motion: CHAIN_ENDLESS, or a pair */
    real s;
    enum dom_status (*margin)(const struct geometry *, struct margin_context *, struct margin *);
    enum {
        MARGIN_SURE,   /* the barrier by a search for all tops */
        MARGIN_SIGN,   /* or, where that has the same sign, for the highest that it can be, or for one of its
                          tops */
        MARGIN_FOLLOW, /* one top, from r to r */
    } how;
    struct barrier barrier; /* of the last search */
    struct followed {
        real r, half;
    } last[2];              /* tops that were followed */
    struct barrier nearest; /* the one where the margin was closest to 0 */
    real share;             /* that it was, then */
    real error;             /* bound of that of the last margin, where wanted */
    bool errors;
    real coarse;   /* where > 0, the narrowest strip of a scan of r that only has to find a bound */
    bool locked;   /* by friction, at the last r */
    size_t effort; /* of the whole search, as geometry.effort counts it */
    enum dom_status status;
};

/* Of a train, with room for what a search keeps: of the endless one (c8, corrected), or of the pair (b13). */
KERNEL struct margin_context margin_of_train(const struct request *train);
KERNEL struct margin_context margin_of_pair(const struct request *train);

/* Sine and cosine of theta_c - theta_u: before theta_u domino 1 has not tipped over when it hits (b0). */
KERNEL void pair_tips(const struct geometry *geometry, real *sine, real *cosine);

/* tau_1^2 omega_1c^2 = h(theta_u) - h(theta_c) (b5), without cancellation: 0 where domino 1 has not tipped
 * over. */
KERNEL real pair_push(const struct geometry *geometry);

/* At r, to the train's tolerance; context is a margin_context. NaN, with its status, where it fails. */
KERNEL real margin_at(real r, void *context);

/* The same, both parts of it, to the tolerance tol. */
KERNEL struct margin margin_rough(struct margin_context *c, real r, real tol);

/*
 * Where its sign is what is wanted: as roughly as shows it.  Kinetic energy and barrier keep a tolerance
 * each, where the tails of all their sums together are less than half of it.
 */
KERNEL struct margin margin_sign(struct margin_context *c, real r);

/*
 * The margin_share at r, from the top of the barrier that was found last, which bends less on the way to a
 * root, and as roughly as serves: the steps of a search nearly square it.  margin_follow_begin goes before
 * the first.
 */
KERNEL void margin_follow_begin(struct margin_context *c);
KERNEL real margin_follow(real r, void *context);

/* Is the top that was followed to the root r the highest there? */
KERNEL bool margin_highest(const struct margin_context *c, real r);

#endif
