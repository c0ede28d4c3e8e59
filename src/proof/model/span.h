/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Interval arithmetic: each result is an interval that certainly contains the true value. The bounds of an
 * interval are computed in double with + - * / and sqrt, so they have rounding errors. Each computed bound is
 * therefore moved outwards by one step.
 *
 * One step is enough, because IEEE 754 rounds the results of these five operations to the nearest double. If
 * z is a rounded result, the exact result lies between the two neighbours of z. The functions up(z) and
 * down(z) return doubles that are at or beyond these neighbours (Rump, Zimmermann, Boldo, Melquiond,
 * "Computing predecessor and successor in rounding to nearest", BIT 49, 419).
 *
 * The rounding mode is never changed here. If a caller has set a rounding mode other than rounding to
 * nearest, the functions dom_prove_... prove nothing.
 */
#pragma once

#include <float.h>
#include <math.h>
#include <stdbool.h>

#ifdef __FAST_MATH__
#error "A proof depends on the rounding of every operation: compile without -ffast-math."
#endif
_Static_assert(FLT_RADIX == 2 && DBL_MANT_DIG == 53, "The proof computes in IEEE 754 double precision.");
_Static_assert(FLT_EVAL_METHOD == 0, "The proof needs operations that round to double.");

/*
 * PROOF_BOUND is there to check that the tests notice a wrong bound. It takes a bound that a proof depends
 * on, and a deliberately wrong bound. Normally, the right bound is used. tests/unit/test_proof.c uses the
 * wrong bounds, one at a time, and checks that a test then fails.
 */
#ifndef PROOF_BOUND
#define PROOF_BOUND(name, right, wrong) (right)
#endif

/* Marks functions that are always inlined, since a call would cost as much as the arithmetic, and since a
 * caller may need only one bound. */
#define SPAN static inline __attribute__((always_inline))

/* The real numbers from lo to hi. If a bound is infinite, all real numbers on that side belong to the
 * interval, but infinity does not. */
struct span {
    double lo, hi;
};

/*
 * Let z be the rounded result of an operation. The function up(z) returns a double at or above every real
 * number that rounds to z, and down(z) returns a double at or below them all. The term DBL_MIN is needed if z
 * is so small that it has lost digits (underflow). Numbers that round to -infinity are at most -DBL_MAX.
 */
SPAN double up(double z)
{
    return PROOF_BOUND(ROUND_UP, z < -DBL_MAX ? -DBL_MAX : z + (fabs(z) * 0x1.0000000000001p-53 + DBL_MIN),
                       z);
}

SPAN double down(double z)
{
    return PROOF_BOUND(ROUND_DOWN, z > DBL_MAX ? DBL_MAX : z - (fabs(z) * 0x1.0000000000001p-53 + DBL_MIN),
                       z);
}

/*
 * Rounding may move a bound beyond what is possible. If a number is known to be >= 0, least_0 raises a
 * negative lower bound to 0. If a number is known to be <= 1, most_1 reduces an upper bound above 1 to 1. For
 * a NaN, least_0 returns 0, and most_1 returns 1.
 */
SPAN double least_0(double lo)
{
    return lo > 0 ? lo : 0;
}

SPAN double most_1(double hi)
{
    return hi < 1 ? hi : 1;
}

SPAN double smaller(double a, double b)
{
    return a < b ? a : b;
}

SPAN double larger(double a, double b)
{
    return a > b ? a : b;
}

SPAN struct span span_of(double x)
{
    return (struct span){x, x};
}

/* Returns an interval that contains all numbers that round to x. */
SPAN struct span span_around(double x)
{
    return (struct span){down(x), up(x)};
}

SPAN struct span span_add(struct span a, struct span b)
{
    return (struct span){down(a.lo + b.lo), up(a.hi + b.hi)};
}

SPAN struct span span_sub(struct span a, struct span b)
{
    return (struct span){down(a.lo - b.hi), up(a.hi - b.lo)};
}

SPAN struct span span_negate(struct span a)
{
    return (struct span){-a.hi, -a.lo};
}

/* The product and the quotient of two bounds. 0 times an infinite bound is 0, since the bound stands for real
 * numbers; so is 0 divided by a bound. `over` is for b >= 0, where a zero of either sign stands for the
 * positive numbers near 0. */
SPAN double times(double a, double b)
{
    return a == 0 || b == 0 ? 0 : a * b;
}

SPAN double over(double a, double b)
{
    return a == 0 ? 0 : a / least_0(b);
}

/* Returns a / k, for k > 0. The lower bound of k may be 0 or, because of rounding, negative. */
SPAN struct span span_over(struct span a, struct span k)
{
    return (struct span){down(over(a.lo, a.lo < 0 ? k.lo : k.hi)), up(over(a.hi, a.hi < 0 ? k.hi : k.lo))};
}

SPAN struct span span_mul(struct span a, struct span b)
{
    double p = times(a.lo, b.lo), q = times(a.lo, b.hi), r = times(a.hi, b.lo), s = times(a.hi, b.hi);
    return (struct span){down(smaller(smaller(p, q), smaller(r, s))), up(larger(larger(p, q), larger(r, s)))};
}

/* Returns a * b for finite numbers that are known to be >= 0, although their lower bounds may be negative
 * because of rounding. */
SPAN struct span span_product(struct span a, struct span b)
{
    return (struct span){down(least_0(a.lo) * least_0(b.lo)), up(a.hi * b.hi)};
}

/* Returns the square root of a number that is known to be >= 0. The lower bound a.lo may still be negative,
 * because of rounding; it then counts as 0. */
SPAN struct span span_sqrt(struct span a)
{
    return (struct span){least_0(down(sqrt(least_0(a.lo)))), up(sqrt(a.hi))};
}

static inline double span_middle(struct span a)
{
    return 0.5 * a.lo + 0.5 * a.hi;
}

/* ---- Intervals that carry their derivatives with respect to the growth r ---- */

/* A number that depends on r: bounds on its value, and on its derivative with respect to r. */
struct dual {
    struct span value, by_r;
};

/* Returns a number that does not depend on r. */
SPAN struct dual dual_of(struct span a)
{
    return (struct dual){a, {0, 0}};
}

SPAN struct dual dual_add(struct dual a, struct dual b)
{
    return (struct dual){span_add(a.value, b.value), span_add(a.by_r, b.by_r)};
}

SPAN struct dual dual_sub(struct dual a, struct dual b)
{
    return (struct dual){span_sub(a.value, b.value), span_sub(a.by_r, b.by_r)};
}

SPAN struct dual dual_mul(struct dual a, struct dual b)
{
    return (struct dual){span_mul(a.value, b.value),
                         span_add(span_mul(a.value, b.by_r), span_mul(a.by_r, b.value))};
}

/* Returns a / k, for k > 0. */
SPAN struct dual dual_over(struct dual a, struct dual k)
{
    const struct span ratio = span_over(a.value, k.value);
    return (struct dual){ratio, span_over(span_sub(a.by_r, span_mul(ratio, k.by_r)), k.value)};
}
