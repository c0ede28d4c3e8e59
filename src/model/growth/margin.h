/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The margin of kinetic energy over the barrier as a function of r: to the tolerance, or only as precisely as
 * its sign needs, or in search of a root.
 */
#ifndef DOM_MARGIN_H
#define DOM_MARGIN_H

#include "energy/barrier.h"

/* The kinetic energy after a collision or a push, and the barrier. */
struct margin {
    real kinetic, barrier;
    bool most;   /* `barrier` is only an upper bound */
    real unsure; /* error of the barrier, if it is larger than the tolerance (struct dynamics) */
    real error;
};

KERNEL real margin_value(const struct margin *m)
{
    return m->kinetic - m->barrier;
}

/* Returns the margin over the sum of its terms, a number between -1 and 1. */
KERNEL real margin_share(const struct margin *m)
{
    return margin_value(m) / (fabs(m->kinetic) + m->barrier + REAL_MIN);
}

struct margin_context {
    const struct request *train;
    struct geometry geometry; /* of the train, for any s and r */
    size_t dominoes;          /* number of moving dominoes: CHAIN_ENDLESS, or 2 for a pair */
    real s;
    enum dom_status (*margin)(const struct geometry *, struct margin_context *, struct margin *);
    enum margin_how {
        MARGIN_SURE, /* find the barrier by a search for all tops */
        /* use an upper bound of the barrier, or one of its tops, if that decides the sign of the margin */
        MARGIN_SIGN,
        MARGIN_TOPS,   /* use one of the tops if that decides the sign, but no upper bound */
        MARGIN_FOLLOW, /* follow one top from growth to growth */
    } how;
    struct barrier barrier; /* result of the last search */
    struct followed {
        real r, half;
    } last[2];              /* the last two tops that were followed */
    struct barrier nearest; /* the barrier where the margin was closest to 0 */
    real share;             /* margin_share at that barrier */
    real error;             /* error bound of the last margin if `errors` is set */
    bool errors;
    real followed_value, followed_tol; /* the last margin that was followed, and its tolerance */
    real coarse;   /* if > 0, the width of the narrowest strip, for a scan that only has to find a bound */
    bool locked;   /* friction has locked the train at the last r */
    size_t effort; /* work of the whole search, in the unit of geometry.effort */
    enum dom_status status;
};

/* Return the context of a search for the margin of the endless train (26; c8, corrected), and of the pair
 * (17; b13). */
KERNEL struct margin_context margin_of_train(const struct request *train);
KERNEL struct margin_context margin_of_pair(const struct request *train);

/* Returns the margin at r to the tolerance of the train. The context is a margin_context, whose status is
 * set. Returns NaN after an error. */
KERNEL real margin_at(real r, void *context);

/* Returns kinetic energy and barrier at r to the tolerance tol. */
KERNEL struct margin margin_rough(struct margin_context *c, real r, real tol);

/*
 * Returns the margin as precisely as its sign needs. Kinetic energy and barrier each have a tolerance, of
 * which the tails of all sums together take less than half.
 */
KERNEL struct margin margin_sign(struct margin_context *c, real r);

/* Returns the margin as margin_sign does. If the margin is positive, its barrier is right to the tolerance.
 */
KERNEL struct margin margin_tops(struct margin_context *c, real r);

/*
 * Returns margin_share at r, starting from the top of the barrier that was found last. On the way to a root
 * this share is less curved than the margin. It is computed only as precisely as the root search needs, whose
 * steps nearly square the share. margin_follow_begin comes before the first call.
 */
KERNEL void margin_follow_begin(struct margin_context *c);
KERNEL real margin_follow(real r, void *context);

/* Returns true if the top that was followed to the root r is the highest one at that growth. */
KERNEL bool margin_highest(const struct margin_context *c, real r);

#endif
