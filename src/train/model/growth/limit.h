/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The limits of growth.
 * - margin.c computes the margin K - B of a train or of a pair at one growth, and finds a root of it.
 * - first.c finds the first growth at which the margin changes sign.
 * - limit.c finds r_max, and how uncertain it is.
 * - best.c finds the separation with the largest r_max.
 */
#pragma once

#include "energy/barrier.h"

/* The margin of a train at the growth r: the kinetic energy after the collision, minus the barrier. */
struct margin {
    real r;
    real kinetic, barrier;
    bool is_bound;      /* true if `barrier` is only an upper bound */
    real barrier_error; /* an estimate; 0 without losses */
    real tol;           /* the tolerance to which the energies were computed */
};

KERNEL real margin_value(const struct margin *m)
{
    return m->kinetic - m->barrier;
}

/* A search for a limit: the train, and the state of the search. */
struct growth {
    const struct dom_train *train;
    struct geometry
        geometry; /* of the train, or of the pair, with n = 2; each margin sets s and r in a copy */
    real s;
    struct barrier barrier; /* the barrier found last; a search begins at this maximum of H */
    real near;              /* r_max from a coarser kernel, or 0 */
    bool hard;              /* true if the last root could not be found by following one maximum of H */
    bool locked;            /* true if friction locked the train at the last r */
    size_t effort;          /* work of the whole search, in the unit of geometry.effort */
    enum dom_status status;
};

/* Returns true if a search ends with this status. After any other error, another method may find the root. */
KERNEL bool growth_ends(enum dom_status status)
{
    return status == DOM_INTERRUPTED || status == DOM_TOO_LONG || status == DOM_NO_MEMORY;
}

/* Returns the variable x = -sqrt(1 - r/reach), which replaces the growth r here. The margin is a smooth
 * function of x. As a function of r, it is not smooth at the reach. */
KERNEL real x_of(const struct growth *g, real r)
{
    return -sqrt(fmax(1 - r * g->s / g->geometry.span, 0));
}

/* Checks the train and begins a search for the limits of the endless train, by equation (26; c8, corrected),
 * or of the pair, by equation (17; b13). If the work exceeds a limit, the search ends with DOM_TOO_LONG. */
KERNEL void growth_begin(const struct dom_train *train, const struct dom_compute *compute, bool pair,
                         real near, struct growth *g);

/* ---- The margin (margin.c). After an error, g->status is not DOM_OK, and the kinetic energy is NaN. ---- */

enum margin_how {
    MARGIN_SURE,  /* search for all local maxima of H */
    MARGIN_SIGN,  /* for the sign, an upper bound on the barrier or one maximum of H may be enough */
    MARGIN_FOLLOW /* without losses, follow one local maximum of H from growth to growth */
};

/* Returns the margin to the tolerance tol; 0 stands for all digits that the arithmetic allows. */
KERNEL struct margin margin_within(struct growth *g, real r, real tol);

/* Returns the margin, computed precisely enough to be sure of its sign if the arithmetic permits this. `tol`
 * is the tolerance to begin with. */
KERNEL struct margin margin_signed(struct growth *g, enum margin_how how, real r, real tol);

/* The tolerance with which margin_signed usually begins. */
#define MARGIN_ROUGH ((real)1e-3)

/* Returns an estimate of the error of a margin that was computed to the tolerance tol. */
KERNEL real margin_error(const struct growth *g, const struct margin *m, real tol);

/* The finest tolerance of a margin. */
KERNEL real margin_finest(const struct growth *g);

/* ---- Limits ---- */

struct limit {
    /* The first growth at which the margin changes sign, or the reach if it keeps its sign. If the margin is
     * negative at the start, this is a growth slightly above the sign change. */
    real r_max;
    real barrier;         /* at the growth r_max */
    struct margin beside; /* a margin close to the growth r_max, which tells how steeply the margin falls */
    enum dom_end ends;    /* DOM_END_BARRIER if the margin changes sign */
    enum dom_status why;  /* the reason, if r_max does not exist */
    /* The first growth below r_max at which the margin touches 0 within its rounding errors. Infinity if
     * there is none. */
    real open;
    /* the scaled margin at the minimum that is closest to 0, and its growth; infinity if none was found */
    real dip, low;
};

static const struct limit no_limit = {.r_max = REAL_NAN,
                                      .ends = DOM_END_NONE,
                                      .open = (real)INFINITY,
                                      .dip = (real)INFINITY,
                                      .low = (real)INFINITY};

/* Finds a root of the margin between lo and hi, where the margin has opposite signs, and sets r_max, barrier
 * and beside of *limit. If `follow` is true, first follows one maximum of H from growth to growth. */
KERNEL enum dom_status root_between(struct growth *g, const struct margin *lo, const struct margin *hi,
                                    bool follow, struct limit *limit);

/* Does the same for some root of an endless train without losses, above the growth `from`. It need not be the
 * first root. Returns false if none is easy to find. */
KERNEL bool root_guessed(struct growth *g, real from, struct limit *limit);

/* Does the same for a root that a coarser kernel has found near g->near. Returns false if it is not there. */
KERNEL bool root_near(struct growth *g, struct limit *limit);

/* Finds the smallest growth above from->r at which the margin changes sign. */
KERNEL enum dom_status first_change(struct growth *g, const struct margin *from, struct limit *limit);

/* Finds r_max at the separation g->s. If g->near is set, looks close to it first. */
KERNEL enum dom_status limit_find(struct growth *g, struct limit *limit);

/* Finds how far r_max may be from the exact value, because of rounding errors and the tolerance. */
KERNEL enum dom_status limit_uncertainty(struct growth *g, const struct limit *limit, real *uncertainty);

/* Find the answers of dom_limit_rmax, of dom_limit_pair if `pair` is true, and of dom_limit_best, in one
 * arithmetic alone. `near` is r_max as double has found it, at train->s, or 0. They are not static, because
 * another precision calls them (entry/other.h). */
enum dom_status limit_answer(const struct dom_train *train, const struct dom_compute *compute, bool pair,
                             real near, struct dom_limit *limit);
enum dom_status limit_best(const struct dom_train *train, const struct dom_compute *compute, real near,
                           struct dom_best *best);
