/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Finds the first growth at which the margin K - B changes sign. There are two methods:
 * - scan.c is for endless trains with sharp edges and without friction. If the shortcut in root.c fails,
 *   scan.c walks upwards over strips, which are intervals of growths. If bounds (strip.h) show that the
 *   margin is positive over a strip, the walk goes on to the next strip. If they show that the strip contains
 *   a single root, the walk ends there. Otherwise the strip is divided. If it is too narrow for that, the
 *   walk goes on.
 * - probe.c is for all other trains, and for pairs. It takes samples of the margin. If the margin is so
 *   curved that it could change sign twice between two samples, probe.c takes more samples between them.
 */
#ifndef DOM_LIMIT_H
#define DOM_LIMIT_H

#include "growth/margin.h"
#include "growth/strip.h"

struct margin_sample {
    real r;
    struct margin margin;
};

/*
 * What is known about the margin over an interval of growths, if the margin is >= 0 at the lower end.
 * KNOWN_POSITIVE: the margin is positive over the interval. KNOWN_DECREASING: the margin is negative at the
 * upper end and has a single root in the interval.
 */
enum known { KNOWN_NOTHING, KNOWN_POSITIVE, KNOWN_DECREASING };

/* Finds the bounds of struct strip for all growths between lo and hi. */
KERNEL enum dom_status scan_bounds(struct margin_context *c, real lo, real hi, struct strip *strip);

/* Finds out what is known about the margin between the samples lo and hi and updates hi->margin. If the
 * margin at hi is not yet known, the caller sets hi->margin.kinetic to NaN. */
KERNEL enum dom_status scan_strip(struct margin_context *c, const struct margin_sample *lo,
                                  struct margin_sample *hi, enum known *known);

KERNEL real margin_falls(const struct margin_context *c, real r);

/* Finds a root of the margin between lo and hi. The margin must be >= 0 at lo and negative at hi. The search
 * follows one maximum of H from growth to growth. It does not notice if another maximum becomes higher. */
KERNEL enum dom_status root_between(struct margin_context *c, const struct margin_sample *lo,
                                    const struct margin_sample *hi, real *r);

/* Finds the root close to `near`. This estimate must be correct to ten digits. If no root is found there,
 * *found is false. */
KERNEL enum dom_status root_near(struct margin_context *c, real near, real *root, bool *found);

/*
 * Finds some root after *from for an endless train without friction. It need not be the first root. *falls
 * receives -d(margin)/dr at the root: the rate at which the margin falls there. If no root is found, *root is
 * infinity.
 */
KERNEL enum dom_status root_any(struct margin_context *c, const struct margin_sample *from, real *root,
                                real *falls);

/* Finds a root for an endless train with sharp edges and without friction. Also tries to prove that this root
 * is the first one after *from. If the margin is positive up to the reach, *root is the reach. If there is no
 * proof, *found is false. Even then, a part of the proof may have succeeded: if the margin is shown to be
 * positive up to some growth above *from, *from is raised to that growth. */
KERNEL enum dom_status root_first(struct margin_context *c, struct margin_sample *from, real *root,
                                  bool *found);

/* Finds a root of the margin between lo and hi. Unlike root_between, makes sure that the maximum of H at the
 * root is the highest one. Without friction, the margin must be >= 0 at lo and negative at hi. With friction,
 * the margins at lo and hi must have opposite signs. */
KERNEL enum dom_status scan_root(struct margin_context *c, const struct margin_sample *lo,
                                 const struct margin_sample *hi, real *r);

/*
 * Finds the first growth r > from->r at which the margin becomes negative. The train must be endless, with
 * sharp edges and without friction. The margin at from->r is >= 0. If the margin never becomes negative, *r
 * is the reach and *ends is DOM_END_REACH. The search can miss two sign changes if the distance between them
 * in ln r is less than SCAN_FINEST, or if both are less than SCAN_CLOSE below a later root. If c->coarse is
 * set, or in a search with very many strips, a larger distance takes the place of SCAN_FINEST (scan_finest).
 */
KERNEL enum dom_status scan_to_negative(struct margin_context *c, const struct margin_sample *from, real *r,
                                        enum dom_end *ends);

/*
 * Finds the smallest growth above from->r at which the margin changes sign. If the margin is >= 0 at from->r,
 * sets change->r to this growth. If the margin is negative at from->r, sets *change to a sample slightly
 * above this growth, where the margin is >= 0. Sets *found to false if the margin does not change sign up to
 * the reach. If the margin changes sign twice between two samples, both changes can be missed.
 */
KERNEL enum dom_status probe_change(struct margin_context *c, const struct margin_sample *from,
                                    struct margin_sample *change, bool *found);

struct limit {
    real r_max;
    enum dom_end ends;
    enum dom_status why; /* the reason, if r_max does not exist */
};

/* Finds r_max at the separation c->s. If c->near is set, looks close to it first. */
KERNEL enum dom_status limit_find(struct margin_context *c, struct limit *limit);

/* Starts counting the work of a search. If the work exceeds the limit, the search ends with DOM_TOO_LONG. */
KERNEL void limit_begin(struct margin_context *c);

#endif
