/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The first sign change of the margin as a function of r. scan.c samples the margin, and bounds (strip.h)
 * connect the samples: a strip of growths is passed only if K > B is known in all of it, or if the margin can
 * only decrease at every root in it. With friction no bound is known. probe.c then refines the samples
 * wherever their curvature allows a sign change between two of them.
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

/* What is known about the margin between two samples, the first of which is not negative. KNOWN_TO_FALL means
 * that the margin has at most one root there, at which it decreases. */
enum known { KNOWN_NOTHING, KNOWN_POSITIVE, KNOWN_TO_FALL };

/* Finds the bounds between two growths. */
KERNEL enum dom_status scan_bounds(struct margin_context *c, real lo, real hi, struct strip *strip);

/* Finds what is known between lo and hi. Computes hi->margin unless its kinetic energy is already known. */
KERNEL enum dom_status scan_strip(struct margin_context *c, const struct edge *lo, struct edge *hi,
                                  enum known *known);

/* Returns -d ln K / d ln r, roughly. */
KERNEL real margin_falls(const struct margin_context *c, real r);

/* Finds a root of the margin between lo and hi, where it has different signs, by following one top of the
 * barrier. */
KERNEL enum dom_status root_between(struct margin_context *c, const struct edge *lo, const struct edge *hi,
                                    real *r);

/* Finds the root next to `near`, which is a root to half of the digits of this arithmetic. *found is false if
 * there is no root. */
KERNEL enum dom_status root_near(struct margin_context *c, real near, real *root, bool *found);

/*
 * Guesses a root of an endless train without friction, finds it, and proves that it is the first root after
 * *from. If *found is false, *from has moved up, and the margin is positive up to *from.
 */
KERNEL enum dom_status foresee_root(struct margin_context *c, struct edge *from, real *root, bool *found);

/* Finds the root of the margin between lo and hi, where it has different signs. */
KERNEL enum dom_status scan_root(struct margin_context *c, const struct edge *lo, const struct edge *hi,
                                 real *r);

/*
 * Finds the first r > from->r at which the margin, which is >= 0 at from->r, becomes negative, without
 * friction. If there is none, *ends is DOM_END_REACH and *r is the reach. A dip of the margin below 0, or an
 * interval above 0, can be missed if it is narrower than SCAN_FINEST in ln r.
 */
KERNEL enum dom_status scan_to_negative(struct margin_context *c, const struct edge *from, real *r,
                                        enum dom_end *ends);

/*
 * Finds the first growth from `from` on at which the margin of the pair is not negative, to SCAN_FINEST in ln
 * r. A band of such growths that is narrower than SCAN_FINEST can be missed.
 */
KERNEL enum dom_status scan_to_positive(struct margin_context *c, real from, struct edge *edge, bool *found);

/*
 * Finds the first growth after from->r at which the margin changes its sign, which is between *before and
 * *after. *found is false if there is none up to the reach. This is no proof: a dip that neither the samples
 * around it nor the middle between them show is missed.
 */
KERNEL enum dom_status probe_change(struct margin_context *c, const struct edge *from, struct edge *before,
                                    struct edge *after, bool *found);

struct limit {
    real r_max;
    enum dom_end ends;
    enum dom_status why; /* the reason if r_max does not exist */
};

/* Finds r_max at the separation c->s. */
KERNEL enum dom_status limit_find(struct margin_context *c, struct limit *limit);

/* Finds a bound of the error of r_max. */
KERNEL enum dom_status limit_error(struct margin_context *c, const struct limit *limit, real *error);

/* Begins to count the work of a search, which ends with DOM_TOO_LONG when it takes too much. */
KERNEL void limit_begin(struct margin_context *c);

#endif
