/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Roots, maxima and integrals in the arithmetic of the kernels, without any dominoes. A function that cannot
 * be evaluated returns NaN, which ends the search with NUM_NOT_FINITE. These replace GSL's, since GSL
 * computes in double alone, and one source must serve all precisions. tests/unit/test_numerics.c compares
 * them with GSL's: 65 evaluations for a list of roots for which Brent's method takes 73, 4883 for integrals
 * of near-stops for which qag takes 7497.
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

/* Finds a root as num_root does, from ends whose values, or at least signs, are known. */
KERNEL enum num_status num_root_between(num_function *f, void *context, real lo, real f_lo, real hi,
                                        real f_hi, real tol, real *x);

/*
 * Finds the maximum of f between lo and hi, around a middle point that is higher than both, to the relative
 * tolerance tol of x, by golden section. A kink or a jump is found exactly. A smooth maximum is found only to
 * the square root of the unit roundoff, since values alone give no more.
 */
KERNEL enum num_status num_maximum(num_function *f, void *context, real lo, real middle, real hi, real tol,
                                   real *x);

/*
 * Finds the integral of f over [lo, hi] to the relative tolerance tol, and an estimate of its error unless
 * error is NULL. The double exponential rule (Takahasi and Mori, 1974) allows peaks and roots at the ends.
 */
KERNEL enum num_status num_integral(num_function *f, void *context, real lo, real hi, real tol,
                                    real *integral, real *error);

/*
 * Finds the integral of an f that is smooth except for a peak like 1 / sqrt(width^2 + (x - peak)^2), inside
 * the interval or not; width NaN: unknown. With x = peak + width sinh u the peak is flat, and the rule of
 * Clenshaw and Curtis (1960) converges fast, however narrow the peak is. If the rule does not converge,
 * num_integral computes the pieces before and after the peak.
 */
KERNEL enum num_status num_peak_integral(num_function *f, void *context, real lo, real hi, real peak,
                                         real width, real tol, real *integral, real *error);

enum { CHEBYSHEV_FIRST = 8, CHEBYSHEV_LEVELS = 4, CHEBYSHEV_MOST = CHEBYSHEV_FIRST << CHEBYSHEV_LEVELS };

/* The integral of such an f from lo to any x up to hi: its Chebyshev series in u. */
struct num_series {
    real lo, hi, peak, width; /* width NaN: x = u */
    real from, half;          /* of u: its value at lo, and half of its range */
    int terms;
    real term[CHEBYSHEV_MOST + 2];
};

/* Finds the series. NUM_NOT_CONVERGED: no series of CHEBYSHEV_MOST terms has the relative tolerance tol. */
KERNEL enum num_status num_peak_series(num_function *f, void *context, real lo, real hi, real peak,
                                       real width, real tol, struct num_series *series);

/* Return the integral from lo to x; and the x of an integral, for an f > 0. */
KERNEL real num_series_at(const struct num_series *series, real x);
KERNEL enum num_status num_series_find(const struct num_series *series, real integral, real *x);

/* ---- Linear equations ---- */

/*
 * The linear equation dw/dx = p(x) w + c(x), solved once for every initial value:
 *
 *     w(x) = G(x) (w(0) + v(x)),   ln G = integral of p,   v = integral of c / G,
 *
 * with both integrals as Chebyshev series on panels, halved until the series of p and c / G have died out.
 * Between the nodes the solution is known as well as at the nodes, so searches for maxima, roots and times
 * need no further steps. This replaces GSL's odeiv2, which computes in double alone and from one initial
 * value: tests/unit/test_numerics.c compares the two, 6880 evaluations for a list of equations for which
 * rk8pd takes 13917.
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
    real p_noise, c_noise; /* absolute errors of p and c by rounding; 0: a few units */
};

/* Finds p and c at x. Returns false if they cannot be computed. */
typedef bool num_linear_function(real x, void *context, struct num_rate *rate);

struct num_panel {
    real lo, hi;
    real ln_G[LINEAR_ORDER + 1], v[LINEAR_ORDER + 1]; /* Chebyshev series on [lo, hi] */
};

struct num_linear {
    int panels;
    /* LINEAR_PANELS panels, allocated by the first solution, since a stack has no room; NULL before */
    struct num_panel *panel;
    real ln_G_error, v_error; /* estimates, from the last terms of the series */
};

/*
 * Continues the solution from its end, or from lo if panels = 0, to hi. p and c are smooth between. The
 * relative error of G is about tol, and so is the error of v over the range of v.
 */
KERNEL enum num_status num_linear_solve(num_linear_function *f, void *context, real lo, real hi, real tol,
                                        struct num_linear *solution);

/*
 * The solution from x = 0 to hi, from few values: one panel, whose series need not have died out. The errors
 * are absolute, from the last terms.
 */
enum { ROUGH = 8 };
struct num_rough {
    real node[ROUGH]; /* num_rough_begin finds them */
    real ln_G[ROUGH + 1], v[ROUGH + 1];
    real ln_G_error, v_error;
};
KERNEL void num_rough_begin(struct num_rough *solution);
KERNEL bool num_rough_solve(num_linear_function *f, void *context, real hi, struct num_rough *solution);

/* Return v and G at u, which goes from -1 to 1 where x goes from 0 to hi. */
KERNEL real num_rough_v(const struct num_rough *solution, real u);
KERNEL real num_rough_G(const struct num_rough *solution, real u);

/* Frees the panels. */
KERNEL void num_linear_free(struct num_linear *solution);

/* Finds ln G and v at x, which is inside the solution, or an end. */
KERNEL void num_linear_at(const struct num_linear *solution, real x, real *ln_G, real *v);

/* Returns v(x) - v(x - by), with the relative error of v', however small `by` is. */
KERNEL real num_linear_moved(const struct num_linear *solution, real x, real by);

#endif
