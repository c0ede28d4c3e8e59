/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Roots and linear differential equations in the arithmetic of the kernels. Nothing here depends on dominoes.
 * A num_function that cannot be evaluated returns NaN, which ends a search with NUM_NOT_FINITE.
 *
 * GSL's functions compute only in double. In benchmarks they also took more evaluations: Brent's method for
 * roots, and rk8pd for the equation of motion.
 */
#pragma once

#include "numerics/real.h"

enum num_status { NUM_OK, NUM_NOT_BRACKETED, NUM_NOT_FINITE, NUM_NOT_CONVERGED, NUM_NO_MEMORY };

typedef real num_function(real x, void *context);

/*
 * Finds the root x of f between lo and hi, to the relative tolerance tol. f(lo) and f(hi) must have different
 * signs; zero counts as either sign. The method is Chandrupatla's (Advances in Engineering Software 28,
 * 1997). It uses inverse quadratic interpolation where that is safe, and bisection elsewhere.
 */
KERNEL_SHARED enum num_status num_root(num_function *f, void *context, real lo, real hi, real tol, real *x);

/* Does the same as num_root, for callers that already know f(lo) and f(hi), or at least numbers with the same
 * signs. */
KERNEL enum num_status num_root_between(num_function *f, void *context, real lo, real f_lo, real hi,
                                        real f_hi, real tol, real *x);

/* ---- Linear differential equations ---- */

/*
 * Solves the linear equation dw/dx = p(x) w + c(x). One solution is valid for all initial values w(0):
 *
 *     w(x) = G(x) (w(0) + v(x)),   ln G = integral of p,   v = integral of c / G.
 *
 * Both integrals are stored as Chebyshev series on panels. If the series of p or of c / G does not converge
 * on a panel, the panel is halved. The solution is equally precise at the nodes and between them. GSL's
 * odeiv2 finds the solution for one initial value at a time.
 */
#if REAL_BITS <= 24
#define LINEAR_ORDER 8
#elif REAL_BITS <= 64
#define LINEAR_ORDER 32
#else
#define LINEAR_ORDER 36
#endif
enum { LINEAR_PANELS = 128 };

struct num_rate {
    real p, c;
    /* absolute rounding errors; 0 means a few units in the last place */
    real p_noise, c_noise;
};

/* Computes p and c at x. Returns false if they cannot be computed. */
typedef bool num_linear_function(real x, void *context, struct num_rate *rate);

struct num_panel {
    real lo, hi;
    int terms;
    real ln_G[LINEAR_ORDER + 1], v[LINEAR_ORDER + 1]; /* Chebyshev series on [lo, hi] */
};

struct num_linear {
    bool integral; /* true if p is 0, so that ln G is 0, and v is the integral of c */
    int panels;
    /* LINEAR_PANELS panels, too large for the stack. NULL before the first solution. */
    struct num_panel *panel;
    real ln_G_error, v_error; /* errors, estimated from the last terms of the series */
};

/* Extends the solution over [lo, hi], where p and c must be smooth. If there is a solution already, it must
 * end at lo. The relative error of G is about tol, and the error of v is about tol times the range of v. If
 * tol is infinite, the solution is rough: it has a single panel, on which p and c are evaluated only at 7
 * nodes, so its series may not have converged. */
KERNEL enum num_status num_linear_solve(num_linear_function *f, void *context, real lo, real hi, real tol,
                                        struct num_linear *solution);

KERNEL void num_linear_free(struct num_linear *solution);

/* Finds ln G, unless it is NULL, and v at x, which must lie within the range of the solution. */
KERNEL void num_linear_at(const struct num_linear *solution, real x, real *ln_G, real *v);

/* Returns v(x) - v(x - by). The relative error does not grow if `by` is tiny. */
KERNEL real num_linear_moved(const struct num_linear *solution, real x, real by);
