/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "numerics/numerics.h"

/* Bisection alone: from the largest to the smallest quad number it is some 33,000 halvings; 2000 suffice
 * wherever lo and hi are of one size, or one of them is 0 and its root no smaller than 1e-300. */
#define ITERATIONS_MAX 2000

KERNEL enum num_status num_root(num_function *f, void *context, real lo, real hi, real tol, real *x)
{
    real f_lo = f(lo, context), f_hi = f(hi, context);
    return num_root_between(f, context, lo, f_lo, hi, f_hi, tol, x);
}

KERNEL enum num_status num_root_between(num_function *f, void *context, real lo, real f_lo, real hi,
                                        real f_hi, real tol, real *x)
{
    /* a is the newest point, b the other end of the bracket, c the one before. */
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
        /* Interpolation through a, b, c stays inside the bracket where xi and phi say so. */
        real xi = (a - b) / (c - b), phi = (fa - fb) / (fc - fb);
        t = (real)0.5;
        if (phi * phi < xi && (1 - phi) * (1 - phi) < 1 - xi)
            t = fa / (fb - fa) * fc / (fb - fc) + (c - a) / (b - a) * fa / (fc - fa) * fb / (fc - fb);
    }
    return NUM_NOT_CONVERGED;
}

KERNEL enum num_status num_maximum(num_function *f, void *context, real lo, real middle, real hi, real tol,
                                   real *x)
{
    const real golden = (3 - sqrt((real)5)) / 2;
    real top = f(middle, context), low = f(lo, context), high = f(hi, context);
    if (!isfinite(top) || !isfinite(low) || !isfinite(high))
        return NUM_NOT_FINITE;
    if (!(lo < middle && middle < hi && top > low && top > high))
        return NUM_NOT_BRACKETED;
    for (int i = 0; i < ITERATIONS_MAX; i++) {
        if (hi - lo <= fmax(tol, 4 * REAL_EPSILON) * fabs(middle)) {
            *x = middle;
            return NUM_OK;
        }
        bool right = hi - middle > middle - lo;
        real probe = right ? middle + golden * (hi - middle) : middle - golden * (middle - lo);
        real value = f(probe, context);
        if (!isfinite(value))
            return NUM_NOT_FINITE;
        if (value > top) {
            *(right ? &lo : &hi) = middle;
            middle = probe;
            top = value;
        } else {
            *(right ? &hi : &lo) = probe;
        }
    }
    return NUM_NOT_CONVERGED;
}

/* ---- Integral: x = tanh(pi/2 sinh t) on [-1, 1], trapezoidal in t, the step halved level by level ---- */

enum { LEVELS_MAX = 12 };

struct span {
    num_function *f;
    void *context;
    real lo, hi, half;
    real cut; /* terms of this share end the sum: they fall off faster than a geometric series */
    bool failed;
};

/* The two nodes at +t and -t, with their weight; from the ends, so that no digit of the distance is lost. */
static real node_pair(struct span *s, real t, real *weight)
{
    real grow = exp(t), q = exp(-PI / 2 * (grow - 1 / grow)); /* e^(-2 u), u = pi/2 sinh t */
    real from_end = s->half * 2 * q / (1 + q);
    *weight = PI / 4 * (grow + 1 / grow) * 4 * q / ((1 + q) * (1 + q));
    /* Rounded to the end itself they still count: a peak may sit there. */
    real sum = s->f(s->lo + from_end, s->context) + s->f(s->hi - from_end, s->context);
    s->failed = s->failed || !isfinite(sum);
    return *weight * sum;
}

/* All nodes at first, first + step, ...: until they no longer matter at the tolerance. */
static real node_sum(struct span *s, real first, real step)
{
    real sum = 0, weight = 1;
    for (real t = first; weight > 0 && !s->failed; t += step) {
        real term = node_pair(s, t, &weight);
        sum += term;
        if (fabs(term) <= s->cut * fabs(sum) && weight < s->cut)
            break;
    }
    return sum;
}

/* The sum on the level behind step: the nodes between those that it has. */
static real next_level(struct span *s, real sum, real *step)
{
    *step /= 2;
    return sum + node_sum(s, *step, 2 * *step);
}

KERNEL enum num_status num_integral(num_function *f, void *context, real lo, real hi, real tol,
                                    real *integral, real *error)
{
    struct span s = {f, context, lo, hi, (hi - lo) / 2, fmax(tol / 64, UNIT / 8), false};
    real step = 1, sum = PI / 2 * f(lo + s.half, context) + node_sum(&s, step, step);
    real before = s.half * sum, off_before = 1;
    for (int level = 1; level <= LEVELS_MAX && !s.failed && isfinite(sum); level++) {
        sum = next_level(&s, sum, &step);
        real value = s.half * step * sum, off = fabs(value - before) / fabs(value);
        /* Digits nearly double from level to level: the last two differences say how many are right now. */
        real gain = off < 1 && off_before < 1 ? fmin(fmax(log(off) / log(off_before), 1), (real)1.5) : 1;
        real left = off == 0 ? 0 : fmin(off, 32 * exp(gain * log(off)));
        if (level >= 2 && (left <= tol || off <= 4 * REAL_EPSILON)) {
            *integral = value;
            if (error) { /* a guess is no bound: the next level shows what was left */
                sum = next_level(&s, sum, &step);
                *error = 2 * fabs(s.half * step * sum - value) + fabs(value) * (4 * s.cut + 8 * UNIT);
            }
            return s.failed ? NUM_NOT_FINITE : NUM_OK;
        }
        before = value;
        off_before = off;
    }
    return s.failed || !isfinite(sum) ? NUM_NOT_FINITE : NUM_NOT_CONVERGED;
}
