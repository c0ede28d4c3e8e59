/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Needs: chance */
/* Studies of rows with random errors, and the largest errors with which enough of the rows fall. */
#include "run.h"
#include "support.h"

/* Checks the budget of a row, also with too few rows for the probability, and the budget of a row that stops
 * even without errors. */
TEST(budgets)
{
    static struct run seen;
    struct dom_budget budget;
    struct dom_placement p = {.seed = 3, .rows = 200};
    alike(&seen, 10);
    assert_status(ask_placement_budget(&seen.row, &p, DOM_ERROR_gap, 0.9999, &budget), DOM_OK);
    assert_true(budget.low == 0 && budget.sigma < budget.high);
    assert_status(ask_placement_budget(&seen.row, &p, DOM_ERROR_gap, 0.8, &budget), DOM_OK);
    assert_true(0 < budget.low && budget.low < budget.sigma && budget.sigma < budget.high);
    /* Run the same rows with the sigma that was found. */
    struct dom_study study;
    p.error[DOM_ERROR_gap].size = budget.sigma;
    assert_status(ask_placement_study(&seen.row, &p, &study, NULL), DOM_OK);
    assert_true(study.fall >= 160 && study.fall <= 161);
    /* If each of 200 rows falls with a probability of 0.95, the probability that at most 183 of them fall is
     * below 2.5 %. The probability that at least 197 fall is below 2.5 %, too. */
    assert_status(ask_placement_budget(&seen.row, &p, DOM_ERROR_gap, 0.95, &budget), DOM_OK);
    p.error[DOM_ERROR_gap].size = budget.low;
    assert_status(ask_placement_study(&seen.row, &p, &study, NULL), DOM_OK);
    assert_in_range(study.fall, 197, 198);
    p.error[DOM_ERROR_gap].size = budget.high;
    assert_status(ask_placement_study(&seen.row, &p, &study, NULL), DOM_OK);
    assert_in_range(study.fall, 183, 184);
    assert_status(ask_placement_budget(&seen.row, &p, DOM_ERROR_gap, 1.5, &budget), DOM_BAD_PROBABILITY);
    seen.row.push = 2; /* too weak a push to tip the domino over its edge */
    assert_status(ask_placement_budget(&seen.row, &p, DOM_ERROR_gap, 0.5, &budget), DOM_STOPS);
}

/* Checks that studies of parts add up: how many rows fall, at which dominoes they stop, how many the model
 * cannot decide, and the interval. */
TEST(studies_add_up)
{
    static struct run seen;
    struct dom_study whole, part[2];
    size_t stops[10], stops_part[2][10], stopped = 0;
    struct dom_placement p = {
        .error = {[DOM_ERROR_gap].size = 0.008, [DOM_ERROR_height].size = 0.05}, .seed = 5, .rows = 500};
    alike(&seen, 10);
    assert_status(ask_placement_study(&seen.row, &p, &whole, stops), DOM_OK);
    for (int k = 0; k < 2; k++) {
        p.first = k == 0 ? 0 : 200;
        p.rows = k == 0 ? 200 : 300;
        assert_status(ask_placement_study(&seen.row, &p, &part[k], stops_part[k]), DOM_OK);
    }
    assert_true(whole.fall == part[0].fall + part[1].fall && whole.fall > 0 && whole.fall < 500);
    assert_int_equal(whole.unknown, part[0].unknown + part[1].unknown);
    for (int k = 0; k < 10; k++) {
        assert_int_equal(stops[k], stops_part[0][k] + stops_part[1][k]);
        stopped += stops[k];
    }
    assert_int_equal(stopped + whole.fall + whole.unknown, 500);
    p.seed = 6;
    assert_status(ask_placement_study(&seen.row, &p, &part[0], NULL), DOM_OK);
    assert_true(part[0].fall != part[1].fall);
    /* Without errors all rows are alike. In this row the third domino cannot reach the next one. */
    p = (struct dom_placement){.rows = 50};
    seen.domino[3].gap = 0.05;
    assert_status(run_whole(&seen), DOM_OK);
    assert_int_equal(seen.verdict.end, DOM_ROW_MISSES);
    assert_status(ask_placement_study(&seen.row, &p, &whole, stops), DOM_OK);
    assert_true(seen.verdict.domino == 3 && stops[2] == 50 && whole.fall == 0 && whole.low == 0);
    assert_near("Clopper and Pearson", whole.high, 1 - pow(0.025, 1.0 / 50), 1e-10);
    /* In this row the tip of a domino passes above the next one. */
    alike(&seen, 10);
    seen.domino[3].height *= 0.8;
    assert_status(run_whole(&seen), DOM_OK);
    assert_int_equal(seen.verdict.end, DOM_ROW_PASSES);
    assert_status(ask_placement_study(&seen.row, &p, &whole, stops), DOM_OK);
    assert_true(whole.unknown == 50 && stops[2] == 0 && whole.low == 0 && whole.high == 1);
    alike(&seen, 10);
    assert_status(ask_placement_study(&seen.row, &p, &whole, stops), DOM_OK);
    assert_true(whole.fall == 50 && whole.high == 1);
    assert_near("Clopper and Pearson", whole.low, pow(0.025, 1.0 / 50), 1e-10);
}

/* ---- Intervals of studies of any size, compared with tails of the binomial distribution that are summed
 * term by term ---- */

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
