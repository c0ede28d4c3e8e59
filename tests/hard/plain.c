/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "plain.h"

#include <math.h>
#include <stdbool.h>

#define PLAIN_LINKS 4000

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
