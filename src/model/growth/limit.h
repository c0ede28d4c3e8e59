/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Finds the first growth at which the margin K - B changes sign.
 * - scan.c: endless trains with sharp edges and without friction. It walks upwards over strips, which are
 *   intervals of growths. It goes past a strip if bounds (strip.h) show that the margin is positive there, or
 *   if the strip is too narrow to divide.
 * - probe.c: all other trains, and pairs. It takes samples, and adds more where the curvature of the margin
 *   leaves room for a sign change between two of them.
 */
#ifndef DOM_LIMIT_H
#define DOM_LIMIT_H

#include "growth/margin.h"
#include "growth/strip.h"

/* A sample of the scan. */
struct margin_sample {
    real r;
    struct margin margin;
};

/* What is known about the margin over an interval of growths. The margin is >= 0 at the lower end.
 * KNOWN_DECREASING: the margin has at most one root in the interval, and decreases at this root. */
enum known { KNOWN_NOTHING, KNOWN_POSITIVE, KNOWN_DECREASING };

/* Finds the bounds of struct strip for all growths between lo and hi. */
KERNEL enum dom_status scan_bounds(struct margin_context *c, real lo, real hi, struct strip *strip);

/* Finds out what is known about the margin between lo and hi, and updates hi->margin. On entry,
 * hi->margin.kinetic is NaN if the margin at hi is unknown. */
KERNEL enum dom_status scan_strip(struct margin_context *c, const struct margin_sample *lo,
                                  struct margin_sample *hi, enum known *known);

KERNEL real margin_falls(const struct margin_context *c, real r);

/* Finds a root of the margin between lo and hi, where the margin must have opposite signs. Follows one
 * maximum of H. */
KERNEL enum dom_status root_between(struct margin_context *c, const struct margin_sample *lo,
                                    const struct margin_sample *hi, real *r);

/* Finds the root close to `near`, an estimate that must be correct to ten digits. *found is false if this
 * fails. */
KERNEL enum dom_status root_near(struct margin_context *c, real near, real *root, bool *found);

/* Finds a root for an endless train without friction, not necessarily the first after *from. *falls receives
 * -d(margin)/dr, the rate at which the margin falls at the root. Without a root, *root is infinity. */
KERNEL enum dom_status root_any(struct margin_context *c, const struct margin_sample *from, real *root,
                                real *falls);

/*
 * Finds a root for an endless train without friction, and tries to prove that it is the first after *from.
 * *root is the reach if there is no root. *found is false if there is no proof. *from may be raised to a
 * larger growth, if the margin is positive up to that growth.
 */
KERNEL enum dom_status root_first(struct margin_context *c, struct margin_sample *from, real *root,
                                  bool *found);

/* Finds the root of the margin between lo and hi, where the margin must have opposite signs. */
KERNEL enum dom_status scan_root(struct margin_context *c, const struct margin_sample *lo,
                                 const struct margin_sample *hi, real *r);

/*
 * For an endless train with sharp edges and without friction, finds the first r > from->r with a negative
 * margin. The margin at from->r is >= 0. If there is no such r, *r is the reach and *ends is DOM_END_REACH.
 * Two sign changes closer than SCAN_FINEST in ln r can be missed.
 */
KERNEL enum dom_status scan_to_negative(struct margin_context *c, const struct margin_sample *from, real *r,
                                        enum dom_end *ends);

/*
 * Finds the first sign change of the margin after from->r. change->r is the root, if the margin at from->r is
 * >= 0. Otherwise *change is a sample shortly after the root. *found is false if there is no sign change up
 * to the reach. A dip between two samples can be missed.
 */
KERNEL enum dom_status probe_change(struct margin_context *c, const struct margin_sample *from,
                                    struct margin_sample *change, bool *found);

struct limit {
    real r_max;
    enum dom_end ends;
    enum dom_status why; /* the reason, if r_max does not exist */
};

/* Finds r_max at the separation c->s. */
KERNEL enum dom_status limit_find(struct margin_context *c, struct limit *limit);

/* Finds the error bound on r_max. */
KERNEL enum dom_status limit_error(struct margin_context *c, const struct limit *limit, real *error);

/* Starts counting the work of a search. If the work exceeds the limit, the search ends with DOM_TOO_LONG. */
KERNEL void limit_begin(struct margin_context *c);

#endif
