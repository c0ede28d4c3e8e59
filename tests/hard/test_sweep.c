/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Random trains over the whole parameter space, in every precision. At the smallest tolerance each answer is
 * as good as its inputs allow (reference.h); at any other it is as good as the tolerance; and the library's
 * own error bounds are true, and not much too large. The largest error of each quantity is printed.
 */
#include "../unit/support.h"
#include "sweep.h"

/* The allowed errors in units; the tolerance itself is about 9 units. */
static const double units_allowed[REF_COUNT] = {
    [REF_LINK_THETA] = 24, /* each of hundreds of dominoes adds a rounding */
};

/* Half of the bounds are at most this many times the error. */
static const double closeness = 100;

struct swept {
    struct sweep sweep;
    long done;
    struct tally tally[REF_COUNT];
};

static struct swept sweeps[] = {
    {.sweep = {DOM_DOUBLE, 3, 20000, .barriers = 6, .durations = 25, .growths = 20, .pairs = 50}},
    {.sweep = {DOM_FLOAT, 2, 4000, .barriers = 8, .durations = 50, .growths = 20, .pairs = 20}},
    {.sweep = {DOM_QUAD, 3, 1500, .barriers = 6, .durations = 15, .growths = 10, .pairs = 20}},
};

/* The part of the points that is checked. In a part the quantities need not occur as often, and half of the
 * bounds are those of a few trains. */
static double size = 1;

static const char *label(const struct swept *swept)
{
    return domq_arithmetic(swept->sweep.precision)->name;
}

/* Skips a precision that this machine does not have. */
static struct swept *look_at(void **state)
{
    struct swept *swept = *state;
    if (domq_arithmetic(swept->sweep.precision)->bits == 0)
        skip();
    return swept;
}

static void report(const struct swept *swept)
{
    for (int k = 0; k < REF_COUNT; k++) {
        const struct tally *t = &swept->tally[k];
        if (t->checked > 0)
            fprintf(stderr,
                    "# %-6s %-15s %6ld: %8.3g units, %8.3g of tol, %8.3g of bound, bound %8.3g times\n",
                    label(swept), ref_name((enum ref_quantity)k), t->checked,
                    fmax(t->units.excess, TALLY_UNITS), t->tol.excess, t->bound.excess, tally_median(t));
    }
}

static void all_points_are_looked_at(void **state)
{
    struct swept *swept = look_at(state);
    swept->done = sweep_run(&swept->sweep, swept->tally);
    report(swept);
    assert_int_equal(swept->done, swept->sweep.points);
    /* Every quantity that is not for a whole curve must occur. */
    const long least = (long)(8 * size);
    assert_true(swept->tally[REF_THETA_C].checked >= swept->done);
    for (int k = 0; k <= REF_PAIR; k++)
        if (swept->tally[k].checked < least)
            fail_msg("%s %s was looked at %ld times", label(swept), ref_name((enum ref_quantity)k),
                     swept->tally[k].checked);
}

/* Prints one line for each quantity with a sample beyond its limit, then fails. */
static void judge(const struct swept *swept, const char *what, size_t sample, const double limit[REF_COUNT],
                  double usual)
{
    int failures = 0;
    for (int k = 0; k < REF_COUNT; k++) {
        const struct sample *worst = (const struct sample *)((const char *)&swept->tally[k] + sample);
        const double allowed = limit && limit[k] > 0 ? limit[k] : usual;
        if (worst->excess <= allowed)
            continue;
        failures++;
        fprintf(stderr, "# %s, %.3g allowed\n", what, allowed);
        tally_print(label(swept), (enum ref_quantity)k, worst);
    }
    if (failures)
        fail_msg("%s: %d quantities: %s", label(swept), failures, what);
}

static void errors_are_those_of_the_inputs(void **state)
{
    judge(look_at(state), "units of error", offsetof(struct tally, units), units_allowed, 16);
}

static void tolerances_are_kept(void **state)
{
    judge(look_at(state), "of tolerance and conditioning", offsetof(struct tally, tol), NULL, 1);
}

static void bounds_hold(void **state)
{
    const struct swept *swept = look_at(state);
    judge(swept, "of the library's bound", offsetof(struct tally, bound), NULL, 1);
    for (int k = 0; k < REF_COUNT; k++)
        if (swept->tally[k].without_bound)
            fail_msg("%s %s: %ld values have no bound", label(swept), ref_name((enum ref_quantity)k),
                     swept->tally[k].without_bound);
}

static void bounds_are_close(void **state)
{
    const struct swept *swept = look_at(state);
    int failures = 0;
    if (size < 1)
        skip();
    for (int k = 0; k < REF_COUNT; k++) {
        if (swept->tally[k].bounds == 0 || tally_median(&swept->tally[k]) <= closeness)
            continue;
        failures++;
        fprintf(stderr, "# %s %s: half of the bounds are more than %.3g times the error, %.3g allowed\n",
                label(swept), ref_name((enum ref_quantity)k), tally_median(&swept->tally[k]), closeness);
    }
    if (failures)
        fail_msg("%s: bounds of %d quantities are too wide", label(swept), failures);
}

static void statuses_are_right(void **state)
{
    const struct swept *swept = look_at(state);
    int failures = 0;
    for (int k = 0; k < REF_COUNT; k++) {
        const struct tally *t = &swept->tally[k];
        if (!t->wrong)
            continue;
        failures++;
        fprintf(stderr, "# %s %s: wrong %ld times, first: %s\n", label(swept), ref_name((enum ref_quantity)k),
                t->wrong, t->what);
        tally_print(label(swept), (enum ref_quantity)k, &t->mistake);
    }
    if (failures)
        fail_msg("%s: %d quantities contradict the reference", label(swept), failures);
}

#define SWEEP(k, name)                                                                                       \
    {name ": all_points_are_looked_at", all_points_are_looked_at, NULL, NULL, &sweeps[k]},                   \
        {name ": errors_are_those_of_the_inputs", errors_are_those_of_the_inputs, NULL, NULL, &sweeps[k]},   \
        {name ": tolerances_are_kept", tolerances_are_kept, NULL, NULL, &sweeps[k]},                         \
        {name ": bounds_hold", bounds_hold, NULL, NULL, &sweeps[k]},                                         \
        {name ": bounds_are_close", bounds_are_close, NULL, NULL, &sweeps[k]},                               \
    {                                                                                                        \
        name ": statuses_are_right", statuses_are_right, NULL, NULL, &sweeps[k]                              \
    }

int main(void)
{
    size = sweep_size();
    for (size_t k = 0; k < sizeof sweeps / sizeof *sweeps; k++)
        sweeps[k].sweep.points = (int)ceil(size * sweeps[k].sweep.points);
    const struct CMUnitTest tests[] = {SWEEP(0, "double"), SWEEP(1, "float"), SWEEP(2, "quad")};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
