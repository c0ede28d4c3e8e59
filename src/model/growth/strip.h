/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Bounds for all trains between two given ones. A strip is an interval of growths at one separation, or an
 * interval of separations at one growth. A domino that has detached is taken to stay at theta_f. Then every
 * tilt theta_i(theta) increases with r and with s, every slope theta_i' decreases with r and s, and d theta_i
 * / dr (or d theta_i / ds) decreases with theta:
 *
 *     d theta_1 / d ln r = X / Y,   d theta_1 / ds = r cos theta / Y,   theta_1' = 1 - r L sin theta / Y.
 *
 * X = r (L cos theta - d) makes all of these monotone, and a chain only multiplies and adds terms that are
 * not negative. So the two chains at the ends of a strip enclose the chains of all trains in it. The bounds
 * are computed with ordinary rounding. STRIP_SLACK allows for rounding errors, but this is not a proof by
 * interval arithmetic.
 */
#ifndef DOM_STRIP_H
#define DOM_STRIP_H

#include "energy/barrier.h"

struct strip {
    /* Bounds on K over the strip. kinetic_least is a bound only if it is positive. */
    real kinetic_least, kinetic_most;
    /* Let g(theta) = sin theta - d cos theta. `grows` is the largest factor by which g(theta_i(0)) of any
     * follower i increases over the strip. It is infinite if a follower has not yet reached theta_u. */
    real grows;
    /* `grows` does not cover the followers at the end of the chain. `cut` is an upper bound on the energy
     * that these followers can still lose. */
    real cut;
    real drops; /* upper bound on -d barrier / d ln r, or on -d barrier / ds, in the whole strip; >= 0 */
    /* Upper bounds on d margin / d ln r over a strip of growths. margin_slope holds in the whole strip.
     * root_slope holds wherever the barrier is at least kinetic_least, and therefore at every root of the
     * margin. */
    real margin_slope, root_slope;
    /* True if K exceeds `enough` over the whole strip. The walk ends as soon as this is known, and then sets
     * only kinetic_least. */
    bool clear;
};

/*
 * Computes the bounds for the trains between lo and hi, without friction; hi has the larger r, or the larger
 * s. The walk down the chains ends as soon as K is known to exceed `enough` for all trains. tol is the
 * largest relative error of K that may be caused by leaving out the tails of the chains.
 */
KERNEL enum dom_status strip_walk(const struct geometry *lo, const struct geometry *hi, enum dom_fuel fuel,
                                  real enough, real tol, struct strip *strip);

/*
 * These two functions return bounds on the barriers of all trains in the strip: an upper bound from the
 * barrier at hi, and a lower bound from the barrier at lo. `most` is an upper bound on all barriers. `width`
 * is the difference of ln r, or of s, between hi and lo.
 */
KERNEL real strip_barrier_most(const struct strip *strip, real hi_barrier, real most, real width);
KERNEL real strip_barrier_least(const struct strip *strip, real lo_barrier, real most, real width);

#endif
