/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The limits of growth.
 * - margin.c computes the margin K - B of a train or of a pair, and finds a root of it, from a guess or from
 * a bracket.
 * - first.c finds the first growth at which the margin changes sign.
 * - limit.c finds r_max, and how uncertain it is.
 * - best.c finds the separation with the largest r_max.
 */
#pragma once

#include "energy/barrier.h"

/* ---- The margin K - B of a train as a function of r: kinetic energy minus barrier ---- */

/* The kinetic energy after the collision, and the barrier. */
struct margin {
    real kinetic, barrier;
    bool barrier_is_bound; /* true if `barrier` is only an upper bound */
    real barrier_error;    /* an estimate; 0 without friction */
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
    const struct dom_train *train;
    struct geometry geometry; /* geometry of the train; each margin sets s and r in a copy */
    real s;
    struct margin_point {
        real r, value;
    } beside; /* the last margin that was not almost 0 */
    enum dom_status (*margin)(const struct geometry *, struct margin_context *, struct margin *);
    enum margin_how {
        MARGIN_SURE,  /* find the barrier by a search for all local maxima of H */
        MARGIN_SIGN,  /* find the sign: an upper bound on the barrier or one maximum of H may be enough */
        MARGIN_FOLLOW /* follow one local maximum of H from growth to growth */
    } how;
    struct barrier barrier; /* the barrier found by the last search */
    struct barrier nearest; /* the barrier at the growth with the smallest |margin_share| so far */
    /* The smallest |margin_share| so far. margin_follow derives its tolerance from this number. */
    real share;
    real followed_value, followed_tol; /* the last margin of margin_follow, and its tolerance */
    real near;                         /* r_max from a coarser kernel, or 0 */
    bool locked;                       /* true if friction locked the train at the last r */
    size_t effort;                     /* work of the whole search, in the unit of geometry.effort */
    enum dom_status status;
};

/* These functions return the contexts of the endless train, by equation (26; c8, corrected), and of the pair,
 * by equation (17; b13). */
KERNEL struct margin_context margin_of_train(const struct dom_train *train,
                                             const struct dom_compute *compute);
KERNEL struct margin_context margin_of_pair(const struct dom_train *train, const struct dom_compute *compute);

/* Returns the margin at the growth r. K and B are computed to the tolerance geometry.tol. After an error,
 * returns NaN. `context` must point to a struct margin_context, which receives the status. */
KERNEL real margin_at(real r, void *context);

/* Returns the margin to the tolerance tol; 0 stands for all digits that the arithmetic allows. The kinetic
 * energy is NaN after an error. */
KERNEL struct margin margin_within(struct margin_context *c, real r, real tol);

/* If the kinetic energy exceeds MARGIN_HIGH barrier_most, margin_sign does not search for the barrier. */
#define MARGIN_HIGH 1

/* Returns the margin, computed precisely enough to be sure of its sign if the arithmetic permits this. If
 * `bound` is true, an upper bound may take the place of the barrier. */
KERNEL struct margin margin_sign(struct margin_context *c, real r, bool bound);

/* Returns an estimate of the error of a margin that was computed to the tolerance tol. */
KERNEL real margin_error(const struct margin_context *c, const struct margin *m, real tol);

/* The finest tolerance of a margin. */
KERNEL real margin_finest(const struct margin_context *c);

/* ---- Its roots ---- */

struct margin_sample {
    real r;
    struct margin margin;
};

/* A root of the margin, the barrier there, and how steeply the margin falls: -d(margin)/dr between `beside`,
 * a growth close to the root, and the root. If the slope is unknown, `falls` is 0. */
struct root {
    real r, barrier, falls, beside;
};

/* Finds a root of the margin between lo and hi, where the margin has opposite signs. If `follow` is true,
 * first follows one maximum of H from growth to growth. If another maximum is higher at the root that it
 * finds, starts again with a search for all maxima at each growth. */
KERNEL enum dom_status root_between(struct margin_context *c, const struct margin_sample *lo,
                                    const struct margin_sample *hi, bool follow, struct root *root);

/* Finds some root above the growth `from` for an endless train. It need not be the first root. If `near` is
 * not 0, looks only close to this estimate, which must be correct to ten digits; otherwise the train must be
 * without losses. If no root is found, root->r is infinity. */
KERNEL enum dom_status root_any(struct margin_context *c, real from, real near, struct root *root);

struct limit {
    /* The first growth at which the margin changes sign, or the reach if it keeps its sign. If the margin is
     * negative at the start, this is a growth slightly above the sign change. */
    real r_max;
    real barrier, falls; /* as in struct root, at the growth r_max */
    enum dom_end ends;   /* DOM_END_BARRIER if the margin changes sign */
    enum dom_status why; /* the reason, if r_max does not exist */
    /* The first growth below r_max at which the margin touches 0 within its rounding errors. Infinity if
     * there is none. */
    real open;
    real dip; /* the scaled margin at the minimum that is closest to 0; infinity if none was found */
};

/* Finds the smallest growth above from->r at which the margin changes sign. */
KERNEL enum dom_status first_change(struct margin_context *c, const struct margin_sample *from,
                                    struct limit *limit);

/* Finds r_max at the separation c->s. If c->near is set, looks close to it first. */
KERNEL enum dom_status limit_find(struct margin_context *c, struct limit *limit);

/* Finds how far r_max may be from the exact value, because of rounding errors and the tolerance. */
KERNEL enum dom_status limit_uncertainty(struct margin_context *c, const struct limit *limit,
                                         real *uncertainty);

/* Find the answers of dom_limit_rmax, of dom_limit_pair if `pair` is true, and of dom_limit_best. `near` is
 * r_max as double has found it, or 0. */
KERNEL enum dom_status limit_answer(const struct dom_train *train, const struct dom_compute *compute,
                                    bool pair, real near, struct dom_limit *limit);
KERNEL enum dom_status limit_best(const struct dom_train *train, const struct dom_compute *compute, real near,
                                  struct dom_best *best);

/* Starts counting the work of a search. If the work exceeds the limit, the search ends with DOM_TOO_LONG. */
KERNEL void limit_begin(struct margin_context *c);
