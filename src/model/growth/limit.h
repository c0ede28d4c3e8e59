/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Finds the first growth at which the margin K - B changes its sign. For an endless train without friction
 * and with sharp edges, scan.c walks upwards over intervals of growths, called strips, and computes bounds on
 * the margin in each of them (strip.h). It goes past a strip only if the bounds show that the margin is
 * positive there, or if the strip is too narrow to divide. For other trains, and for pairs, probe.c relies on
 * samples: it adds a sample wherever the curvature of the margin leaves room for a sign change between two
 * samples. If the endless train has no friction, probe.c finds a root near an estimate first, so that its
 * samples only have to look for a smaller root.
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

/* What is known about the margin between two growths. At the smaller growth the margin is not negative.
 * KNOWN_TO_FALL means that the margin has at most one root between the two growths, and that it decreases at
 * that root. */
enum known { KNOWN_NOTHING, KNOWN_POSITIVE, KNOWN_TO_FALL };

/* Finds the bounds of struct strip for all growths between lo and hi. */
KERNEL enum dom_status scan_bounds(struct margin_context *c, real lo, real hi, struct strip *strip);

/* Finds out what is known about the margin between lo and hi. If hi->margin.kinetic is NaN, the margin at hi
 * has not been computed yet; this function then sets hi->margin. */
KERNEL enum dom_status scan_strip(struct margin_context *c, const struct edge *lo, struct edge *hi,
                                  enum known *known);

KERNEL real margin_falls(const struct margin_context *c, real r);

/* Finds a root of the margin between lo and hi. The margin must have opposite signs at lo and hi. The barrier
 * is found by following one local maximum of H from growth to growth. */
KERNEL enum dom_status root_between(struct margin_context *c, const struct edge *lo, const struct edge *hi,
                                    real *r);

/* Finds the root of the margin close to `near`, which must be correct to half of the digits of this
 * arithmetic. Sets *found to false if there is no root so close to `near`. */
KERNEL enum dom_status root_near(struct margin_context *c, real near, real *root, bool *found);

/* Predicts where a root lies for an endless train without friction, and then finds the root. This root need
 * not be the first one after *from. *falls receives -d margin / dr at the root. If no root is found, *root is
 * set to infinity. */
KERNEL enum dom_status root_foreseen(struct margin_context *c, const struct edge *from, real *root,
                                     real *falls);

/*
 * Predicts where a root lies for an endless train without friction, finds the root, and tries to prove that
 * it is the first root after *from. If the margin has no root up to the reach, tries to prove that instead,
 * and sets *root to the reach. Sets *found to false if there is no proof. *from may be moved up to a larger
 * growth if the margin is known to be positive up to there.
 */
KERNEL enum dom_status foresee_root(struct margin_context *c, struct edge *from, real *root, bool *found);

/* Finds the root of the margin between lo and hi. The margin must have opposite signs at lo and hi. */
KERNEL enum dom_status scan_root(struct margin_context *c, const struct edge *lo, const struct edge *hi,
                                 real *r);

/*
 * Finds the first r > from->r at which the margin becomes negative, without friction. The margin at from->r
 * is >= 0. If the margin is >= 0 up to the reach, *ends is DOM_END_REACH and *r is the reach. A dip of the
 * margin below 0, or a rise above 0, can be missed if it is narrower than SCAN_FINEST in ln r.
 */
KERNEL enum dom_status scan_to_negative(struct margin_context *c, const struct edge *from, real *r,
                                        enum dom_end *ends);

/*
 * Finds the first growth after from->r at which the margin changes its sign. If the margin is not negative at
 * from->r, change->r is the root; otherwise `change` is a sample shortly after the root. Sets *found to false
 * if the sign does not change up to the reach. The result is not proved: a dip between two samples can be
 * missed if the curvature of the margin at these samples does not point to it.
 */
KERNEL enum dom_status probe_change(struct margin_context *c, const struct edge *from, struct edge *change,
                                    bool *found);

struct limit {
    real r_max;
    enum dom_end ends;
    enum dom_status why; /* the reason, if r_max does not exist */
};

/* Finds r_max at the separation c->s. */
KERNEL enum dom_status limit_find(struct margin_context *c, struct limit *limit);

/* Finds the error bound on r_max. */
KERNEL enum dom_status limit_error(struct margin_context *c, const struct limit *limit, real *error);

/* Starts counting the work of a search. The search ends with DOM_TOO_LONG if its work exceeds the limit. */
KERNEL void limit_begin(struct margin_context *c);

#endif
