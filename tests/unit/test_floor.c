/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The friction that the floor needs under a domino that falls alone, whose motion is known in closed form. It
 * is compared with values on a fine grid, on level floors and on slopes. */
#include "support.h"

enum { GRID = 4000 };

static const double g = 9.81;

/* A block that falls alone, turning about its foot, on a floor with this slope. It starts upright, with the
 * angular velocity `push`. */
struct block {
    double h, d, slope, push;
};

/* Returns twice the height of the centre of a block above its foot, at a tilt. */
static double centre(const struct block *b, double theta)
{
    return b->h * cos(theta + b->slope) + b->d * sin(theta + b->slope);
}

/* Returns the friction |R_x| / R_z that the floor needs at a tilt, or infinity if the block is lifted. */
static double needed(const struct block *b, double theta)
{
    /* moment of inertia divided by the mass */
    double x = sin(theta), y = cos(theta), inertia = (b->h * b->h + b->d * b->d) / 3;
    double across = (b->h * x - b->d * y) / 2, up = (b->h * y + b->d * x) / 2;
    double omegasq = b->push * b->push + g * (centre(b, 0) - centre(b, theta)) / inertia;
    double alpha = g * (across * cos(b->slope) + up * sin(b->slope)) / inertia;
    double force_x = up * alpha - across * omegasq - g * sin(b->slope),
           force_z = g * cos(b->slope) - across * alpha - up * omegasq;
    return force_z > 0 ? fabs(force_x) / force_z : (double)INFINITY;
}

/* Returns the largest value up to a tilt. Between grid points, maxima are found by a parabola through three
 * values. */
static double most_needed(const struct block *b, double end, int *tops)
{
    double most = 0, before[2] = {0, 0};
    *tops = 0;
    for (int i = 0; i <= GRID; i++) {
        double at = needed(b, end * i / GRID), bend = before[0] - 2 * before[1] + at,
               slope = (at - before[0]) / 2;
        if (i > 1 && before[1] > before[0] && before[1] >= at) {
            most = fmax(most, before[1] - slope * slope / (2 * bend));
            ++*tops;
        }
        most = fmax(most, at);
        before[0] = before[1];
        before[1] = at;
    }
    return most;
}

static bool fall_seen(const struct domq_fall *fall, void *context)
{
    *(struct domq_fall *)context = *fall;
    return false;
}

/*
 * Checks the first of two dominoes. Rows in which it comes to rest before it hits the second are left out. A
 * smooth maximum must be right to a millionth.
 */
TEST(two_tops)
{
    uint64_t seed = 101;
    int checked = 0, several = 0;
    for (int i = 0; i < 6000; i++) {
        double h = 0.05, d = h * random_log(&seed, 0.02, 0.9), gap = h * (0.02 + 0.97 * random_unit(&seed));
        struct block b = {h, d, i % 5 ? 0 : 0.9 * atan(d / (2 * h)) * (2 * random_unit(&seed) - 1), 0};
        double edge = sqrt(3 * g * (hypot(h, d) - centre(&b, 0)) / (h * h + d * d));
        b.push = edge * (i % 3 ? random_log(&seed, 1.0001, 1.1) : random_log(&seed, 1.1, 5));
        struct domq_domino domino[] = {{h, d, 0, 1, 0, 0, 0}, {2 * h, d, gap, 1, 0, 0, 0}};
        struct row_setup row = row_setup_default(domino, 2, b.push);
        struct domq_fall fall;
        struct domq_verdict verdict;
        int tops;
        row.floor = true;
        row.alpha = b.slope;
        if (i % 4 == 0) {
            row.precision = i % 40 == 0 ? IN_QUAD : IN_FLOAT;
            row.tol = i % 40 == 0 ? 1e-12 : 1e-5;
        }
        assert_status(ask_row_run(&row, false, fall_seen, &fall, &verdict), DOM_OK);
        if (fall.margin < 0)
            continue;
        double most = most_needed(&b, asin(gap / h), &tops), bound = row.precision == IN_FLOAT ? 1e-3 : 2e-6;
        if (isinf(most) || most > 1e3) { /* if the domino is nearly lifted, few digits are right */
            assert_true(fall.floor_motion > 500);
            continue;
        }
        if (!(fabs((double)fall.floor_motion - most) <= bound * most * (1 + most)))
            fail_msg("d/h %g, gap/h %g, push %g, slope %g: %.10g, on a grid %.10g (%d tops)", d / h, gap / h,
                     b.push, b.slope, (double)fall.floor_motion, most, tops);
        checked++;
        several += tops > 1;
    }
    print_message("# %d heads, %d with several tops\n", checked, several);
    assert_true(checked > 2500);
}
