/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Rows and the endless train compared with Newton's equations (direct.h), which are integrated without any
 * formula for energies. A long row of boxes with a push has the largest growth and the durations of the
 * train, also on a slope. Uneven rows with a slope, walls and friction have the hits of the model.
 */
#include "run.h"
#include "support.h"

static const double stature = 7.0 / 48, degree = M_PI / 180;

static struct asked train_of(double s, double q, double mu, double degrees)
{
    struct asked train = asked_default();
    train.s = s;
    train.d = stature;
    train.q = q;
    train.mu = mu;
    train.alpha = degrees * degree;
    return train;
}

/* Makes a row of n boxes, each r times as large as the one before. The first has the height 1, and g is 1. */
static void boxes_of(struct run *run, const struct asked *train, double r, size_t n, double push)
{
    for (size_t k = 0; k < n; k++) {
        double h = pow(r, (double)k);
        run->domino[k] = (struct domq_domino){.height = h,
                                              .thickness = (double)train->d * h,
                                              .gap = (double)train->s * h,
                                              .mass = pow(h, (double)train->q - 1)};
    }
    run->row = (struct asked_row){.domino = run->domino,
                                  .count = n,
                                  .g = 1,
                                  .push = push,
                                  .mu = train->mu,
                                  .alpha = train->alpha,
                                  .tol = train->tol,
                                  .precision = DOM_DOUBLE};
}

static bool falls(const struct run *run, struct newton *n)
{
    newton_run(run, n);
    if (n->wrong)
        fail_msg("%s", n->wrong);
    return n->result.all_fall;
}

/*
 * Checks that the row falls just below the largest growth of the train and stops just above it. The push is
 * so strong, and the row so long, that the limits of the row and the train agree to 1e-10. The integrator has
 * a tolerance of 1e-13 in each step.
 */
TEST(largest_growths)
{
    static const double some[][4] = {/* s, q, mu, degrees */
                                     {0.3, 3, 0, 0},   {0.4, 3, 0, 0},   {0.4, 4, 0, 0},   {0.5, 3, 0, 0},
                                     {0.5, 4, 0, 0},   {0.3, 3, 0.2, 0}, {0.4, 3, 0.2, 0}, {0.4, 4, 0.2, 0},
                                     {0.5, 4, 0.2, 0}, {0.6, 3, 0.2, 0}, {0.6, 4, 0.4, 0}, {0.3, 3, 0, -1},
                                     {0.4, 3, 0, 2},   {0.3, 3, 0.2, 1}};
    static struct run run;
    static struct newton n;
    for (size_t i = 0; i < sizeof some / sizeof *some; i++) {
        struct asked train = train_of(some[i][0], some[i][1], some[i][2], some[i][3]);
        struct domq_limit limit;
        assert_status(ask_limit_rmax(&train, &limit, NULL), DOM_OK);
        assert_int_equal(limit.ends, DOM_END_BARRIER);
        for (int side = -1; side <= 1; side += 2) {
            boxes_of(&run, &train, (double)limit.r_max * (1 + side * 1e-9), 12, 32);
            if (falls(&run, &n) != (side < 0))
                fail_msg("s %g, q %g, mu %g, %g deg: a row %s by 1e-9 %s r_max %.12g", some[i][0], some[i][1],
                         some[i][2], some[i][3], side < 0 ? "stops" : "falls", side < 0 ? "below" : "above",
                         (double)limit.r_max);
        }
    }
}

/* Checks the duration of the last cycle but one, by which the effect of the push has vanished. */
TEST(durations)
{
    static const double some[][4] = {/* s, r, q, mu */
                                     {0.6, 1, 3, 0},     {0.3, 1.4, 3, 0},  {0.4, 1.5, 4, 0},
                                     {0.5, 1.9, 3, 0},   {0.5, 1, 3, 0.2},  {0.6, 1, 4, 0.4},
                                     {0.3, 1.4, 4, 0.2}, {0.4, 1.5, 3, 0.4}};
    static struct run run;
    static struct newton n;
    for (size_t i = 0; i < sizeof some / sizeof *some; i++) {
        struct asked train = train_of(some[i][0], some[i][2], some[i][3], 0);
        domq_real duration;
        size_t count = some[i][1] > 1 ? 24 : ROW_MOST;
        train.r = some[i][1];
        assert_status(ask_cycle_duration(&train, &duration, NULL), DOM_OK);
        boxes_of(&run, &train, some[i][1], count, 1.5);
        assert_true(falls(&run, &n));
        struct domq_scale scale = {.h = run.domino[count - 2].height, .g = 1};
        double tau = (double)domq_scale_tau(&scale, &(struct domq_train){.d = stature});
        assert_near("duration", (n.hit[count - 1].time - n.hit[count - 2].time) / tau, duration, 1e-11);
    }
}

TEST(uneven_rows)
{
    static const double scene[][5] = {/* r, degrees, mu, walls, push */
                                      {1.2, 1, 0, 0, 1.5},    {1.2, -1, 0, 0, 1.5},     {1.4, 2, 0, 0, 1.5},
                                      {1.1, 3, 0.2, 0, 1.5},  {1.3, 1, 0.2, 0, 2},      {1, -2, 0.1, 0, 2},
                                      {1.2, 0, 0, 1e-3, 2},   {1.4, 0, 0, 0.03, 2},     {1, 1.1, 0, 0.06, 2},
                                      {1.2, 0, 0.2, 0.04, 2}, {1.3, -0.6, 0.1, 0.01, 2}};
    static struct run run;
    static struct newton n;
    for (size_t i = 0; i < sizeof scene / sizeof *scene; i++) {
        struct asked train = train_of(0.4, 3, scene[i][2], scene[i][1]);
        train.d = 0.15;
        boxes_of(&run, &train, scene[i][0], 12, scene[i][4]);
        run.row.walls = scene[i][3];
        for (size_t k = 0; k < 12; k++) {
            double uneven = 1 + 0.05 * sin(3.0 * (double)k);
            run.domino[k].thickness *= uneven;
            run.domino[k].gap /= uneven;
            run.domino[k].mass *= uneven;
        }
        assert_status(run_whole(&run), DOM_OK);
        newton_run(&run, &n);
        newton_compare(&run, &n);
    }
}
