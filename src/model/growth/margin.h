/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The margin K - B of a train as a function of r: kinetic energy minus barrier. The margin is computed to the
 * tolerance, or only as precisely as a root search or the sign of the margin requires.
 */
#ifndef DOM_MARGIN_H
#define DOM_MARGIN_H

#include "energy/barrier.h"

/* The kinetic energy after a collision or a push, and the barrier. */
struct margin {
    real kinetic, barrier;
    bool most;   /* true if `barrier` is only an upper bound */
    real unsure; /* with friction, an estimate of the error of the barrier (`unsure` in struct dynamics) */
    real error;
};

KERNEL real margin_value(const struct margin *m)
{
    return m->kinetic - m->barrier;
}

/* Returns (K - B) / (|K| + B), a number between -1 and 1. */
KERNEL real margin_share(const struct margin *m)
{
    return margin_value(m) / (fabs(m->kinetic) + m->barrier + REAL_MIN);
}

struct margin_context {
    const struct request *train;
    struct geometry geometry; /* geometry of the train, whose s and r are set for each margin */
    size_t dominoes;          /* number of moving dominoes: CHAIN_ENDLESS, or 2 for a pair */
    real s;
    enum dom_status (*margin)(const struct geometry *, struct margin_context *, struct margin *);
    enum margin_how {
        MARGIN_SURE, /* find the barrier by a search for all local maxima of H */
        /* use an upper bound on the barrier, or one local maximum of H, if that decides the sign of the
         * margin */
        MARGIN_SIGN,
        /* use one local maximum of H if that decides the sign of the margin, but never an upper bound on the
         * barrier */
        MARGIN_TOPS,
        MARGIN_FOLLOW, /* follow one local maximum of H from growth to growth */
    } how;
    struct barrier barrier; /* the barrier found by the last search */
    struct followed {
        real r, half;
    } last[2];              /* the growths and tan(tilt / 2) of the last two maxima that were followed */
    struct barrier nearest; /* the barrier at the growth where the margin was closest to 0 */
    real share;             /* absolute value of margin_share at the growth of `nearest` */
    real error;             /* error bound on the last margin if `errors` is set */
    bool errors;
    real followed_value, followed_tol; /* the last margin found by margin_follow, and its tolerance */
    /* If > 0, the width in ln r of the narrowest strip of a scan. Set if the result of the scan need only be
     * an upper bound on r_max. */
    real coarse;
    real near;     /* r_max at a separation close to s, as found by a coarser kernel, or 0 */
    bool locked;   /* true if friction locked the train at the last r */
    size_t effort; /* work of the whole search, in the unit of geometry.effort */
    enum dom_status status;
};

/* These two functions return contexts: one for the margin of the endless train (26; c8, corrected), and one
 * for the margin of the pair (17; b13). */
KERNEL struct margin_context margin_of_train(const struct request *train);
KERNEL struct margin_context margin_of_pair(const struct request *train);

/* Returns the margin at r to the tolerance of the train, or NaN after an error. The context is a struct
 * margin_context, which receives the status. */
KERNEL real margin_at(real r, void *context);

/* Returns the kinetic energy and the barrier at r, both to the tolerance tol. */
KERNEL struct margin margin_rough(struct margin_context *c, real r, real tol);

/* Returns the margin, as precisely as its sign requires. */
KERNEL struct margin margin_sign(struct margin_context *c, real r);

/* Returns the margin as margin_sign does, but if the margin is positive, its barrier is correct to the
 * tolerance. */
KERNEL struct margin margin_tops(struct margin_context *c, real r);

/*
 * margin_follow returns margin_share at r, which near a root is less curved than the margin. Each call begins
 * its search for the maximum of H at the maximum of the previous call. A step of a root search nearly squares
 * margin_share, so only the digits that affect the next step are computed. Call margin_follow_begin first.
 */
KERNEL void margin_follow_begin(struct margin_context *c);
KERNEL real margin_follow(real r, void *context);

/* Returns true if H has no higher maximum at the root r than the one that the search has followed there. */
KERNEL bool margin_highest(const struct margin_context *c, real r);

#endif
