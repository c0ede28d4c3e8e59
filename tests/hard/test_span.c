/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Needs: proof */
/*
 * Tests each operation on intervals (src/proof/model/span.h) against exact rational numbers. The bounds of
 * the intervals are all pairs of difficult doubles: zeros of both signs, subnormal numbers, the largest
 * doubles and infinities. Rational numbers are taken from each interval, and the exact result of the
 * operation must lie within the interval that the operation returns.
 */
#include "../unit/suite.h"
#include "proof/model/span.h"
#include <gmp.h>

static const double bound[] = {-INFINITY, -DBL_MAX,
                               -3,        -0x1.0000000000001p0,
                               -1.0 / 3,  -0x1p-600,
                               -DBL_MIN,  -0x1p-1074,
                               -0.0,      0,
                               0x1p-1074, DBL_MIN,
                               0x1p-600,  1.0 / 3,
                               1,         0x1p60 + 4096,
                               3,         0x1.fffffffffffffp0,
                               1e300,     DBL_MAX,
                               INFINITY};
enum { BOUNDS = sizeof bound / sizeof *bound, MEMBERS = 4 };

/* An interval, and rational numbers in it. */
struct sample {
    struct span span;
    mpq_t member[MEMBERS];
    int members;
};

static struct sample sample[BOUNDS * BOUNDS];
static int samples;

/* Adds a bound, or a number far beyond all doubles if the bound is infinite. */
static void member_add(struct sample *s, double x)
{
    mpq_ptr to = s->member[s->members++];
    mpq_init(to);
    mpq_set_d(to, isinf(x) ? (x < 0 ? -1 : 1) : x);
    if (isinf(x))
        mpq_mul_2exp(to, to, 3000);
}

static void samples_make(void)
{
    for (int i = 0; i < BOUNDS && samples < BOUNDS * BOUNDS; i++)
        for (int j = 0; j < BOUNDS; j++) {
            if (!(bound[i] <= bound[j]) || (bound[i] == bound[j] && isinf(bound[i])))
                continue;
            struct sample *s = &sample[samples++];
            s->span = (struct span){bound[i], bound[j]};
            member_add(s, bound[i]);
            member_add(s, bound[j]);
            member_add(s, bound[j]); /* the middle of both */
            mpq_add(s->member[2], s->member[0], s->member[1]);
            mpq_div_2exp(s->member[2], s->member[2], 1);
            if (bound[i] <= 0 && bound[j] > 0) { /* just above 0 */
                member_add(s, 0x1p-1074);
                mpq_div_2exp(s->member[3], s->member[3], bound[j] < DBL_MIN ? 1 : 1000);
            }
        }
}

static bool above(const mpq_t x, double lo)
{
    mpq_t q;
    if (!isfinite(lo))
        return lo < 0;
    mpq_init(q);
    mpq_set_d(q, lo);
    const bool is = mpq_cmp(x, q) >= 0;
    mpq_clear(q);
    return is;
}

static bool within(const mpq_t x, struct span a)
{
    mpq_t negative;
    mpq_init(negative);
    mpq_neg(negative, x);
    const bool is = above(x, a.lo) && above(negative, -a.hi);
    mpq_clear(negative);
    return is;
}

static const struct {
    const char *name;
    struct span (*computed)(struct span a, struct span b);
    void (*exact)(mpq_t z, const mpq_t x, const mpq_t y);
    int least;           /* the smallest sign of y */
    bool is_of_positive; /* true if x and y must be finite and >= 0 */
} operation[] = {{"add", span_add, mpq_add, -1, false},
                 {"sub", span_sub, mpq_sub, -1, false},
                 {"mul", span_mul, mpq_mul, -1, false},
                 {"over", span_over, mpq_div, 1, false},
                 {"product", span_product, mpq_mul, 0, true}};

TEST(operations_with_two_intervals)
{
    mpq_t z;
    size_t checked = 0;
    mpq_init(z);
    samples_make();
    for (size_t op = 0; op < sizeof operation / sizeof *operation; op++)
        for (const struct sample *a = sample; a < sample + samples; a++)
            for (const struct sample *b = sample; b < sample + samples; b++) {
                if (operation[op].least >= 0 && (b->span.lo < 0 || b->span.hi <= 0))
                    continue;
                if (operation[op].is_of_positive &&
                    (a->span.hi < 0 || !isfinite(a->span.lo + a->span.hi + b->span.lo + b->span.hi)))
                    continue;
                const struct span c = operation[op].computed(a->span, b->span);
                for (int k = 0; k < a->members * b->members; k++) {
                    mpq_srcptr x = a->member[k / b->members], y = b->member[k % b->members];
                    if (mpq_sgn(y) < operation[op].least || (operation[op].is_of_positive && mpq_sgn(x) < 0))
                        continue;
                    operation[op].exact(z, x, y);
                    checked++;
                    if (!within(z, c))
                        fail_msg("%s of [%a, %a] and [%a, %a]: [%a, %a], without %g", operation[op].name,
                                 a->span.lo, a->span.hi, b->span.lo, b->span.hi, c.lo, c.hi, mpq_get_d(z));
                }
            }
    assert_true(checked > 100000);
    mpq_clear(z);
}

TEST(operations_with_one_interval)
{
    mpq_t z;
    mpq_init(z);
    for (const struct sample *a = sample; a < sample + samples; a++)
        for (int i = 0; i < a->members; i++) {
            const struct span minus = span_negate(a->span);
            mpq_neg(z, a->member[i]);
            assert_true(within(z, minus));
            assert_true(!isfinite(a->span.lo) || within(a->member[i], span_around(a->span.lo)) || i > 0);
            if (mpq_sgn(a->member[i]) < 0)
                continue;
            /* the root lies within the interval if the number lies between the squares of the bounds */
            const struct span root = span_sqrt(a->span);
            mpq_t low, high;
            mpq_inits(low, high, NULL);
            mpq_set_d(low, root.lo);
            mpq_mul(low, low, low);
            if (isfinite(root.hi)) {
                mpq_set_d(high, root.hi);
                mpq_mul(high, high, high);
            } else
                mpq_set(high, a->member[i]);
            if (mpq_cmp(low, a->member[i]) > 0 || mpq_cmp(high, a->member[i]) < 0)
                fail_msg("root of [%a, %a]: [%a, %a]", a->span.lo, a->span.hi, root.lo, root.hi);
            mpq_clears(low, high, NULL);
        }
    mpq_clear(z);
}
