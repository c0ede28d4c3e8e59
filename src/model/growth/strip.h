/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Bounds for all trains in a strip. A strip is an interval of growths at one separation, or an interval of
 * separations at one growth.
 *
 * A domino that has detached is taken to stay at theta_f. Then the tilt theta_i(theta) of a follower
 * increases with r and with s, and its slope theta_i' decreases. The derivatives of theta_i with respect to r
 * and s decrease with theta. For domino 1, the first follower, the derivatives and the slope are
 *
 *     d theta_1 / d ln r = X / Y,   d theta_1 / ds = r cos theta / Y,   theta_1' = 1 - r L sin theta / Y.
 *
 * X and Y are the sine and cosine of theta_1 - theta. Each of these three quantities is a monotone function
 * of r, s and theta, because X = r (L cos theta - d). For later followers, the derivatives and slopes are
 * sums of products of such quantities. None of the factors is negative, so these sums are monotone, too. So
 * the two trains at the ends of a strip enclose all others.
 *
 * STRIP_SLACK allows for rounding errors, but this is not a proof by interval arithmetic.
 */
#ifndef DOM_STRIP_H
#define DOM_STRIP_H

#include "energy/barrier.h"

struct strip {
    /* Bounds on K over the strip. kinetic_least is a bound only if it is positive. */
    real kinetic_least, kinetic_most;
    /* Let g be -dh/dtheta. For each follower i, g(theta_i(0)) increases by some factor from lo to hi, and
     * `grows` is the largest of these factors. If a follower has not yet reached theta_u at lo, `grows` is
     * infinite. */
    real grows;
    /* Upper bound on the energy that the followers behind the last visited one can still lose. `grows` does
     * not cover these followers. */
    real cut;
    real drops; /* upper bound on -d barrier / d ln r, or on -d barrier / ds; >= 0 */
    /*
     * Upper bounds on d margin / d ln r over a strip of growths. margin_slope holds at every growth of the
     * strip. root_slope holds only where the barrier is at least kinetic_least. At a root of the margin, this
     * is always the case.
     */
    real margin_slope, root_slope;
    /* True if K > `enough` over the whole strip. Only kinetic_least is then set. */
    bool clear;
};

/*
 * Computes the bounds for the trains between lo and hi, without friction. The trains lo and hi differ either
 * in r or in s, and hi has the larger value. If the bounds show early that K > `enough` for all trains, the
 * computation ends, and strip->clear is true. The sums end when their tails can widen the bounds on K by no
 * more than about tol (K + barrier_most).
 */
KERNEL enum dom_status strip_walk(const struct geometry *lo, const struct geometry *hi, enum dom_fuel fuel,
                                  real enough, real tol, struct strip *strip);

/* strip_barrier_most takes the barrier at hi and returns an upper bound on all barriers in the strip.
 * strip_barrier_least takes the barrier at lo and returns a lower bound. `most` is an upper bound that is
 * already known (barrier_most). `width` is the width of the strip: the difference of ln r, or of s, between
 * hi and lo. */
KERNEL real strip_barrier_most(const struct strip *strip, real hi_barrier, real most, real width);
KERNEL real strip_barrier_least(const struct strip *strip, real lo_barrier, real most, real width);

#endif
