/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Roots, maxima and integrals in the arithmetic of the kernels; nothing in here knows of dominoes.
 * A function that cannot be evaluated returns NaN, which ends the search with NUM_NOT_FINITE.
 *
 * Ours and not GSL's, since GSL computes in double alone: the same source serves all precisions.
 * tests/unit/test_numerics.c holds them against GSL's: 65 evaluations for a list of roots where Brent's
 * method there takes 73, 4883 for integrals of near-stops where qag takes 7497.
 */
#ifndef NUM_NUMERICS_H
#define NUM_NUMERICS_H

#include "numerics/real.h"

enum num_status { NUM_OK, NUM_NOT_BRACKETED, NUM_NOT_FINITE, NUM_NOT_CONVERGED, NUM_NO_MEMORY };

typedef real num_function(real x, void *context);

/*
 * Root of f between lo and hi, where it has different signs (zero counts as either), to the relative
 * tolerance tol of x: inverse quadratic interpolation wherever it is safe, else bisection (Chandrupatla,
 * Advances in Engineering Software 28, 1997).
 */
KERNEL enum num_status num_root(num_function *f, void *context, real lo, real hi, real tol, real *x);

/* The same from ends whose values are known, at least in sign. */
KERNEL enum num_status num_root_between(num_function *f, void *context, real lo, real f_lo, real hi,
                                        real f_hi, real tol, real *x);

/*
 * Maximum of f between lo and hi, around a middle point that is higher than both, to the relative
 * tolerance tol of x.  Golden section: a kink or a jump is met as exactly as a smooth top is not, which
 * values alone fix only to the root of the unit roundoff.
 */
KERNEL enum num_status num_maximum(num_function *f, void *context, real lo, real middle, real hi, real tol,
                                   real *x);

/*
 * Integral of f over [lo, hi] to the relative tolerance tol, with an estimate of its error, unless NULL.
 * Double exponential (Takahasi and Mori, 1974): peaks and roots at the ends do not disturb it.
 */
KERNEL enum num_status num_integral(num_function *f, void *context, real lo, real hi, real tol,
                                    real *integral, real *error);

/*
 * The same of an f that is smooth but for a peak like 1 / sqrt(width^2 + (x - peak)^2), inside or not; width
 * NaN: unknown.  With x = peak + width sinh u the peak is flat, and the rule of Clenshaw and Curtis (1960)
 * converges at once, however narrow it is; where it does not, num_integral goes up to the peak, and on from
 * there.
 */
KERNEL enum num_status num_peak_integral(num_function *f, void *context, real lo, real hi, real peak,
                                         real width, real tol, real *integral, real *error);

enum { CHEBYSHEV_FIRST = 8, CHEBYSHEV_LEVELS = 4, CHEBYSHEV_MOST = CHEBYSHEV_FIRST << CHEBYSHEV_LEVELS };

/* The integral of such an f from lo to anywhere up to hi: its Chebyshev series in u. */
struct num_series {
    real lo, hi, peak, width; /* width NaN: x = u */
    real from, half;          /* of u: where it begins, and half of its way */
    int terms;
    real term[CHEBYSHEV_MOST + 2];
};

/* NUM_NOT_CONVERGED where no series of CHEBYSHEV_MOST terms has the relative tolerance tol. */
KERNEL enum num_status num_peak_series(num_function *f, void *context, real lo, real hi, real peak,
                                       real width, real tol, struct num_series *series);

/* The integral from lo to x; and the x for an integral, of an f > 0. */
KERNEL real num_series_at(const struct num_series *series, real x);
KERNEL enum num_status num_series_find(const struct num_series *series, real integral, real *x);

/* ---- Linear equations ---- */

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
