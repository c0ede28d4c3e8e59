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

struct outcome {
    struct sweep sweep;
    long done;
    struct tally tally[REF_COUNT];
};

static struct outcome sweeps[] = {
    {.sweep = {IN_DOUBLE, 3, 20000, .barriers = 6, .durations = 25, .growths = 20, .pairs = 50}},
    {.sweep = {IN_FLOAT, 2, 4000, .barriers = 8, .durations = 50, .growths = 20, .pairs = 20}},
    {.sweep = {IN_QUAD, 3, 1500, .barriers = 6, .durations = 15, .growths = 10, .pairs = 20}},
};

/* The share of the points that are checked. With few points some quantities may not occur, and a median means
 * little. */
static double size;

static const char *label(const struct outcome *outcome)
{
    return any_arithmetic(outcome->sweep.precision).name;
}

/* Runs a check in each precision of this machine. The check returns the number of quantities that violate
 * it. */
static void check_all(int (*violations)(const struct outcome *outcome))
{
    int failures = 0;
    for (size_t k = 0; k < sizeof sweeps / sizeof *sweeps; k++)
        if (any_arithmetic(sweeps[k].sweep.precision).bits)
            failures += violations(&sweeps[k]);
    assert_int_equal(failures, 0);
}

static void report(const struct outcome *outcome)
{
    for (int k = 0; k < REF_COUNT; k++) {
        const struct tally *t = &outcome->tally[k];
        if (t->checked > 0)
            fprintf(stderr, "# %-6s %-15s %6ld: %8.3g units, %8.3g of tol\n", label(outcome),
                    ref_name((enum ref_quantity)k), t->checked, fmax(t->units.excess, TALLY_UNITS),
                    t->tol.excess);
    }
}

/* Returns how many quantities were checked too rarely, plus 1 if points are missing. A sweep does not check
 * the best separations. */
static int missing(const struct outcome *outcome)
{
    const long least = (long)(8 * size);
    int missing =
        outcome->done != outcome->sweep.points || outcome->tally[REF_THETA_C].checked < outcome->done;
    for (int k = 0; k <= REF_PAIR; k++)
        if (outcome->tally[k].checked < least) {
            fprintf(stderr, "# %s %s was checked %ld times\n", label(outcome), ref_name((enum ref_quantity)k),
                    outcome->tally[k].checked);
            missing++;
        }
    return missing;
}

TEST(all_points_are_checked)
{
    size = sweep_size();
    for (size_t k = 0; k < sizeof sweeps / sizeof *sweeps; k++) {
        struct outcome *outcome = &sweeps[k];
        outcome->sweep.points = (int)ceil(size * outcome->sweep.points);
        if (any_arithmetic(outcome->sweep.precision).bits == 0)
            continue;
        outcome->done = sweep_run(&outcome->sweep, outcome->tally);
        report(outcome);
    }
    check_all(missing);
}

/* Prints a quantity whose worst sample is beyond the limit. Returns 1 if it is beyond the limit, and 0
 * otherwise. */
static int beyond(const struct outcome *outcome, int k, const struct sample *worst, const char *what,
                  double allowed)
{
    if (worst->excess <= allowed)
        return 0;
    fprintf(stderr, "# %s, %.3g allowed\n", what, allowed);
    tally_print(label(outcome), (enum ref_quantity)k, worst);
    return 1;
}

static int beyond_any(const struct outcome *outcome)
{
    int failures = 0;
    for (int k = 0; k < REF_COUNT; k++) {
        failures += beyond(outcome, k, &outcome->tally[k].units, "units of error",
                           units_allowed[k] > 0 ? units_allowed[k] : 16);
        failures += beyond(outcome, k, &outcome->tally[k].tol, "of tolerance and conditioning", 1);
    }
    return failures;
}

TEST(errors_are_those_of_the_inputs_or_the_tolerance)
{
    check_all(beyond_any);
}

static int contradictions(const struct outcome *outcome)
{
    int failures = 0;
    for (int k = 0; k < REF_COUNT; k++) {
        const struct tally *t = &outcome->tally[k];
        if (!t->wrong)
            continue;
        failures++;
        fprintf(stderr, "# %s %s: wrong %ld times, first: %s\n", label(outcome),
                ref_name((enum ref_quantity)k), t->wrong, t->what);
        tally_print(label(outcome), (enum ref_quantity)k, &t->mistake);
    }
    return failures;
}

TEST(statuses_are_right)
{
    check_all(contradictions);
}
