/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Random trains over the whole parameter space, in every precision. At the smallest tolerance, each result is
 * as accurate as its inputs allow (reference.h), and at any other tolerance as accurate as the tolerance.
 * Then the error that the calculator shows, the difference from quad, covers the true error. The largest
 * error of each quantity is printed.
 */
#include "../unit/support.h"
#include "sweep.h"

/* The allowed errors in units. The tolerance corresponds to about 9 units. */
static const double units_allowed[REF_COUNT] = {
    [REF_LINK_THETA] = 24, /* each of hundreds of dominoes adds a rounding error */
};

static const struct sweep sweeps[] = {
    {IN_DOUBLE, 3, 20000, .barriers = 6, .durations = 25, .growths = 20, .pairs = 50},
    {IN_FLOAT, 2, 4000, .barriers = 8, .durations = 50, .growths = 20, .pairs = 20},
    {IN_QUAD, 3, 1500, .barriers = 6, .durations = 15, .growths = 10, .pairs = 20},
};

/* Prints a sample, and says what is wrong with it. Returns 1. */
static int wrong(const char *precision, int quantity, const struct sample *sample, const char *what)
{
    fprintf(stderr, "# %s\n", what);
    tally_print(precision, (enum ref_quantity)quantity, sample);
    return 1;
}

/* Prints the worst errors of a quantity. Returns how many bounds it violates. */
static int failures_of(const char *precision, int k, const struct tally *t, long least)
{
    int failures = 0;
    if (t->checked > 0)
        fprintf(stderr, "# %-6s %-15s %6ld: %8.3g units, %8.3g of tol\n", precision,
                ref_name((enum ref_quantity)k), t->checked, fmax(t->units.excess, TALLY_UNITS),
                t->tol.excess);
    if (t->checked < least && k <= REF_PAIR) /* a sweep does not check the best separations */
        failures += wrong(precision, k, &t->units, "checked too rarely");
    if (t->units.excess > (units_allowed[k] > 0 ? units_allowed[k] : 16))
        failures += wrong(precision, k, &t->units, "too many units of error");
    if (t->tol.excess > 1)
        failures += wrong(precision, k, &t->tol, "beyond tolerance and conditioning");
    if (t->wrong > 0)
        failures += wrong(precision, k, &t->mistake, t->what);
    return failures;
}

TEST(every_answer_is_right)
{
    static struct tally tally[REF_COUNT];
    int failures = 0;
    const double size = sweep_size(); /* with few points some quantities may not occur */
    for (size_t i = 0; i < sizeof sweeps / sizeof *sweeps; i++) {
        struct sweep sweep = sweeps[i];
        const struct domq_arithmetic arithmetic = any_arithmetic(sweep.precision);
        sweep.points = (int)ceil(size * sweep.points);
        if (arithmetic.bits == 0)
            continue;
        assert_int_equal(sweep_run(&sweep, tally), sweep.points);
        assert_true(tally[REF_THETA_C].checked >= sweep.points);
        for (int k = 0; k < REF_COUNT; k++)
            failures += failures_of(arithmetic.name, k, &tally[k], (long)(8 * size));
    }
    assert_int_equal(failures, 0);
}
