/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Roots, maxima, derivatives and integrals, as GSL has them; nothing in here knows of dominoes.
 * A function that cannot be evaluated returns NaN, which ends the search with NUM_NOT_FINITE.
 */
#ifndef NUM_NUMERICS_H
#define NUM_NUMERICS_H

enum num_status { NUM_OK, NUM_NOT_BRACKETED, NUM_NOT_FINITE, NUM_NOT_CONVERGED, NUM_NO_MEMORY };

typedef double num_function(double x, void *context);

/*
 * Root of f between lo and hi, where it has different signs (zero counts as either), to the relative
 * tolerance tol of x (Brent).
 */
enum num_status num_root(num_function *f, void *context, double lo, double hi, double tol, double *x);

/*
 * Maximum of f between lo and hi, around a middle point that is higher than both, to the relative
 * tolerance tol of x.  Golden section: a kink or a jump is met as exactly as a smooth top is not, which
 * values alone fix only to the root of the unit roundoff.
 */
enum num_status num_maximum(num_function *f, void *context, double lo, double middle, double hi, double tol,
                            double *x);

/* Integral of f over [lo, hi] to the relative tolerance tol (adaptive Gauss-Kronrod). */
enum num_status num_integral(num_function *f, void *context, double lo, double hi, double tol,
                             double *integral);

#endif
