/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Properties of all trains that do not depend on digits: identities, limits, monotony and continuity. */
#include "request.h"
#include "support.h"
#include <float.h>

enum { TRAINS = 400 };

/* Checks that the remaining energy has the relative tolerance tol, even if it is a small difference of large
 * energies. */
TEST(small_margins_keep_their_digits)
{
    for (int i = 0; i < 12; i++) {
        struct asked train = asked_default();
        struct domq_limit limit;
        struct domq_barrier rough, fine;
        train.s = 0.1 + 0.1 * (i % 4);
        train.q = 3 + 0.5 * (i % 3);
        assert_status(ask_limit_rmax(&train, &limit, NULL), DOM_OK);
        train.r = limit.r_max * (1 - (domq_real)1e-8);
        train.tol = 1e-14;
        assert_status(ask_barrier_find(&train, &fine, NULL), DOM_OK);
        train.tol = 1e-3;
        assert_status(ask_barrier_find(&train, &rough, NULL), DOM_OK);
        assert_near("margin", rough.margin, fine.margin, 1e-3);
    }
}

/* Checks that there is no domino effect for s <= 2 d^3 / (1 - d^2): 0.0063378 for the standard domino. */
TEST(no_fuel_below_a_separation)
{
    struct asked train = asked_default();
    struct domq_limit limit;
    double edge = 2 * pow(train.d, 3) / (1 - train.d * train.d);
    assert_near("edge", edge, 0.0063378, 1e-5);
    train.s = edge * (1 - 1e-9);
    assert_status(ask_limit_rmax(&train, &limit, NULL), DOM_OK);
    assert_int_equal(limit.ends, DOM_END_NONE);
    assert_true(isnan(limit.r_max));
    assert_status(limit.why, DOM_NO_FUEL);
    train.s = edge * (1 + 1e-3);
    struct domq_fuels fuels;
    train.r = 1;
    assert_status(ask_fuel_find(&train, &fuels, NULL), DOM_OK);
    assert_true(fuels.exact > 0 && fuels.paper > 0);
}

/* Checks that error bounds take no work unless they are requested, and do not change any digit of the
 * result. */
TEST(bounds_are_extra)
{
    uint64_t seed = 77;
    int barriers = 0, limits = 0;
    for (int i = 0; i < 60; i++) {
        struct asked train = random_train(&seed);
        struct dom_work plain = {0}, bounded = {0};
        struct domq_barrier without, with, error;
        struct domq_limit limit, limit_with, limit_error;
        train.precision = (enum dom_precision)(i % 3);
        train.tol = domq_arithmetic(train.precision)->tol_default;
        train.r = fmin(train.r, 3);
        train.work = &plain;
        enum dom_status status = ask_barrier_find(&train, &without, NULL);
        size_t passes = plain.passes;
        train.work = &bounded;
        if (ask_barrier_find(&train, &with, &error) != status)
            fail_msg("another verdict with bounds");
        if (status != DOM_OK && status != DOM_STOPS)
            continue;
        barriers++;
        assert_true(with.barrier == without.barrier && with.margin == without.margin &&
                    with.theta_m == without.theta_m);
        assert_true(error.margin > 0 && error.margin < without.kinetic + without.barrier);
        assert_true(bounded.passes >= passes);
        train.work = &plain;
        plain.passes = bounded.passes = 0;
        assert_status(ask_limit_rmax(&train, &limit, NULL), DOM_OK);
        train.work = &bounded;
        assert_status(ask_limit_rmax(&train, &limit_with, &limit_error), DOM_OK);
        assert_int_equal(limit.ends, limit_with.ends);
        if (limit.ends != DOM_END_BARRIER)
            continue;
        limits++;
        assert_true(limit.r_max == limit_with.r_max && limit_error.r_max > 0);
        assert_true(bounded.passes > plain.passes);
    }
    print_message("# %d barriers and %d limits with bounds\n", barriers, limits);
    assert_true(barriers > 30 && limits > 10);
}
