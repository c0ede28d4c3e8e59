/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How many dominoes reach a height, near powers that meet it, in exact arithmetic. */
#include "support.h"

static domq_real rounded(domq_real x, enum dom_precision precision)
{
    return precision == DOM_FLOAT ? (domq_real)(float)x : precision == DOM_DOUBLE ? (domq_real)(double)x : x;
}

/*
 * Checks heights near a power. first and r have so few bits that first r^k is exact in the widest type, so a
 * height above it is known exactly. A height above it by more than the rounding of typed numbers, half a unit
 * for each of 4 + k of them, takes one domino more; a height within that, or below, does not. No more than a
 * millionth of a domino is allowed for.
 */
TEST(heights_near_a_power)
{
    uint64_t seed = 91;
    int above = 0, meet = 0;
    for (int i = 0; i < 30000; i++) {
        enum dom_precision precision = i % 2 ? DOM_DOUBLE : DOM_FLOAT;
        double epsilon = domq_arithmetic(precision)->epsilon;
        int bits = 1 + (int)(4 * random_unit(&seed)), most = (precision == DOM_FLOAT ? 18 : 90) / bits;
        int k = 1 + (int)(most * random_unit(&seed));
        domq_real r = 1 + (domq_real)(1 + (int)((1 << bits) * random_unit(&seed))) / (1 << bits),
                  first = (domq_real)(1 + (int)(7 * random_unit(&seed))) / 8, power = first;
        for (int j = 0; j < k; j++)
            power *= r;
        double units = random_log(&seed, 0.5, 1000) * (i % 3 ? 1 : -1);
        domq_real height = rounded(power * (1 + (domq_real)(units * epsilon)), precision);
        double off = (double)((height - power) / power) / epsilon,
               slack = fmin((4 + k) / 2.0, 1e-6 * log((double)r) / epsilon);
        if (fabs(off - slack) < 1) /* the bound itself is rounded */
            continue;
        struct domq_count count;
        assert_status(ask_count_find(precision, first, height, r, &count, NULL), DOM_OK);
        int expected = off > slack ? k + 1 : k;
        if (count.dominoes != expected)
            fail_msg("%.17g r^%d, r = %.17g, and %g units: %g dominoes", (double)first, k, (double)r, off,
                     (double)count.dominoes);
        if (off > slack)
            assert_true(count.last > height);
        above += off > slack;
        meet += off <= slack && off >= 0;
    }
    print_message("# %d above, %d meet\n", above, meet);
    assert_true(above > 5000 && meet > 2000);
}

/* Checks that 30 dominoes reach 2^30 m from 1 m; 0.01 mm more takes 31, in double and, typed with more
 * digits, in quad. */
TEST(a_bit_more_than_a_power)
{
    struct domq_count count;
    assert_status(ask_count_find(DOM_DOUBLE, 1, 1073741824.00001, 2, &count, NULL), DOM_OK);
    assert_true(count.dominoes == 31 && count.last == 2147483648.0);
    assert_status(ask_count_find(DOM_DOUBLE, 1, 1073741824, 2, &count, NULL), DOM_OK);
    assert_true(count.dominoes == 30);
    assert_status(ask_count_find(DOM_QUAD, 1, 1073741824 * (1 + (domq_real)1e-30), 2, &count, NULL), DOM_OK);
    assert_true(domq_arithmetic(DOM_QUAD)->bits < 113 || count.dominoes == 31);
}
