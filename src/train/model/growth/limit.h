/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The limits of growth.
 * - margin.c computes the margin K - B of a train or of a pair.
 * - root.c finds a root of the margin, from a guess or from a bracket.
 * - first.c finds the first growth at which the margin changes sign.
 * - limit.c finds r_max, and how uncertain it is.
 * - best.c finds the separation with the largest r_max.
 */
#ifndef DOM_LIMIT_H
#define DOM_LIMIT_H

#include "growth/margin.h"

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

struct change {
    bool found;
    /* If the margin is >= 0 at the start: the first growth at which it becomes negative. If
     * the margin is negative at the start: a sample slightly above the first growth at which the margin
     * becomes positive. */
    struct margin_sample at;
    real falls; /* as in struct root, at the growth `at` */
    /* The first growth below `at` at which the margin touches 0 within its rounding errors. Infinity if there
     * is none. */
    real open;
    real dip; /* the scaled margin at the minimum that is closest to 0; infinity if none was found */
};

/* Finds the smallest growth above from->r at which the margin changes sign. If the margin keeps its sign up
 * to the reach, `found` is false. */
KERNEL enum dom_status first_change(struct margin_context *c, const struct margin_sample *from,
                                    struct change *change);

struct limit {
    real r_max, barrier, falls;
    enum dom_end ends;
    enum dom_status why; /* the reason, if r_max does not exist */
    real open, dip;      /* as in struct change */
};

/* Finds r_max at the separation c->s. If c->near is set, looks close to it first. */
KERNEL enum dom_status limit_find(struct margin_context *c, struct limit *limit);

/* Finds how far r_max may be from the exact value, because of rounding errors and the tolerance. */
KERNEL enum dom_status limit_uncertainty(struct margin_context *c, const struct limit *limit,
                                         real *uncertainty);

/* Starts counting the work of a search. If the work exceeds the limit, the search ends with DOM_TOO_LONG. */
KERNEL void limit_begin(struct margin_context *c);

#endif
