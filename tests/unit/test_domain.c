/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Trains that cannot grow, the texts of statuses, and physical units. */
#include "support.h"

/* Checks that there is no domino effect for s <= 2 d^3 / (1 - d^2): 0.0063378 for the standard domino. */
TEST(no_fuel_below_a_separation)
{
    struct setup train = setup_default();
    struct domq_limit limit;
    double edge = 2 * pow(train.d, 3) / (1 - train.d * train.d);
    assert_near("edge", edge, 0.0063378, 1e-5);
    train.s = edge * (1 - 1e-9);
    assert_status(ask_limit_rmax(&train, &limit), DOM_OK);
    assert_int_equal(limit.ends, DOM_END_NONE);
    assert_true(isnan(limit.r_max));
    assert_status(limit.why, DOM_NO_FUEL);
    train.s = edge * (1 + 1e-3);
    struct domq_fuels fuels;
    train.r = 1;
    assert_status(ask_fuel_find(&train, &fuels), DOM_OK);
    assert_true(fuels.exact > 0 && fuels.paper > 0);
}

/* Checks d > h: no domino tips over far enough to topple a larger one, at any separation. */
TEST(thick_dominoes_do_not_grow)
{
    struct setup train = setup_default();
    struct domq_best best;
    struct domq_limit limit;
    train.d = 1.5;
    assert_status(ask_limit_best(&train, &best), DOM_NO_GROWTH);
    assert_status(ask_limit_rmax(&train, &limit), DOM_OK);
    assert_int_equal(limit.ends, DOM_END_NONE);
    assert_status(ask_limit_pair(&train, &limit), DOM_OK);
    assert_int_equal(limit.ends, DOM_END_NONE);
}

TEST(every_status_has_a_text)
{
    for (enum dom_status k = DOM_OK; k <= DOM_INTERRUPTED; k++) {
        assert_true(strlen(dom_status_text(k)) > 5);
        for (enum dom_status j = DOM_OK; j < k; j++)
            assert_string_not_equal(dom_status_text(k), dom_status_text(j));
    }
}

TEST(metres_and_seconds)
{
    struct setup train = setup_default();
    struct domq_scale scale = domq_scale_default();
    /* (1; a1) by hand: sqrt((0.048^2 + 0.007^2) / (3 9.81 0.048)) s. */
    double tau = sqrt((0.048 * 0.048 + 0.007 * 0.007) / (3 * 9.81 * 0.048));
    assert_near("tau", domq_scale_tau(&scale, &(struct domq_train){.d = train.d}), tau, 1e-15);
    /* Frictionless equal dominoes of 48 x 7 mm at a pitch of 20 mm run at 1.28427 m/s. */
    domq_real duration;
    train.r = 1;
    train.s = 13.0 / 48;
    assert_status(ask_cycle_duration(&train, &duration), DOM_OK);
    assert_near("speed", ask_scale_speed(&scale, &train, duration), 1.28427, 5e-6);
    /* In a growing train, the front moves in each cycle by the pitch of the next, larger domino. */
    train.r = 1.5;
    assert_near("speed", ask_scale_speed(&scale, &train, 2), 1.5 * 0.020 / (2 * tau), 1e-14);
}
