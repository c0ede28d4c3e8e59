/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The linear equation dw/dx = p(x) w + c(x), solved once for every beginning:
 *
 *     w(x) = G(x) (w(0) + v(x)),   ln G = integral of p,   v = integral of c / G,
 *
 * with both integrals as Chebyshev series on panels, halved until the series of p and c / G have died out.
 * Between the nodes the solution is known as well as at them, so maxima, roots and times can be asked of it
 * without another step.
 *
 * Ours and not GSL's odeiv2, which steps in double alone and from one beginning: tests/unit/test_numerics.c
 * holds it against that, 6880 evaluations for a list of equations where rk8pd takes 13917.
 */
#ifndef NUM_LINEAR_H
#define NUM_LINEAR_H

#include "numerics/numerics.h"

#if REAL_BITS <= 24
#define LINEAR_ORDER 8
#elif REAL_BITS <= 64
#define LINEAR_ORDER 16
#else
#define LINEAR_ORDER 36
#endif
enum { LINEAR_PANELS = 128 };

struct num_rate {
    real p, c;
    real p_noise, c_noise; /* what rounding leaves in them; 0 for a few units */
};

/* p and c at x; false where they cannot be computed. */
typedef bool num_linear_function(real x, void *context, struct num_rate *rate);

struct num_panel {
    real lo, hi;
    real ln_G[LINEAR_ORDER + 1], v[LINEAR_ORDER + 1]; /* Chebyshev series on [lo, hi] */
};

struct num_linear {
    int panels;
    struct num_panel *panel; /* LINEAR_PANELS, made by the first solution; NULL before: a stack has no room */
};

/*
 * Goes on from where the solution ends, or from lo at panels = 0, to hi; p and c are smooth between.  The
 * relative error of G and the error of v, relative to how far v moves, are about tol.
 */
KERNEL enum num_status num_linear_solve(num_linear_function *f, void *context, real lo, real hi, real tol,
                                        struct num_linear *solution);

/* Gives back the panels. */
KERNEL void num_linear_free(struct num_linear *solution);

/* ln G and v at x, which is inside, or an end. */
KERNEL void num_linear_at(const struct num_linear *solution, real x, real *ln_G, real *v);

/* v(x) - v(x - by), as right as v' is, however small `by` is. */
KERNEL real num_linear_moved(const struct num_linear *solution, real x, real by);

#endif
