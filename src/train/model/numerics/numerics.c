/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Roots, by Chandrupatla's method. */
#include "numerics/numerics.h"

/* 2000 bisections are enough if lo and hi are of similar size, or if one of them is 0 and the root is at
 * least 1e-300. */
#define ITERATIONS_MAX 2000

KERNEL_SHARED enum num_status num_root(num_function *f, void *context, real lo, real hi, real tol, real *x)
{
    real f_lo = f(lo, context), f_hi = f(hi, context);
    return num_root_between(f, context, lo, f_lo, hi, f_hi, tol, x);
}

KERNEL enum num_status num_root_between(num_function *f, void *context, real lo, real f_lo, real hi,
                                        real f_hi, real tol, real *x)
{
    /* a is the newest point and b the other end of the bracket. c is the end that the last step discarded. */
    real a = lo, b = hi, fa = f_lo, fb = f_hi;
    if (!isfinite(fa) || !isfinite(fb))
        return NUM_NOT_FINITE;
    if ((fa > 0 && fb > 0) || (fa < 0 && fb < 0))
        return NUM_NOT_BRACKETED;
    tol = fmax(tol, 2 * REAL_EPSILON);
    real t = fmin(fmax(fa / (fa - fb), (real)0.1), (real)0.9);
    for (int i = 0; i < ITERATIONS_MAX; i++) {
        real best = fabs(fa) < fabs(fb) ? a : b, width = fabs(b - a);
        real close = fmax(tol * fabs(best), REAL_MIN) / 2;
        if (width <= 2 * close || fa == 0 || fb == 0) {
            *x = best;
            return NUM_OK;
        }
        t = fmin(fmax(t, close / width), 1 - close / width);
        real next = a + t * (b - a), value = f(next, context), c, fc;
        if (!isfinite(value))
            return NUM_NOT_FINITE;
        if ((value > 0) == (fa > 0)) {
            c = a;
            fc = fa;
        } else {
            c = b;
            fc = fb;
            b = a;
            fb = fa;
        }
        a = next;
        fa = value;
        /* Interpolation stays in the bracket if phi^2 < xi and (1 - phi)^2 < 1 - xi. */
        real xi = (a - b) / (c - b), phi = (fa - fb) / (fc - fb);
        t = (real)0.5;
        if (phi * phi < xi && (1 - phi) * (1 - phi) < 1 - xi)
            t = fa / (fb - fa) * fc / (fb - fc) + (c - a) / (b - a) * fa / (fc - fa) * fb / (fc - fb);
    }
    return NUM_NOT_CONVERGED;
}
