/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Computes powers, logarithms and exponentials with the operations + - * / alone. Most functions of libm have
 * no guaranteed error bounds. Those that are used here (frexp, ldexp and nearbyint) are exact. */
#include "proof/model/chain.h"

/* Returns x^n for x >= 0 and n >= 1, by repeated squaring. */
static struct span power_whole(struct span x, int n)
{
    struct span power = span_of(1);
    for (; n > 0; n /= 2, x = span_square(x))
        if (n % 2)
            power = span_scale(power, x);
    return power;
}

/*
 * Returns 2 atanh t for 0 <= t <= 1/3, computed from the series
 *
 *     2 atanh t = 2 t (1 + t^2 (1/3 + t^2 (1/5 + ...))).
 *
 * The series is cut off after n = TERMS terms, so the innermost bracket that is computed ends with t^2 R. The
 * remainder R is at most
 *
 *     1/(2n+1) + t^2 (1/(2n+3) + ...) <= (1 + 1/9 + 1/81 + ...)/(2n+1) = (9/8)/(2n+1) < 1/n.
 *
 * So the interval [0, 1/n] takes the place of R.
 */
static struct span twice_atanh(struct span t)
{
    enum { TERMS = 18 }; /* (1/9)^18 < 2^-57 */
    struct span square = span_square(t), sum = {0, 1.0 / TERMS};
    for (int k = TERMS - 1; k >= 0; k--)
        sum = span_add(span_over(span_of(1), span_of(2 * k + 1)), span_scale(square, sum));
    return span_scale(span_add(t, t), sum);
}

static struct span log_2(void)
{
    return twice_atanh(span_over(span_of(1), span_of(3))); /* 2 atanh(1/3) = ln 2 */
}

/*
 * Returns ln x for x >= 1. The number x is split into x = 2^(n-1) m with an integer n and 1 <= m < 2, so that
 *
 *     ln x = (n - 1) ln 2 + 2 atanh((m - 1)/(m + 1)).
 */
static struct span log_of(double x)
{
    int n;
    double m = 2 * frexp(x, &n);                                                 /* exact */
    struct span t = span_over(span_of(m - 1), span_add(span_of(m), span_of(1))); /* m - 1 is also exact */
    return span_add(span_scale(span_of(n - 1), log_2()), twice_atanh(t));
}

struct span span_log(struct span x)
{
    return (struct span){least_0(log_of(x.lo).lo), log_of(x.hi).hi};
}

/*
 * Returns e^x for 0 <= x <= 700. The argument is split into x = n ln 2 + y with an integer n and |y| < 1/2,
 * so that e^x = 2^n e^y.
 *
 * The series of e^y is cut off after the term y^N/N!, where N = TERMS. Each later term is less than 1/4 of
 * the term before it. So the remainder is at most
 *
 *     |y|^(N+1)/(N+1)! / (1 - 1/4) < 2 (1/2)^(N+1)/(N+1)! < 2^-63   for N = 16.
 */
static struct span exp_of(double x)
{
    enum { TERMS = 16 };
    double n = nearbyint(x / 0x1.62e42fefa39efp-1);
    struct span y = span_sub(span_of(x), span_scale(span_of(n), log_2())), sum = span_of(1);
    for (int k = TERMS; k >= 1; k--) /* 1 + y (1 + y/2 (1 + ...)) */
        sum = span_add(span_of(1), span_mul(span_over(y, span_of(k)), sum));
    sum = span_add(sum, (struct span){-0x1p-63, 0x1p-63});
    return (struct span){ldexp(sum.lo, (int)n), ldexp(sum.hi, (int)n)}; /* exact */
}

struct span span_exp(struct span x)
{
    return (struct span){exp_of(least_0(x.lo)).lo, exp_of(x.hi).hi};
}

struct span span_power(struct span x, struct span q)
{
    if (q.lo == q.hi && q.lo == (int)q.lo && q.lo <= 64) {
        struct span least = power_whole(span_of(x.lo), (int)q.lo),
                    most = power_whole(span_of(x.hi), (int)q.lo);
        return (struct span){least.lo, most.hi};
    }
    struct span power = span_exp(span_scale(q, span_log(x)));
    return (struct span){larger(power.lo, 1), power.hi};
}
