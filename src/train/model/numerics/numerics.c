/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "numerics/numerics.h"

/* 2000 bisections are enough if lo and hi are of similar size, or if one of them is 0 and the root is at
 * least 1e-300. */
#define ITERATIONS_MAX 2000

KERNEL enum num_status num_root(num_function *f, void *context, real lo, real hi, real tol, real *x)
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

/* ---- Integrals: a rule with levels, each of which has twice as many nodes as the level before ---- */

enum { LEVELS_MAX = 12 };

struct span {
    num_function *f;
    void *context;
    real lo, hi, half;
    bool failed;
    /* Only for the double exponential rule. A sum ends when its terms are smaller than the fraction `cut` of
     * the sum. The terms that are left out are negligible, because they decrease faster than a geometric
     * series. */
    real cut, step, sum;
    /* Only for the Clenshaw-Curtis rule. The rule integrates over a variable u, with x = peak + width sinh u.
     * If the width is NaN, u equals x. `tail` is the fraction of f that the nodes of the last level do not
     * resolve. */
    real peak, width, from, to, tail, *value;
};

/* Computes the integral with the nodes of one level of the rule. */
typedef real span_level(struct span *s, int level);

/* Estimates the relative error of the last level. `off` is the relative difference between the last level and
 * the level before, and `off_before` is the difference that was found one level earlier. The number of
 * correct digits nearly doubles from each level to the next, so the error is much smaller than `off`. */
static real span_left(real off, real off_before)
{
    real gain = off < 1 && off_before < 1 ? fmin(fmax(log(off) / log(off_before), 1), (real)1.5) : 1;
    return off == 0 ? 0 : fmin(off, 32 * exp(gain * log(off)));
}

static enum num_status span_integral(struct span *s, span_level *next, int levels, real tol, real *integral,
                                     real *error)
{
    real before = next(s, 0), off_before = 1;
    for (int level = 1; level <= levels && !s->failed && isfinite(before); level++) {
        real value = next(s, level), off = fabs(value - before) / fabs(value);
        /* Two levels can agree by chance, even if their nodes are too far apart to resolve f. So `unseen`, an
         * estimate of the error from the unresolved part of f, must be small too. */
        real unseen = 8 * s->tail * s->tail, left = span_left(off, off_before);
        if (level >= 2 && unseen <= tol && (left <= tol || off <= 4 * REAL_EPSILON)) {
            *integral = value;
            /* `left` is only an estimate. For an error bound, compare with one more level. */
            if (error && level < levels)
                off = 2 * fabs(next(s, level + 1) - value) / fabs(value) + 4 * s->cut + 8 * ROUNDOFF;
            if (error)
                *error = (off + unseen) * fabs(value);
            return s->failed ? NUM_NOT_FINITE : NUM_OK;
        }
        /* The nodes do not resolve f at all, so another rule is better. */
        if (level >= 2 && s->tail > (real)0.01)
            break;
        before = value;
        off_before = off;
    }
    return s->failed || !isfinite(before) ? NUM_NOT_FINITE : NUM_NOT_CONVERGED;
}

/* ---- x = tanh(pi/2 sinh t) on [-1, 1], trapezoidal in t ---- */

/* Returns the weighted sum of f at the nodes +t and -t, and stores their weight. Near an end of the interval,
 * tanh would lose digits. So each node is computed from its distance to the nearer end. */
static real node_pair(struct span *s, real t, real *weight)
{
    real grow = exp(t), q = exp(-PI / 2 * (grow - 1 / grow)); /* q is e^(-2 u), where u = pi/2 sinh t */
    real from_end = s->half * 2 * q / (1 + q);
    *weight = PI / 4 * (grow + 1 / grow) * 4 * q / ((1 + q) * (1 + q));
    /* Rounding can put a node exactly at an end of the interval. The node still counts, because f may have a
     * peak there. */
    real sum = s->f(s->lo + from_end, s->context) + s->f(s->hi - from_end, s->context);
    s->failed = s->failed || !isfinite(sum);
    return *weight * sum;
}

/* Returns the sum of the terms at first, first + step, ..., until they are too small to matter. */
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

static real exponential_level(struct span *s, int level)
{
    if (level == 0) {
        s->step = 1;
        s->sum = PI / 2 * s->f(s->lo + s->half, s->context) + node_sum(s, 1, 1);
    } else { /* only the nodes between the previous ones are new */
        s->step /= 2;
        s->sum += node_sum(s, s->step, 2 * s->step);
    }
    return s->half * s->step * s->sum;
}

KERNEL enum num_status num_integral(num_function *f, void *context, real lo, real hi, real tol,
                                    real *integral, real *error)
{
    struct span s = {.f = f,
                     .context = context,
                     .lo = lo,
                     .hi = hi,
                     .half = (hi - lo) / 2,
                     .cut = fmax(tol / 64, ROUNDOFF / 8)};
    return span_integral(&s, exponential_level, LEVELS_MAX, tol, integral, error);
}

/* ---- The Clenshaw-Curtis rule: nodes u = cos(pi j / n), scaled to [lo, hi] ---- */

static real arsinh(real x)
{
    real size = fabs(x), y = log1p(size + size * size / (1 + sqrt(1 + size * size)));
    return x < 0 ? -y : y;
}

/* Returns f(x) dx/du at a node between -1 and 1. */
static real chebyshev_value(struct span *s, real node)
{
    real u = s->lo + s->half * (1 + node), x = u, by = 1;
    if (isfinite(s->width)) {
        real grow = exp(u);
        x = fmin(fmax(s->peak + s->width * (grow - 1 / grow) / 2, s->from), s->to);
        by = s->width * (grow + 1 / grow) / 2;
    }
    real value = by * s->f(x, s->context);
    s->failed = s->failed || !isfinite(value);
    return value;
}

/*
 * Returns n times the weight of node j:
 *
 *     2 - sum over k = 1, ..., n / 2 of 4 cos(2 pi j k / n) / (4 k^2 - 1),
 *
 * with the last term halved. Returns half of this for node 0.
 */
static real chebyshev_weight(const real *cosine, int j, int n)
{
    real sum = 1;
    for (int k = 1; k <= n / 2; k++) {
        int at = 2 * j * k % (2 * n);
        real c = at <= n ? cosine[at] : cosine[2 * n - at];
        sum -= (real)(k < n / 2 ? 2 : 1) * c / (real)(4 * k * k - 1);
    }
    return j == 0 ? sum : 2 * sum;
}

static real chebyshev_level(struct span *s, int level)
{
    const int n = CHEBYSHEV_FIRST << level;
    const size_t stride = CHEBYSHEV_MOST / (size_t)n;
    real cosine[CHEBYSHEV_MOST + 1], sum = 0, a[3] = {0};
    for (int j = 0; j <= n; j++)
        cosine[j] = j == n / 2 ? 0 : cos(PI * (real)j / (real)n);
    /* Each level adds the odd nodes; the even ones are those of the previous level. */
    for (int j = level > 0; j <= n && !s->failed; j += level > 0 ? 2 : 1)
        s->value[(size_t)j * stride] = chebyshev_value(s, cosine[j]);
    for (int j = 0; j <= n && !s->failed; j++) {
        /* The coefficients of T_n, T_(n-1) and T_(n-2) show how well the nodes resolve f. */
        real value = s->value[(size_t)j * stride], c = cosine[j];
        real part = (real)(j % 2 ? -1 : 1) * (j == 0 || j == n ? value / 2 : value);
        if (2 * j <= n) /* node n - j has the weight of node j */
            sum += chebyshev_weight(cosine, j, n) *
                   (2 * j == n ? value : value + s->value[(size_t)(n - j) * stride]);
        a[0] += part;
        a[1] += 2 * part * c;
        a[2] += 2 * part * (2 * c * c - 1);
    }
    s->tail = fmax(fabs(a[0]), fmax(fabs(a[1]), fabs(a[2]))) * 2 / fabs(sum);
    return s->half * sum / (real)n;
}

/* Returns [lo, hi] after the substitution x = peak + width sinh u. The interval is left as it is if the width
 * is unknown, if the interval is not longer than the width, or if the peak is at least one length of the
 * interval away from it. */
static struct span peak_span(num_function *f, void *context, real lo, real hi, real peak, real width,
                             real *value)
{
    real away = fmax(fmax(lo - peak, peak - hi), 0);
    bool flat = isfinite(width) && hi - lo > fmax(width, away);
    struct span s = {.f = f,
                     .context = context,
                     .lo = flat ? arsinh((lo - peak) / width) : lo,
                     .hi = flat ? arsinh((hi - peak) / width) : hi,
                     .peak = peak,
                     .from = lo,
                     .to = hi,
                     .width = flat ? width : REAL_NAN,
                     .value = value};
    s.half = (s.hi - s.lo) / 2;
    return s;
}

KERNEL enum num_status num_peak_integral(num_function *f, void *context, real lo, real hi, real peak,
                                         real width, real tol, real *integral, real *error)
{
    real value[CHEBYSHEV_MOST + 1];
    struct span s = peak_span(f, context, lo, hi, peak, width, value);
    enum num_status status = span_integral(&s, chebyshev_level, CHEBYSHEV_LEVELS, tol, integral, error);
    if (status == NUM_OK)
        return status;
    if (!(peak > lo && peak < hi))
        return num_integral(f, context, lo, hi, tol, integral, error);
    real before = 0, after = 0, before_error = 0, after_error = 0;
    status = num_integral(f, context, lo, peak, tol, &before, error ? &before_error : NULL);
    if (status == NUM_OK)
        status = num_integral(f, context, peak, hi, tol, &after, error ? &after_error : NULL);
    *integral = before + after;
    if (error)
        *error = before_error + after_error;
    return status;
}

/* ---- Chebyshev series ---- */

KERNEL real series_at(const real *series, int n, real x)
{
    real b = 0, before = 0;
    for (int k = n - 1; k > 0; k--) {
        real next = 2 * x * b - before + series[k];
        before = b;
        b = next;
    }
    return x * b - before + series[0];
}

KERNEL void series_integral(const real *series, int n, real half, real start, real *integral)
{
    real at_left = 0;
    for (int k = 1; k <= n; k++) {
        real below = k == 1 ? 2 * series[0] : series[k - 1], above = k + 1 < n ? series[k + 1] : 0;
        integral[k] = half * (below - above) / (2 * (real)k);
        at_left += k % 2 ? -integral[k] : integral[k];
    }
    integral[0] = start - at_left;
}
