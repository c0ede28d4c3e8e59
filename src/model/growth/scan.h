/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The first sign change of the margin as a function of r, between samples that bounds connect (strip.h): a
 * strip of growths is passed only where K > B is known for all of it, or where every root in it can only be a
 * fall.
 */
#ifndef DOM_SCAN_H
#define DOM_SCAN_H

#include "growth/margin.h"
#include "growth/strip.h"

/* A sample of the scan. */
struct edge {
    real r;
    struct margin margin;
};

/* The root of the margin between lo and hi, where it has different signs. */
KERNEL enum dom_status scan_root(struct margin_context *c, const struct edge *lo, const struct edge *hi,
                                 real *r);

/*
 * First r > from->r at which the margin, >= 0 there, is negative; ends is DOM_END_REACH, and r the reach, if
 * there is none.  Without friction.  What may be missed is a dip, or a rise of the margin above 0, that
 * begins and ends within SCAN_FINEST of ln r.
 */
KERNEL enum dom_status scan_fall(struct margin_context *c, const struct edge *from, real *r,
                                 enum dom_end *ends);

/*
 * The first growth from `from` on at which the margin of the pair is not negative, where it is right to
 * SCAN_FINEST or where a band that is as narrow may be missed.
 */
KERNEL enum dom_status scan_energy_change(struct margin_context *c, real from, struct edge *edge,
                                          bool *found);

#endif
