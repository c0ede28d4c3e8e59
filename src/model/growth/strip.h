/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Bounds that hold for every train between two: a strip of growths at one separation, or of separations at
 * one growth.
 *
 * With a domino that has detached held at theta_f, every tilt theta_i(theta) increases with r and with s,
 * every slope theta_i' decreases with both, and so does d theta_i / dr (or ds) with theta: d theta_1 / d ln r
 * = X / Y,   d theta_1 / ds = r cos theta / Y,   theta_1' = 1 - r L sin theta / Y, all of which X = r (L cos
 * theta - d) makes monotone, and a chain multiplies and adds only terms that are not negative.  So the two
 * chains at the ends of a strip enclose the chains of all trains in it.
 *
 * The bounds are computed with ordinary rounding: STRIP_SLACK keeps them on the safe side of it, but they are
 * no proof for intervals of numbers.
 */
#ifndef DOM_STRIP_H
#define DOM_STRIP_H

#include "energy/barrier.h"

struct strip {
    real kinetic_least, kinetic_most; /* K over the strip; kinetic_most is infinite where unknown */
    /*
     * Largest factor by which g(theta_i(0)), g = sin - d cos, of a follower grows over the strip; infinite
     * where one stands before theta_u.
     */
    real grows;
    real cut;          /* what the followers beyond those of `grows` can still lose */
    real drops;        /* bound of -d barrier / d ln r, or of -d barrier / ds, over the strip, >= 0 */
    real margin_slope; /* bound of d margin / d ln r from above, over the strip; of a strip in r */
    bool clear; /* K exceeds `enough` over the strip: the walk ended there, and only kinetic_least is set */
};

/*
 * Fills strip for the trains between lo and hi: hi has the larger r, or the larger s.  The walk ends as soon
 * as K > enough is known for all of them; tol: what the tails of the chains may take from K. DOM_INTERRUPTED,
 * DOM_TOO_LONG as every walk.  Without friction.
 */
KERNEL enum dom_status strip_walk(const struct geometry *lo, const struct geometry *hi, enum dom_fuel fuel,
                                  real enough, real tol, struct strip *strip);

/*
 * Bounds of the barriers of all trains in the strip: from above, given that of hi, and from below, given that
 * of lo.  most: of every barrier; width: ln r, or s, of hi less that of lo.
 */
KERNEL real strip_barrier_most(const struct strip *strip, real hi_barrier, real most, real width);
KERNEL real strip_barrier_least(const struct strip *strip, real lo_barrier, real most, real width);

#endif
