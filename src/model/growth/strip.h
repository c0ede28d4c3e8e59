/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Bounds for every train between two: a strip of growths at one separation, or of separations at one growth.
 * If a domino that has detached counts with theta_f, every tilt theta_i(theta) increases with r and with s,
 * every slope theta_i' decreases with both, and so does d theta_i / dr (or ds) with theta:
 *
 *     d theta_1 / d ln r = X / Y,   d theta_1 / ds = r cos theta / Y,   theta_1' = 1 - r L sin theta / Y.
 *
 * X = r (L cos theta - d) makes all of these monotone, and a chain multiplies and adds only terms that are
 * not negative. So the two chains at the ends of a strip enclose the chains of all trains in it. The bounds
 * are computed with ordinary rounding: STRIP_SLACK keeps them on the safe side of rounding errors, but they
 * are no proof in interval arithmetic.
 */
#ifndef DOM_STRIP_H
#define DOM_STRIP_H

#include "energy/barrier.h"

struct strip {
    real kinetic_least, kinetic_most; /* K over the strip; kinetic_most is infinite if unknown */
    /*
     * Largest factor by which g(theta_i(0)), g = sin - d cos, of a follower increases over the strip;
     * infinite if a follower is before theta_u.
     */
    real grows;
    real cut;   /* upper bound of the height that followers beyond those of `grows` can still lose */
    real drops; /* upper bound of -d barrier / d ln r, or of -d barrier / ds, over the strip, >= 0 */
    /* Upper bounds of d margin / d ln r over a strip in r. The first holds everywhere, the second where the
     * barrier is at least kinetic_least, as it is at every root. */
    real margin_slope, root_slope;
    bool clear; /* K exceeds `enough` over the whole strip; the walk has ended, and only kinetic_least is set
                 */
};

/*
 * Computes the bounds for the trains between lo and hi, without friction. hi has the larger r, or the larger
 * s. The walk ends as soon as K > enough is known for all trains. tol is the tolerance of K that is left to
 * the tails of the chains.
 */
KERNEL enum dom_status strip_walk(const struct geometry *lo, const struct geometry *hi, enum dom_fuel fuel,
                                  real enough, real tol, struct strip *strip);

/*
 * Return bounds of the barriers of all trains in the strip: an upper bound from the barrier of hi, and a
 * lower bound from the barrier of lo. `most` is an upper bound of every barrier, and `width` is ln r, or s,
 * of hi minus that of lo.
 */
KERNEL real strip_barrier_most(const struct strip *strip, real hi_barrier, real most, real width);
KERNEL real strip_barrier_least(const struct strip *strip, real lo_barrier, real most, real width);

#endif
