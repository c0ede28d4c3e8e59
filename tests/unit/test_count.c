/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The number of dominoes that reach a height, for known cases, and in exact arithmetic for heights near
 * powers. */
#include "support.h"

/*
 * Checks heights near a power. `first` and r have so few bits that first r^k is exact in the widest type, so
 * the distance of a height from this power is known exactly. A height takes one domino more if it exceeds the
 * power by more than the rounding of typed numbers, which is half a unit for each of 4 + k numbers, but at
 * most a millionth of a domino.
 */
TEST(heights_near_a_power)
{
    uint64_t seed = 91;
    int above = 0, meet = 0;
    for (int i = 0; i < 30000; i++) {
        enum precision precision = i % 2                               ? IN_DOUBLE
                                   : i % 4                             ? IN_FLOAT
                                   : any_arithmetic(IN_QUAD).bits > 64 ? IN_QUAD
                                                                       : IN_DOUBLE;
        double epsilon = any_arithmetic(precision).epsilon;
        int bits = 1 + (int)(4 * random_unit(&seed)), most = (precision == IN_FLOAT ? 18 : 90) / bits;
        int k = 1 + (int)(most * random_unit(&seed));
        domq_real r = 1 + (domq_real)(1 + (int)((1 << bits) * random_unit(&seed))) / (1 << bits),
                  first = (domq_real)(1 + (int)(7 * random_unit(&seed))) / 8, power = first;
        for (int j = 0; j < k; j++)
            power *= r;
        double units = random_log(&seed, 0.5, 1000) * (i % 3 ? 1 : -1);
        domq_real height = rounded_to(precision, power * (1 + (domq_real)(units * epsilon)));
        double off = (double)((height - power) / power) / epsilon,
               slack = fmin((4 + k) / 2.0, 1e-6 * log((double)r) / epsilon);
        if (fabs(off - slack) < 1) /* too close to the bound, which is itself rounded */
            continue;
        struct domq_count count;
        assert_status(ask_count_find(precision, first, height, r, &count), DOM_OK);
        int expected = off > slack ? k + 1 : k;
        if (count.dominoes != expected)
            fail_msg("%.17g r^%d, r = %.17g, and %g units: %g dominoes", (double)first, k, (double)r, off,
                     (double)count.dominoes);
        if (off > slack)
            assert_true(count.last > height);
        const double exact = k + log1p(off * epsilon) / log((double)r);
        assert_near("exact", (double)(count.exact - k) + 1, exact - k + 1,
                    epsilon * (1 / log((double)r) + 3 * exact));
        above += off > slack;
        meet += off <= slack && off >= 0;
    }
    print_message("# %d above, %d meet\n", above, meet);
    assert_true(above > 5000 && meet > 2000);
}

TEST(known_numbers)
{
    static const struct {
        double first, height, r, n;
    } known[] = {
        {0.048, 112, 1.5, 20},       {0.048, 112, 2, 12},      {0.048, 0.048, 2, 0},
        {0.048, 0.01, 2, 0},         {0.048, 0.0481, 2, 1},    {0.1, 12.8, 2, 7},
        {0.048, 112, 1.0001, 77555}, {0.001, 1e9, 1e6, 2},     {0.048, 0.1092, 1.5, 3},
        {0.05, 0.16875, 1.5, 3},     {0.07, 0.093170, 1.1, 3}, {0.07, 0.093171, 1.1, 4},
    };
    struct domq_count count;
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        assert_status(ask_count_find(IN_DOUBLE, known[i].first, known[i].height, known[i].r, &count), DOM_OK);
        assert_near("dominoes", count.dominoes, known[i].n, 0);
        assert_near("the last", count.last, known[i].first * pow(known[i].r, known[i].n), 1e-9);
    }
    /* 48 mm doubled k times, typed with 6 to 17 digits. */
    for (int k = 1; k < 60; k++) {
        for (int digits = 15; digits <= 17; digits++) {
            char text[40];
            snprintf(text, sizeof text, "%.*g", digits, ldexp(0.048, k));
            assert_status(ask_count_find(IN_DOUBLE, 0.048, strtod(text, NULL), 2, &count), DOM_OK);
            assert_near("dominoes", count.dominoes, k, 0);
            assert_status(ask_count_find(IN_DOUBLE, 0.048, strtod(text, NULL) * (1 + 1e-13), 2, &count),
                          DOM_OK);
            assert_near("dominoes", count.dominoes, k + 1, 0);
        }
    }
    assert_status(ask_count_find(IN_DOUBLE, 0.048, 112, 1, &count), DOM_OK);
    assert_true(isinf(count.dominoes) && isnan(count.last));
    assert_status(ask_count_find(IN_DOUBLE, 0.048, 112, 0.9, &count), DOM_BAD_R);
    assert_status(ask_count_find(IN_DOUBLE, 0.048, -1, 2, &count), DOM_BAD_HEIGHT);
    assert_status(ask_count_find(IN_DOUBLE, 0.048, DOMQ_NAN, 2, &count), DOM_BAD_HEIGHT);
    assert_status(ask_count_find(IN_DOUBLE, 1e-300, 1e300, 2, &count), DOM_BAD_HEIGHT);
}

/* Checks a number of dominoes that no integer type of 64 bits can hold. With sanitizers, a cast to such a
 * type ends the program. */
TEST(more_dominoes_than_an_integer_holds)
{
    struct domq_count count;
    if (any_arithmetic(IN_QUAD).bits < 113)
        return;
    const domq_real r = 1 + (domq_real)1 / 10000000000000 / 1000000000000; /* 1 + 1e-25 */
    assert_status(ask_count_find(IN_QUAD, 1, 2, r, &count), DOM_OK);
    assert_near("dominoes", count.dominoes, 0.6931471805599453e25, 1e-8);
    assert_near("the last", count.last, 2, 1e-8);
}
