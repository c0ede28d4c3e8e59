/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Needs: rows */
/* Boxes of six walls. The moment of inertia is compared with other formulas. A train must move as it does
 * without walls, except for its unit of time. Walls are tried at their limits. */
#include "support.h"

TEST(thin_and_solid)
{
    struct domq_box box;
    const double d = 7.0 / 48;
    /* For thin walls the moment of inertia follows from their areas: 1 + (1 + d) / (2 (1 + d^2) (1 + 1/d +
     * 1/w)), w = 1/2. */
    double thin = 1 + (1 + d) / (2 * (1 + d * d) * (1 + 1 / d + 2));
    assert_near("thin", thin, 1.0569, 2e-5);
    assert_status(domq_box_find(1, d, 0.5, 1e-9, &box), DOM_OK);
    assert_near("thin", (double)box.inertia, thin, 1e-7);
    assert_near("filled", (double)box.filled, 2e-9 * (1 + 1 / d + 2), 1e-7);
    /* Walls that are half as thick as the box fill it. Slightly thinner walls leave a slit. */
    assert_status(domq_box_find(48, 7, 24, 3.5, &box), DOM_OK);
    assert_true(box.inertia == 1 && box.filled == 1);
    assert_status(domq_box_find(48, 7, 24, 3.4999, &box), DOM_OK);
    assert_true(box.inertia > 1 && box.inertia < 1.0001 && box.filled < 1 && box.filled > 0.9999);
    /* Walls of 4 mm in a box of 100 x 30 x 50 mm leave a hollow of 92 x 22 x 42 mm. */
    assert_status(domq_box_find(0.1, 0.03, 0.05, 0.004, &box), DOM_OK);
    double v = 92 * 22 * 42 / 150000.0, u = (92.0 * 92 + 22 * 22) / (100 * 100 + 30 * 30);
    assert_near("filled", (double)box.filled, 1 - v, 1e-14);
    assert_near("inertia", (double)box.inertia, ((1 - v * u) / (1 - v) + 3) / 4, 1e-14);
}

TEST(no_room)
{
    struct domq_box box = {.inertia = -1};
    const domq_real bad[][4] = {{48, 7, 24, 3.6},     {48, 7, 24, 0}, {48, 7, 24, -1}, {48, 7, 24, DOMQ_NAN},
                                {48, 7, 0, 1},        {0, 7, 24, 1},  {48, 0, 24, 1},  {48, DOMQ_NAN, 24, 1},
                                {DOMQ_NAN, 7, 24, 1}, {48, 7, -2, 1}, {-48, -7, 24, 1}};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
        assert_status(domq_box_find(bad[i][0], bad[i][1], bad[i][2], bad[i][3], &box), DOM_NO_ROOM);
    assert_true(box.inertia == -1);
    struct setup train = setup_default();
    struct domq_limit limit;
    train.walls = train.d / 2 * (1 + 1e-9);
    assert_status(ask_check(&train), DOM_NO_ROOM);
    assert_status(ask_limit_rmax(&train, &limit), DOM_NO_ROOM);
    train.walls = train.d / 2;
    assert_status(ask_check(&train), DOM_OK);
    /* An error in a row names the domino. */
    struct domq_domino domino[] = {
        {0.048, 0.007, 0, 1, 0, 0, 0}, {0.072, 0.006, 0.02, 1, 0, 0, 0}, {0.1, 0.02, 0.03, 1, 0, 0, 0}};
    struct row_setup row = row_setup_default(domino, 3, 4);
    struct domq_verdict verdict = {.domino = 0};
    row.walls = 0.0032;
    assert_status(ask_row_run(&row, true, NULL, NULL, &verdict), DOM_NO_ROOM);
    assert_int_equal(verdict.domino, 2);
    row.walls = 0.003;
    for (row.precision = IN_FLOAT; row.precision <= IN_QUAD; row.precision++) {
        row.tol = row.precision == IN_FLOAT ? 1e-5 : 1e-12;
        if (any_arithmetic(row.precision).bits)
            assert_status(ask_row_run(&row, true, NULL, NULL, &verdict), DOM_OK);
    }
}

/* Checks that walls change nothing but tau: in units of tau, a train moves as it does without walls, with
 * every law, precision and fuel. Checks the factor of tau, too. */
TEST(trains_move_as_without)
{
    for (int k = 0; k < 20; k++) {
        struct setup solid = setup_default(), box;
        solid.r = 1.2;
        solid.precision = (enum precision)(k % 3);
        solid.tol = k % 3 == 0 ? 1e-5 : 1e-12;
        solid.mu = k & 4 ? 0.2 : 0;
        solid.alpha = k & 8 ? 0.01 : 0;
        if (k >= 16) {
            solid.mu = solid.alpha = 0;
            solid.fuel = k % 2 ? DOM_FUEL_PAPER : DOM_FUEL_EXACT;
        }
        if (!any_arithmetic(solid.precision).bits)
            continue;
        box = solid;
        box.walls = 0.02;
        struct domq_limit a = {.r_max = 0}, b = {.r_max = 1};
        domq_real of_a = 0, of_b = 1;
        assert_status(ask_limit_rmax(&solid, &a), DOM_OK);
        assert_status(ask_limit_rmax(&box, &b), DOM_OK);
        assert_true(a.r_max == b.r_max && a.ends == b.ends);
        assert_status(ask_cycle_duration(&solid, &of_a), DOM_OK);
        assert_status(ask_cycle_duration(&box, &of_b), DOM_OK);
        assert_true(of_a == of_b);
    }
    struct domq_scale scale = domq_scale_default();
    struct domq_train train = domq_train_default();
    struct domq_box found;
    domq_real tau = domq_scale_tau(&scale, &train);
    train.walls = 0.03;
    for (int k = 0; k < 2; k++) {
        train.width = k ? domq_train_default().width : (domq_real)0.2;
        assert_status(domq_box_find(1, train.d, train.width, 0.03, &found), DOM_OK);
        assert_near("tau", (double)(domq_scale_tau(&scale, &train) / tau), sqrt((double)found.inertia),
                    1e-15);
    }
    assert_near("speed", (double)domq_scale_speed(&scale, &train, 9),
                (0.4 + 7.0 / 48) * 1.5 * 0.048 / (9 * (double)tau * sqrt((double)found.inertia)), 1e-13);
}

enum { COUNT = 12 };

/* Checks that the dominoes of a train have its width, and that a width that is half of the height is the
 * usual one. */
TEST(rows_of_wide_trains)
{
    struct domq_domino wide[COUNT], usual[COUNT];
    struct domq_train train = domq_train_default();
    struct domq_scale scale = domq_scale_default();
    struct domq_verdict a, b;
    domq_row_of_train(&train, &scale, 1, usual, COUNT);
    train.width = 2;
    domq_row_of_train(&train, &scale, 1, wide, COUNT);
    for (size_t k = 0; k < COUNT; k++) {
        assert_true(usual[k].width == usual[k].height / 2);
        assert_true(wide[k].width == 2 * wide[k].height && wide[k].mass == usual[k].mass);
    }
    struct row_setup row = row_setup_default(usual, COUNT, 4);
    row.walls = 0.001;
    assert_status(ask_row_run(&row, true, NULL, NULL, &a), DOM_OK);
    for (size_t k = 0; k < COUNT; k++)
        usual[k].width = 0;
    assert_status(ask_row_run(&row, true, NULL, NULL, &b), DOM_OK);
    assert_true(a.seconds == b.seconds && a.spare == b.spare);
}

/* Checks that boxes with the same mass and the same moment of inertia fall alike, however wide they are, on
 * rounded edges, too, and that they need the same friction of the floor. */
TEST(width_counts_only_in_the_inertia)
{
    struct domq_domino domino[COUNT];
    struct domq_verdict verdict[2];
    struct domq_box narrow, wide;
    struct dom_floor floor[COUNT];
    domq_real low = 0.0001, high = 0.0034;
    double needs[2] = {0, 0};
    assert_status(domq_box_find(0.048, 0.007, 0.009, 0.001, &narrow), DOM_OK);
    for (int k = 0; k < 60; k++) { /* thicker walls have a smaller moment of inertia */
        const domq_real walls = (low + high) / 2;
        assert_status(domq_box_find(0.048, 0.007, 0.024, walls, &wide), DOM_OK);
        *(wide.inertia > narrow.inertia ? &low : &high) = walls;
    }
    for (size_t k = 0; k < COUNT; k++)
        domino[k] = (struct domq_domino){0.048, 0.007, 0.013, 0.01, 0, 0, 0.009};
    struct row_setup row = row_setup_default(domino, COUNT, 3);
    row.rho = (domq_real)0.02;
    for (int k = 0; k < 2; k++) {
        row.walls = k == 0 ? (domq_real)0.001 : low;
        assert_status(ask_row_run(&row, true, NULL, NULL, &verdict[k]), DOM_OK);
        assert_status(ask_row_floor(&row, floor), DOM_OK);
        for (size_t i = 0; i < COUNT; i++) {
            needs[k] += isfinite(floor[i].motion) ? floor[i].motion : 0; /* infinite where a foot is lifted */
            domino[i].width = 0;
        }
    }
    assert_near("seconds", (double)verdict[0].seconds, (double)verdict[1].seconds, 1e-12);
    assert_near("spare", (double)verdict[0].spare, (double)verdict[1].spare, 1e-12);
    assert_true(needs[0] > 0);
    assert_near("floor", needs[0], needs[1], 1e-12);
}
