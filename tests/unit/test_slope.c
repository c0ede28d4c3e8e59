/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A floor that slopes: compared with a table from 40-digit arithmetic, with Newton's equations (direct.h),
 * and in its limits.
 */
#include "direct.h"
#include "support.h"

static const double degree = 3.14159265358979323846 / 180;

static struct asked train_of(double s, double degrees, double mu)
{
    struct asked train = asked_default();
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
        struct asked train = train_of(table[i][0], table[i][1], 0);
        assert_status(ask_limit_rmax(&train, &limit, NULL), DOM_OK);
        assert_near("r_max", (double)limit.r_max, table[i][2], 3e-9);
    }
}

enum { MOST = 32 };

struct row {
    double height[MOST], thickness[MOST], gap[MOST], mass[MOST];
    struct direct_hit hit[MOST];
    struct direct_result result;
    struct domq_domino domino[MOST];
};

/* Makes a row of n boxes of unequal shape, each about r times the one before. */
static void row_make(struct row *row, double r, double s, size_t n)
{
    for (size_t k = 0; k < n; k++) {
        double uneven = 1 + 0.05 * sin(3.0 * (double)k);
        row->height[k] = pow(r, (double)k);
        row->thickness[k] = 0.15 * uneven * row->height[k];
        row->gap[k] = s * row->height[k] / uneven;
        row->mass[k] = pow(row->height[k], 2) * uneven;
        row->domino[k] =
            (struct domq_domino){row->height[k], row->thickness[k], row->gap[k], row->mass[k], 0, 0};
    }
}

struct compared {
    const struct row *row;
    double worst;
};

static bool fall_seen(const struct domq_fall *fall, void *context)
{
    struct compared *c = context;
    const struct direct_hit *hit = &c->row->hit[fall->domino - 1];
    double of_omega = fabs((double)fall->omega / hit->omega - 1);
    double of_time = fabs((double)fall->time - hit->time),
           of_kinetic = fabs((double)fall->kinetic / hit->kinetic - 1);
    c->worst = fmax(c->worst, fmax(of_omega, fmax(of_time, of_kinetic)));
    return true;
}

TEST(rows_against_newton)
{
    static const double scene[][4] = {/* r, slope, mu, push */
                                      {1.2, 1, 0, 1.5},   {1.2, -1, 0, 1.5}, {1.4, 2, 0, 1.5},
                                      {1.1, 3, 0.2, 1.5}, {1.3, 1, 0.2, 2},  {1, -2, 0.1, 2}};
    enum { COUNT = 12 };
    static struct row row;
    for (size_t i = 0; i < sizeof scene / sizeof *scene; i++) {
        row_make(&row, scene[i][0], 0.4, COUNT);
        struct direct_row of = {COUNT, row.height,  row.thickness,        row.gap, row.mass, scene[i][2],
                                1.0,   scene[i][3], scene[i][1] * degree, 0,       NULL};
        assert_null(direct_run(&of, row.hit, &row.result));
        struct asked_row asked = {.domino = row.domino,
                                  .count = COUNT,
                                  .g = 1,
                                  .push = scene[i][3],
                                  .mu = scene[i][2],
                                  .alpha = scene[i][1] * degree,
                                  .tol = asked_default().tol,
                                  .precision = DOM_DOUBLE};
        struct domq_verdict verdict;
        struct compared c = {.row = &row};
        assert_status(ask_row_run(&asked, true, fall_seen, &c, &verdict), DOM_OK);
        assert_int_equal(verdict.end == DOM_ROW_FALLS, row.result.all_fall);
        assert_int_equal(verdict.domino, row.result.hit);
        if (!(c.worst < 1e-9))
            fail_msg("scene %zu: off by %g", i, c.worst);
    }
}

/* Checks that a long row falls just below the largest growth, and stops just above it. */
TEST(limits_against_newton)
{
    static const double some[][3] = {/* s, slope, mu */ {0.3, -1, 0}, {0.4, 2, 0}, {0.3, 1, 0.2}};
    static struct row row;
    enum { COUNT = 12 };
    for (size_t i = 0; i < sizeof some / sizeof *some; i++) {
        struct asked train = train_of(some[i][0], some[i][1], some[i][2]);
        struct domq_limit limit;
        assert_status(ask_limit_rmax(&train, &limit, NULL), DOM_OK);
        for (int side = -1; side <= 1; side += 2) {
            double r = (double)limit.r_max * (1 + side * 1e-9);
            for (size_t k = 0; k < COUNT; k++) {
                row.height[k] = pow(r, (double)k);
                row.thickness[k] = (double)train.d * row.height[k];
                row.gap[k] = some[i][0] * row.height[k];
                row.mass[k] = row.height[k] * row.height[k];
            }
            struct direct_row of = {COUNT, row.height, row.thickness,       row.gap, row.mass, some[i][2],
                                    1.0,   32,         (double)train.alpha, 0,       NULL};
            assert_null(direct_run(&of, row.hit, &row.result));
            assert_int_equal(row.result.all_fall, side < 0);
        }
    }
}

/* Checks the balance of energy: that at the beginning of a cycle, minus what is climbed and lost, is the
 * kinetic energy. */
TEST(ledger_closes)
{
    for (int k = 0; k < 4; k++) {
        struct asked train = train_of(0.4, k % 2 ? 2 : -1.5, k < 2 ? 0 : 0.2);
        struct domq_state at;
        train.r = 1.3;
        assert_status(ask_cycle_state(&train, 0.25, &at, NULL), DOM_OK);
        assert_near("kinetic", (double)(at.before - at.lost - at.climbed - at.friction_work),
                    (double)at.kinetic, 1e-11);
        assert_true(k < 2 ? at.friction_work == 0 : at.friction_work > 0);
    }
}

/* Checks that a tiny slope changes no bit. */
TEST(level_is_the_limit)
{
    static const double mu[] = {0, 0.2};
    for (int k = 0; k < 2; k++)
        for (double s = 0.15; s < 0.8; s += 0.15) {
            struct asked level = train_of(s, 0, mu[k]), slight = level;
            slight.alpha = 1e-300;
            struct domq_limit a = {.r_max = 0}, b = {.r_max = 0};
            struct domq_floor at_a = {0}, at_b = {0};
            domq_real of_a = 0, of_b = 0;
            level.r = slight.r = 1.1;
            assert_status(ask_limit_rmax(&level, &a, NULL), DOM_OK);
            assert_status(ask_limit_rmax(&slight, &b, NULL), DOM_OK);
            assert_true(a.r_max == b.r_max && a.ends == b.ends);
            assert_int_equal(ask_cycle_duration(&level, &of_a, NULL),
                             ask_cycle_duration(&slight, &of_b, NULL));
            assert_true(of_a == of_b);
            assert_int_equal(ask_cycle_floor(&level, &at_a), ask_cycle_floor(&slight, &at_b));
            assert_true(at_a.motion == at_b.motion && at_a.hit == at_b.hit);
        }
}

static bool floor_seen(const struct domq_fall *fall, void *context)
{
    if (fall->domino == 1)
        *(double *)context = (double)fall->floor_motion;
    return true;
}

/* Checks the floor under a domino that tips over, until it hits the next, by Newton's law for its centre. */
TEST(floor_under_the_first)
{
    for (double degrees = -4; degrees <= 4; degrees += 2) {
        const double alpha = degrees * degree, d = 0.15, inertia = (1 + d * d) / 3, tips = atan(d) - alpha;
        double most = 0, got = 0;
        enum { SAMPLES = 200000 };
        for (int k = 0; k <= SAMPLES; k++) {
            double t = tips + (asin(0.5) - tips) * k / SAMPLES, x = sin(t), y = cos(t), u = t + alpha;
            double turns = (sin(u) - d * cos(u)) / 2 / inertia;
            double omegasq = (sqrt(1 + d * d) - cos(u) - d * sin(u)) / inertia;
            double along = (turns * (y + d * x) - omegasq * (x - d * y)) / 2 - sin(alpha),
                   up = (turns * (d * y - x) - omegasq * (y + d * x)) / 2 + cos(alpha);
            most = fmax(most, fabs(along) / up);
        }
        struct domq_domino two[] = {{1, d, 0, 1, 0, 0}, {1, d, 0.5, 1, 0, 0}};
        struct asked_row row = {.domino = two,
                                .count = 2,
                                .g = 1,
                                .push = DOM_NAN,
                                .alpha = alpha,
                                .floor = true,
                                .tol = asked_default().tol,
                                .precision = DOM_DOUBLE};
        struct domq_verdict verdict;
        assert_status(ask_row_run(&row, true, floor_seen, &got, &verdict), DOM_OK);
        assert_near("floor", got, most, 2e-6);
    }
}

/* Checks that a domino tips alpha earlier, and that a slope on which none is stable is an error. */
TEST(slopes_that_do_not_hold)
{
    struct asked train = train_of(0.4, 0, 0);
    struct domq_angles angles;
    double edge = atan(7.0 / 48);
    for (int side = -1; side <= 1; side += 2) {
        train.alpha = side * edge * (1 + 1e-12);
        assert_status(ask_train_check(&train), DOM_NO_STAND);
        train.alpha = side * edge * (1 - 1e-12);
        assert_status(ask_angles_find(&train, &angles, NULL), DOM_OK);
        assert_near("theta_u", (double)angles.theta_u, edge - (double)train.alpha, 1e-3);
    }
    train.alpha = 2;
    assert_status(ask_train_check(&train), DOM_BAD_ALPHA);
    train.alpha = 0.01;
    train.method = DOM_METHOD_GSL;
    struct domq_limit limit;
    assert_status(ask_limit_rmax(&train, &limit, NULL), DOM_NO_METHOD);
    train.method = DOM_METHOD_OURS;
    train.fuel = DOM_FUEL_PAPER;
    assert_status(ask_limit_rmax(&train, &limit, NULL), DOM_NO_METHOD);
    assert_status(ask_limit_pair(&train, &limit, NULL), DOM_OK);
    struct domq_launch launch;
    assert_status(ask_launch_find(&train, &launch, NULL), DOM_NO_METHOD);
}
