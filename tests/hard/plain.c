/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "plain.h"

#include <math.h>
#include <stdbool.h>

#define PLAIN_LINKS 4000
/* Golden section ends at this relative width. */
#define PLAIN_NARROW 1e-15
/* A margin in double below this one is computed again in the widest type. */
#define PLAIN_UNSURE(d) (1e-9 + 1e-13 / ((d) * (d)))

/* ---- double ---- */
#define REAL        double
#define PLAIN(name) double_##name
#define PLAIN_TINY  1e-19
#define PLAIN_GRID  24
#define PLAIN_CLOSE 1e-9
static double double_power(double r, double e)
{
    return pow(r, e);
}
#include "plain.inc"
#undef REAL
#undef PLAIN
#undef PLAIN_TINY
#undef PLAIN_GRID
#undef PLAIN_CLOSE

/* ---- the widest type ---- */
#define REAL        domq_real
#define PLAIN(name) wide_##name
#define PLAIN_TINY  1e-37
#define PLAIN_GRID  32
#define PLAIN_CLOSE 1e-18
static domq_real wide_exp(domq_real x)
{
    domq_real sum = 1, term = 1;
    x /= 1024;
    for (int k = 1; k < 20; k++)
        sum += term *= x / k;
    for (int k = 0; k < 10; k++)
        sum *= sum;
    return sum;
}
static domq_real wide_power(domq_real r, domq_real e)
{
    domq_real ln = logl((long double)r);
    for (int k = 0; k < 2; k++)
        ln += r / wide_exp(ln) - 1;
    return wide_exp(e * ln);
}
#include "plain.inc"

domq_real plain_share(domq_real s, domq_real d, domq_real q, domq_real r)
{
    return wide_share(s, d, q, r);
}

double plain_share_double(double s, double d, double q, double r)
{
    return double_share(s, d, q, r);
}

/* ---- Dips and roots ---- */

domq_real plain_dip(domq_real s, domq_real d, domq_real q, double lo, double hi, domq_real *at)
{
    const domq_real part = (domq_real)0.6180339887498948482L;
    domq_real from = lo, to = hi, a = to - part * (to - from), b = from + part * (to - from);
    domq_real at_a = plain_share(s, d, q, a), at_b = plain_share(s, d, q, b);
    while (to - from > (domq_real)PLAIN_NARROW * to) {
        if (at_a < at_b) {
            to = b;
            b = a;
            at_b = at_a;
            a = to - part * (to - from);
            at_a = plain_share(s, d, q, a);
        } else {
            from = a;
            a = b;
            at_a = at_b;
            b = from + part * (to - from);
            at_b = plain_share(s, d, q, b);
        }
    }
    *at = at_a < at_b ? a : b;
    return at_a < at_b ? at_a : at_b;
}

domq_real plain_root(domq_real s, domq_real d, domq_real q, domq_real lo, domq_real hi)
{
    for (int k = 0; k < 110; k++) {
        const domq_real middle = (lo + hi) / 2;
        *(plain_share(s, d, q, middle) >= 0 ? &lo : &hi) = middle;
    }
    return lo;
}

/* The minimum of the margin in double, by golden section. */
static double dip_in_double(double s, double d, double q, double lo, double hi, double *at)
{
    const double part = 0.6180339887498948482;
    double a = hi - part * (hi - lo), b = lo + part * (hi - lo);
    double at_a = double_share(s, d, q, a), at_b = double_share(s, d, q, b);
    for (int k = 0; k < 36; k++) {
        const bool left = at_a < at_b;
        *(left ? &hi : &lo) = left ? b : a;
        const double x = left ? hi - part * (hi - lo) : lo + part * (hi - lo),
                     at_x = double_share(s, d, q, x);
        if (left) {
            b = a;
            at_b = at_a;
            a = x;
            at_a = at_x;
        } else {
            a = b;
            at_a = at_b;
            b = x;
            at_b = at_x;
        }
    }
    *at = at_a < at_b ? a : b;
    return fmin(at_a, at_b);
}

double plain_rmax(double s, double d, double q, double ratio)
{
    const int n = (int)ceil(log(1 / s) / log(ratio)) + 1;
    double r[3] = {1, 1, 1}, f[3] = {0};
    if (!(double_share(s, d, q, 1) >= 0))
        return 0;
    for (int k = 0; k <= n; k++) {
        double lo, hi;
        r[0] = r[1];
        f[0] = f[1];
        r[1] = r[2];
        f[1] = f[2];
        r[2] = pow(s, -(double)k / n);
        f[2] = double_share(s, d, q, k < n ? r[2] : r[2] * (1 - 1e-15));
        if (fabs(f[2]) < PLAIN_UNSURE(d))
            f[2] = (double)plain_share(s, d, q, r[2]);
        lo = r[1];
        hi = r[2];
        if (k > 1 && f[1] < f[0] && f[1] <= f[2] && f[2] >= 0) {
            double dip = dip_in_double(s, d, q, r[0], r[2], &hi);
            lo = r[0];
            if (fabs(dip) < PLAIN_UNSURE(d)) {
                domq_real at, deep = plain_dip(s, d, q, r[0], r[2], &at);
                dip = (double)deep;
                hi = (double)at;
            }
            if (dip >= 0)
                continue;
        } else if (f[2] >= 0)
            continue;
        for (int i = 0; i < 60; i++) {
            const double middle = (lo + hi) / 2;
            *(double_share(s, d, q, middle) >= 0 ? &lo : &hi) = middle;
        }
        return lo;
    }
    return 1 / s;
}
