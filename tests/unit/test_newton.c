/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The endless train against Newton's equations (direct.h): a long row of boxes, pushed, integrated without
 * any formula for energies, has the train's largest growth and its durations.
 */
#include "direct.h"
#include "support.h"

enum { MOST = 64 };

static const double stature = 7.0 / 48;

struct row {
    double height[MOST], thickness[MOST], gap[MOST], mass[MOST];
    struct direct_hit hit[MOST];
    struct direct_result result;
};

static struct asked train_of(double s, double q, double mu)
{
    struct asked train = asked_default();
    train.s = s;
    train.d = stature;
    train.q = q;
    train.mu = mu;
    return train;
}

/* Returns true if n boxes fall, each r times the one before, with the first of height 1 and g = 1. */
static bool falls(struct row *row, const struct asked *train, double r, size_t n, double push)
{
    for (size_t k = 0; k < n; k++) {
        row->height[k] = pow(r, k);
        row->thickness[k] = stature * row->height[k];
        row->gap[k] = (double)train->s * row->height[k];
        row->mass[k] = pow(row->height[k], (double)train->q - 1);
    }
    struct direct_row of = {
        n, row->height, row->thickness, row->gap, row->mass, (double)train->mu, 1.0, push, 0, 0, NULL};
    const char *wrong = direct_run(&of, row->hit, &row->result);
    if (wrong)
        fail_msg("%s", wrong);
    return row->result.all_fall;
}

/*
 * Checks that the row falls just below the train's growth and stops just above it. The push is so strong, and
 * the row so long, that the row's own limit is that of the train to 1e-10; the integrator keeps 1e-13 in a
 * step.
 */
TEST(largest_growths)
{
    static const double some[][3] = {/* s, q, mu */
                                     {0.3, 3, 0},   {0.4, 3, 0},   {0.4, 4, 0},   {0.5, 3, 0},
                                     {0.5, 4, 0},   {0.3, 3, 0.2}, {0.4, 3, 0.2}, {0.4, 4, 0.2},
                                     {0.5, 4, 0.2}, {0.6, 3, 0.2}, {0.6, 4, 0.4}};
    static struct row row;
    for (size_t i = 0; i < sizeof some / sizeof *some; i++) {
        struct asked train = train_of(some[i][0], some[i][1], some[i][2]);
        struct domq_limit limit;
        assert_status(ask_limit_rmax(&train, &limit, NULL), DOM_OK);
        assert_int_equal(limit.ends, DOM_END_BARRIER);
        for (int side = -1; side <= 1; side += 2)
            if (falls(&row, &train, (double)limit.r_max * (1 + side * 1e-9), 12, 32) != (side < 0))
                fail_msg("s %g, q %g, mu %g: a row %s by 1e-9 %s r_max %.12g", some[i][0], some[i][1],
                         some[i][2], side < 0 ? "stops" : "falls", side < 0 ? "below" : "above",
                         (double)limit.r_max);
    }
}

/* Checks the duration of the last cycle but one, when the row has forgotten its push. */
TEST(durations)
{
    static const double some[][4] = {/* s, r, q, mu */
                                     {0.6, 1, 3, 0},     {0.3, 1.4, 3, 0},  {0.4, 1.5, 4, 0},
                                     {0.5, 1.9, 3, 0},   {0.5, 1, 3, 0.2},  {0.6, 1, 4, 0.4},
                                     {0.3, 1.4, 4, 0.2}, {0.4, 1.5, 3, 0.4}};
    static struct row row;
    for (size_t i = 0; i < sizeof some / sizeof *some; i++) {
        struct asked train = train_of(some[i][0], some[i][2], some[i][3]);
        domq_real duration;
        double r = some[i][1];
        size_t n = r > 1 ? 24 : MOST;
        train.r = some[i][1];
        assert_status(ask_cycle_duration(&train, &duration, NULL), DOM_OK);
        assert_true(falls(&row, &train, r, n, 1.5));
        struct domq_scale scale = {.h = row.height[n - 2], .g = 1};
        double took = (row.hit[n - 1].time - row.hit[n - 2].time) /
                      (double)domq_scale_tau(&scale, &(struct domq_train){.d = stature});
        assert_near("duration", took, duration, 1e-11);
    }
}
