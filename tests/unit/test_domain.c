/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Parameters outside their ranges: which status the library returns, and that it writes nothing then. */
#include "support.h"

/* Statuses of the parameters in the lists. */
#define BAD_s   DOM_BAD_S
#define BAD_r   DOM_BAD_R
#define BAD_d   DOM_BAD_D
#define BAD_q   DOM_BAD_Q
#define BAD_tol DOM_BAD_TOL

TEST(parameters_have_ranges)
{
    struct asked train = asked_default();
    assert_status(ask_train_check(&train), DOM_OK);
#define REFUSE(name, default_, lowest, highest, unit, meaning)                                               \
    for (int k = 0; k < 4; k++) {                                                                            \
        const double bad[] = {DOMQ_NAN, (double)INFINITY, (lowest) * (1 - 1e-9), (highest) * (1 + 1e-9)};    \
        train = asked_default();                                                                             \
        train.name = bad[k];                                                                                 \
        assert_status(ask_train_check(&train), BAD_##name);                                                  \
    }
    DOMQ_TRAIN_PARAMETERS(REFUSE)
    DOMQ_COMPUTE_PARAMETERS(REFUSE)
#undef REFUSE
}

TEST(head_must_reach_the_next)
{
    struct asked train = asked_default();
    struct domq_angles angles = {.theta_c = -1};
    train.s = 0.7;
    assert_status(ask_train_check(&train), DOM_OUT_OF_REACH);
    assert_status(ask_angles_find(&train, &angles, NULL), DOM_OUT_OF_REACH);
    assert_true(angles.theta_c == -1);
    /* 1/s, rounded to a double, is the reach for every s; one unit more is not. */
    for (double s = 0.011; s < 1; s += 0.007) {
        train.s = s;
        train.r = 1 / s;
        assert_status(ask_train_check(&train), DOM_OK);
        train.r = (1 / s) * (1 + 4e-16);
        assert_status(ask_train_check(&train), DOM_OUT_OF_REACH);
    }
}

TEST(tilts_lie_in_the_cycle)
{
    struct asked train = asked_default();
    struct domq_angles angles;
    struct domq_energy energy = {.J = -1};
    domq_real w;
    assert_status(ask_angles_find(&train, &angles, NULL), DOM_OK);
    const double bad[] = {-1e-300, -1, angles.theta_c * (1 + 1e-14), 4, DOMQ_NAN, (double)INFINITY};
    for (size_t k = 0; k < sizeof bad / sizeof *bad; k++) {
        assert_status(ask_energy_find(&train, bad[k], &energy, NULL), DOM_BAD_TILT);
        assert_status(ask_cycle_omegasq(&train, bad[k], &w, NULL), DOM_BAD_TILT);
    }
    assert_true(energy.J == -1);
    assert_status(ask_energy_find(&train, angles.theta_c, &energy, NULL), DOM_OK);
}

/* Checks two limits: (1) more than two million dominoes matter, (2) energies below the range of doubles. */
TEST(beyond_the_arithmetic)
{
    struct asked train = asked_default();
    struct domq_energy energy;
    train.s = 1e-6;
    train.d = 1e-12;
    train.r = 1;
    assert_status(ask_energy_find(&train, 0, &energy, NULL), DOM_TOO_LONG);
    train = asked_default();
    train.s = 1e-6;
    train.r = 1e6;
    train.q = 60;
    assert_status(ask_energy_find(&train, 0, &energy, NULL), DOM_UNDERFLOW);
}

TEST(interrupt_stops_the_work)
{
    struct asked train = asked_default();
    struct domq_limit limit;
    struct domq_best best;
    volatile sig_atomic_t flag = 0;
    train.interrupt = &flag;
    assert_status(ask_limit_rmax(&train, &limit, NULL, NULL), DOM_OK);
    flag = 1;
    assert_status(ask_limit_rmax(&train, &limit, NULL, NULL), DOM_INTERRUPTED);
    assert_status(ask_limit_best(&train, &best, NULL), DOM_INTERRUPTED);
}

/* Checks d > h: no domino tips over far enough to topple a larger one, at any separation. */
TEST(thick_dominoes_do_not_grow)
{
    struct asked train = asked_default();
    struct domq_best best;
    struct domq_limit limit;
    train.d = 1.5;
    assert_status(ask_limit_best(&train, &best, NULL), DOM_NO_GROWTH);
    assert_status(ask_limit_rmax(&train, &limit, NULL, NULL), DOM_OK);
    assert_int_equal(limit.ends, DOM_END_NONE);
    assert_status(ask_limit_pair(&train, &limit, NULL), DOM_OK);
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

TEST(counting)
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
        assert_status(ask_count_find(DOM_DOUBLE, known[i].first, known[i].height, known[i].r, &count, NULL),
                      DOM_OK);
        assert_near("dominoes", count.dominoes, known[i].n, 0);
        assert_near("the last", count.last, known[i].first * pow(known[i].r, known[i].n), 1e-9);
    }
    /* 48 mm doubled k times, as a person would type it, with 6 to 17 digits. */
    for (int k = 1; k < 60; k++) {
        for (int digits = 15; digits <= 17; digits++) {
            char text[40];
            snprintf(text, sizeof text, "%.*g", digits, ldexp(0.048, k));
            assert_status(ask_count_find(DOM_DOUBLE, 0.048, strtod(text, NULL), 2, &count, NULL), DOM_OK);
            assert_near("dominoes", count.dominoes, k, 0);
            assert_status(
                ask_count_find(DOM_DOUBLE, 0.048, strtod(text, NULL) * (1 + 1e-13), 2, &count, NULL), DOM_OK);
            assert_near("dominoes", count.dominoes, k + 1, 0);
        }
    }
    assert_status(ask_count_find(DOM_DOUBLE, 0.048, 112, 1, &count, NULL), DOM_OK);
    assert_true(isinf(count.dominoes) && isnan(count.last));
    assert_status(ask_count_find(DOM_DOUBLE, 0.048, 112, 0.9, &count, NULL), DOM_BAD_R);
    assert_status(ask_count_find(DOM_DOUBLE, 0.048, -1, 2, &count, NULL), DOM_BAD_HEIGHT);
    assert_status(ask_count_find(DOM_DOUBLE, 0.048, DOMQ_NAN, 2, &count, NULL), DOM_BAD_HEIGHT);
    assert_status(ask_count_find(DOM_DOUBLE, 1e-300, 1e300, 2, &count, NULL), DOM_BAD_HEIGHT);
}

TEST(metres_and_seconds)
{
    struct asked train = asked_default();
    struct domq_scale scale = domq_scale_default();
    /* (1; a1) by hand: sqrt((0.048^2 + 0.007^2) / (3 9.81 0.048)) s. */
    double tau = sqrt((0.048 * 0.048 + 0.007 * 0.007) / (3 * 9.81 * 0.048));
    assert_near("tau", domq_scale_tau(&scale, &(struct domq_train){.d = train.d}), tau, 1e-15);
    /* Frictionless equal dominoes of 48 x 7 mm at a pitch of 20 mm run at 1.28427 m/s. */
    domq_real duration;
    train.r = 1;
    train.s = 13.0 / 48;
    assert_status(ask_cycle_duration(&train, &duration, NULL), DOM_OK);
    assert_near("speed", ask_scale_speed(&scale, &train, duration), 1.28427, 5e-6);
    /* In a growing train the distance of a cycle is the pitch of the next, larger domino. */
    train.r = 1.5;
    assert_near("speed", ask_scale_speed(&scale, &train, 2), 1.5 * 0.020 / (2 * tau), 1e-14);
}
