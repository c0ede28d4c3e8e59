/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The first sign change of the margin as a function of r. scan.c: bounds (strip.h) connect the samples. A
 * strip of growths is passed only if K > B is known for all of it, or if the margin can only decrease through
 * every root in it. probe.c, with friction, where no bound is known: samples, refined where the curvature
 * that they show allows a sign change between two of them.
 */
#ifndef DOM_LIMIT_H
#define DOM_LIMIT_H

#include "growth/margin.h"
#include "growth/strip.h"

/* A sample of the scan. */
struct edge {
    real r;
    struct margin margin;
};

/* What is known of the margin between two samples, the first of which is not negative. */
enum known { KNOWN_NOTHING, KNOWN_POSITIVE, KNOWN_TO_FALL /* decreasing through 0 at most once */ };

/* Finds the bounds between two growths. */
KERNEL enum dom_status scan_bounds(struct margin_context *c, real lo, real hi, struct strip *strip);

/* Finds what is known between lo and hi. hi->margin is computed unless its kinetic energy is known. */
KERNEL enum dom_status scan_strip(struct margin_context *c, const struct edge *lo, struct edge *hi,
                                  enum known *known);

/* Returns -d ln K / d ln r, roughly. */
KERNEL real margin_falls(const struct margin_context *c, real r);

/* Finds a root of the margin between lo and hi, where it has different signs, by following one top of the
 * barrier. */
KERNEL enum dom_status root_between(struct margin_context *c, const struct edge *lo, const struct edge *hi,
                                    real *r);

/* Finds the root next to `near`, which is a root to half of the digits of this arithmetic. *found is false if
 * it is not there. */
KERNEL enum dom_status root_near(struct margin_context *c, real near, real *root, bool *found);

/*
 * Finds a root from a guess, for an endless train without friction, and proves that it is the first after
 * *from. If *found is false, the margin is positive up to *from, which has moved up.
 */
KERNEL enum dom_status foresee_root(struct margin_context *c, struct edge *from, real *root, bool *found);

/* Finds the root of the margin between lo and hi, where it has different signs. */
KERNEL enum dom_status scan_root(struct margin_context *c, const struct edge *lo, const struct edge *hi,
                                 real *r);

/*
 * Finds the first r > from->r at which the margin, >= 0 at from->r, is negative, without friction. If there
 * is none, *ends is DOM_END_REACH and *r the reach. A dip of the margin, or an interval where it is above 0,
 * can be missed if it is narrower than SCAN_FINEST in ln r.
 */
KERNEL enum dom_status scan_to_negative(struct margin_context *c, const struct edge *from, real *r,
                                        enum dom_end *ends);

/*
 * Finds the first growth from `from` on at which the margin of the pair is not negative, to SCAN_FINEST in ln
 * r. A band of such growths that is narrower than SCAN_FINEST can be missed.
 */
KERNEL enum dom_status scan_to_positive(struct margin_context *c, real from, struct edge *edge, bool *found);

/*
 * Finds the first growth after from->r at which the margin changes its sign, between *before and *after.
 * *found is false if there is none up to the reach. This proves nothing: a dip can be missed that shows
 * neither in its neighbours nor in the middle between them.
 */
KERNEL enum dom_status probe_change(struct margin_context *c, const struct edge *from, struct edge *before,
                                    struct edge *after, bool *found);

struct limit {
    real r_max;
    enum dom_end ends;
    enum dom_status why; /* the reason why r_max does not exist */
};

/* Finds r_max at the separation c->s. */
KERNEL enum dom_status limit_find(struct margin_context *c, struct limit *limit);

/* Finds a bound of the error of r_max. */
KERNEL enum dom_status limit_error(struct margin_context *c, const struct limit *limit, real *error);

/* Begins to count the work of a search, which then ends with DOM_TOO_LONG at a limit. */
KERNEL void limit_begin(struct margin_context *c);

#endif
