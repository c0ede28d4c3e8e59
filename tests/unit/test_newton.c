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
