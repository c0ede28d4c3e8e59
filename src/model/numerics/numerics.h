/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Roots, maxima and integrals in the arithmetic of the kernels, without any dominoes. A function that cannot
 * be evaluated returns NaN, which ends the search with NUM_NOT_FINITE. These functions replace those of GSL,
 * which computes in double alone, since one source must serve all precisions. tests/unit/test_numerics.c
 * compares both: a list of roots takes 65 evaluations, where Brent's method takes 73, and integrals of
 * near-stops take 4883, where qag takes 7497.
 */
#ifndef NUM_NUMERICS_H
#define NUM_NUMERICS_H

#include "numerics/real.h"

enum num_status { NUM_OK, NUM_NOT_BRACKETED, NUM_NOT_FINITE, NUM_NOT_CONVERGED, NUM_NO_MEMORY };

typedef real num_function(real x, void *context);

/*
 * Finds the root of f between lo and hi, where it has different signs (zero counts as either), to the
 * relative tolerance tol of x: inverse quadratic interpolation where that is safe, else bisection
 * (Chandrupatla, Advances in Engineering Software 28, 1997).
 */
KERNEL enum num_status num_root(num_function *f, void *context, real lo, real hi, real tol, real *x);

/* Finds a root as num_root does. The values at both ends, or at least their signs, are known. */
KERNEL enum num_status num_root_between(num_function *f, void *context, real lo, real f_lo, real hi,
                                        real f_hi, real tol, real *x);

/*
 * Finds the maximum of f between lo and hi by golden section, to the relative tolerance tol of x. At the
 * middle point f is larger than at both ends. A kink or a jump is found exactly, but a smooth maximum only to
 * the square root of the unit roundoff, since values of f give no more.
 */
KERNEL enum num_status num_maximum(num_function *f, void *context, real lo, real middle, real hi, real tol,
                                   real *x);

/*
 * Finds the integral of f over [lo, hi] to the relative tolerance tol, and an estimate of its error unless
 * `error` is NULL. The double exponential rule (Takahasi and Mori, 1974) allows singularities at the ends.
 */
KERNEL enum num_status num_integral(num_function *f, void *context, real lo, real hi, real tol,
                                    real *integral, real *error);

/*
 * Finds the integral of a function that is smooth except for a peak like 1 / sqrt(width^2 + (x - peak)^2),
 * which may be outside of the interval. The width is NaN if it is unknown. With x = peak + width sinh u the
 * peak is flat, and the rule of Clenshaw and Curtis (1960) converges fast, however narrow the peak is. If the
 * rule does not converge, num_integral computes the pieces before and after the peak.
 */
KERNEL enum num_status num_peak_integral(num_function *f, void *context, real lo, real hi, real peak,
                                         real width, real tol, real *integral, real *error);

enum { CHEBYSHEV_FIRST = 8, CHEBYSHEV_LEVELS = 4, CHEBYSHEV_MOST = CHEBYSHEV_FIRST << CHEBYSHEV_LEVELS };

/* The integral of such a function from lo to any x up to hi, as a Chebyshev series in u. */
struct num_series {
    real lo, hi, peak, width; /* if the width is NaN, u is x */
    real from, half;          /* the value of u at lo, and half of the range of u */
    int terms;
    real term[CHEBYSHEV_MOST + 2];
};

/* Finds the series. Returns NUM_NOT_CONVERGED if CHEBYSHEV_MOST terms are not enough for the relative
 * tolerance tol. */
KERNEL enum num_status num_peak_series(num_function *f, void *context, real lo, real hi, real peak,
                                       real width, real tol, struct num_series *series);

/* Return the integral from lo to x, and find the x for an integral of a positive function. */
KERNEL real num_series_at(const struct num_series *series, real x);
KERNEL enum num_status num_series_find(const struct num_series *series, real integral, real *x);

/* ---- Linear equations ---- */

/*
 * The linear equation dw/dx = p(x) w + c(x), solved once for every initial value:
 *
 *     w(x) = G(x) (w(0) + v(x)),   ln G = integral of p,   v = integral of c / G,
 *
 * with both integrals as Chebyshev series on panels, halved until the series of p and c / G have died out.
 * Between the nodes the solution is as precise as at the nodes, so that searches for maxima, roots and times
 * need no further steps. This replaces odeiv2 of GSL, which computes in double alone and from one initial
 * value. tests/unit/test_numerics.c compares both: a list of equations takes 6880 evaluations, where rk8pd
 * takes 13917.
 */
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
    real p_noise, c_noise; /* absolute rounding errors of p and c; 0 means a few units */
};

/* Finds p and c at x. Returns false if they cannot be computed. */
typedef bool num_linear_function(real x, void *context, struct num_rate *rate);

struct num_panel {
    real lo, hi;
    real ln_G[LINEAR_ORDER + 1], v[LINEAR_ORDER + 1]; /* Chebyshev series on [lo, hi] */
};

struct num_linear {
    int panels;
    /* LINEAR_PANELS panels, which are too large for a stack. NULL until the first solution allocates them. */
    struct num_panel *panel;
    real ln_G_error, v_error; /* estimates, from the last terms of the series */
};

/*
 * Continues the solution from its end, or from lo if panels = 0, to hi. p and c must be smooth in between.
 * The relative error of G is about tol, and so is the error of v over the range of v.
 */
KERNEL enum num_status num_linear_solve(num_linear_function *f, void *context, real lo, real hi, real tol,
                                        struct num_linear *solution);

/*
 * A rough solution from x = 0 to hi from few values: one panel, whose series need not have died out. The
 * errors are absolute and estimated from the last terms.
 */
enum { ROUGH = 8 };
struct num_rough {
    real node[ROUGH]; /* num_rough_begin finds them */
    real ln_G[ROUGH + 1], v[ROUGH + 1];
    real ln_G_error, v_error;
};
KERNEL void num_rough_begin(struct num_rough *solution);
KERNEL bool num_rough_solve(num_linear_function *f, void *context, real hi, struct num_rough *solution);

/* Return v and G at u, which goes from -1 to 1 as x goes from 0 to hi. */
KERNEL real num_rough_v(const struct num_rough *solution, real u);
KERNEL real num_rough_G(const struct num_rough *solution, real u);

/* Frees the panels. */
KERNEL void num_linear_free(struct num_linear *solution);

/* Finds ln G and v at x, which must not be outside of the solution. */
KERNEL void num_linear_at(const struct num_linear *solution, real x, real *ln_G, real *v);

/* Returns v(x) - v(x - by). Its relative error is that of v', however small `by` is. */
KERNEL real num_linear_moved(const struct num_linear *solution, real x, real by);

#endif
