/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Needs: chance */
/* The intervals of studies of any size, compared with tails of the binomial distribution that are summed term
 * by term. */
#include "support.h"

/* Returns ln n! by Stirling's series, whose first omitted term is below 1e-20 for n >= 40. lgammal has fewer
 * digits. */
static long double log_factorial(size_t count)
{
    long double n = (long double)count, sum = 0, per = 1 / (n * n);
    if (count < 40) {
        for (size_t i = 2; i <= count; i++)
            sum += logl((long double)i);
        return sum;
    }
    sum = (1 - per * (1 / 30.0L - per * (1 / 105.0L - per * (1 / 140.0L - per / 99)))) / (12 * n);
    return (n + 0.5L) * logl(n) - n + logl(2 * 3.14159265358979323846L) / 2 + sum;
}

/* Returns the probability that at most k of n independent events of probability p occur or, if `more` is
 * true, at least k. */
static long double tail(size_t k, size_t n, long double p, bool more)
{
    long double of_k = log_factorial(n) - log_factorial(k) - log_factorial(n - k) + (long double)k * logl(p) +
                       (long double)(n - k) * log1pl(-p);
    long double term = expl(of_k), sum = 0;
    for (size_t i = k; term > 1e-25L * sum; more ? i++ : i--) {
        sum += term;
        if (i == (more ? n : 0))
            break;
        term *= more ? (long double)(n - i) / (long double)(i + 1) * p / (1 - p)
                     : (long double)i / (long double)(n - i + 1) * (1 - p) / p;
    }
    return sum;
}

/*
 * Checks that the tail is 2.5 % at both ends of the interval. For twenty million rows, the logarithms are
 * about 4e8, with relative errors of 5e-20. The ends of the interval are right to 1e-15, and an error of this
 * size changes the tail by at most 1e-14 times the number of rows.
 */
static void check_interval(size_t rows, size_t fall, size_t unknown)
{
    struct dom_study s = {.rows = rows, .fall = fall, .unknown = unknown};
    assert_status(dom_study_interval(&s), DOM_OK);
    size_t many = fall + unknown;
    double bound = 1e-10 + 2e-14 * (double)rows;
    if (fall == 0)
        assert_true(s.low == 0);
    else
        assert_near("low", (double)tail(fall, rows, s.low, true), 0.025, bound);
    if (many == rows)
        assert_true(s.high == 1);
    else
        assert_near("high", (double)tail(many, rows, s.high, false), 0.025, bound);
    assert_true(s.low < s.high && s.low <= (double)fall / (double)rows &&
                s.high >= (double)many / (double)rows);
}

TEST(any_size)
{
    uint64_t seed = 81;
    for (int i = 0; i < 800; i++) {
        size_t rows = 1 + (size_t)random_log(&seed, 1, 2e7);
        double share = i % 3 == 0 ? random_unit(&seed) : random_log(&seed, 0.1 / (double)rows, 1);
        size_t few = (size_t)(share * (double)rows);
        size_t fall = i % 2 ? few : rows - few;
        size_t unknown = i % 5 == 0 ? (size_t)((double)(rows - fall) * random_unit(&seed)) : 0;
        check_interval(rows, fall, unknown);
    }
}
