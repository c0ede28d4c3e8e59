/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A floor that slopes, compared with a table from 40-digit arithmetic, and in limiting cases. */
#include "support.h"

static const double degree = 3.14159265358979323846 / 180;

static struct setup train_of(double s, double degrees, double mu)
{
    struct setup train = setup_default();
    train.s = s;
    train.q = 3;
    train.alpha = degrees * degree;
    train.mu = mu;
    return train;
}

TEST(largest_growths)
{
    static const double table[][3] = {/* s, slope, r_max */
                                      {0.2, -1, 1.48052142}, {0.2, 0, 1.55478182},  {0.2, 1, 1.64507145},
                                      {0.2, 2, 1.75719157},  {0.3, -1, 1.71622498}, {0.3, 0, 1.81350829},
                                      {0.3, 1, 1.93065102},  {0.3, 2, 2.07536161},  {0.4, -1, 1.93981351},
                                      {0.4, 0, 2.06377177},  {0.4, 1, 2.22126200},  {0.4, 2, 2.40239954}};
    for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
        struct domq_limit limit;
        struct setup train = train_of(table[i][0], table[i][1], 0);
        assert_status(ask_limit_rmax(&train, &limit), DOM_OK);
        assert_near("r_max", (double)limit.r_max, table[i][2], 3e-9);
    }
}

/* Checks that a domino tips over earlier by alpha, and that a slope on which no domino stands is an error. */
TEST(slopes_that_do_not_hold)
{
    struct setup train = train_of(0.4, 0, 0);
    struct domq_angles angles;
    double edge = atan(7.0 / 48);
    for (int side = -1; side <= 1; side += 2) {
        train.alpha = side * edge * (1 + 1e-12);
        assert_status(ask_train_check(&train), DOM_NO_STAND);
        train.alpha = side * edge * (1 - 1e-12);
        assert_status(ask_angles_find(&train, &angles), DOM_OK);
        assert_near("theta_u", (double)angles.theta_u, edge - (double)train.alpha, 1e-3);
    }
    train.alpha = 2;
    assert_status(ask_train_check(&train), DOM_BAD_ALPHA);
    train.alpha = 0.01;
    train.method = DOM_METHOD_GSL;
    struct domq_limit limit;
    assert_status(ask_limit_rmax(&train, &limit), DOM_NO_METHOD);
    train.method = DOM_METHOD_OURS;
    train.fuel = DOM_FUEL_PAPER;
    assert_status(ask_limit_rmax(&train, &limit), DOM_NO_METHOD);
    assert_status(ask_limit_pair(&train, &limit), DOM_OK);
    struct domq_launch launch;
    assert_status(ask_launch_find(&train, &launch), DOM_NO_METHOD);
}
