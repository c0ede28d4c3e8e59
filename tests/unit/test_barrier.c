/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The barrier is the global maximum. This is checked by brute force, and in cases that are difficult for a
 * simpler search. */
#include "request.h"
#include "support.h"
#include <float.h>

/* Returns the highest energy at many tilts, which are dense near both ends of [0, theta_c] and near the tilt
 * at which a domino detaches. */
static double brute_force(const struct geometry *geometry, double theta_c)
{
    double highest = 0;
    bool leaves;
    struct tilt leave;
    assert_status(chain_leave(geometry, &leaves, &leave, NULL), DOM_OK);
    double edge[3] = {0, leaves ? tilt_angle(leave) : theta_c / 2, theta_c};
    for (int piece = 0; piece < 2; piece++) {
        for (int k = 0; k <= 300; k++) {
            double u = 0.5 - 0.5 * cos(k * acos(-1.0) / 300),
                   theta = edge[piece] + u * (edge[piece + 1] - edge[piece]);
            struct tilt head;
            struct sums sums;
            assert_status(geometry_tilt(geometry, fmin(theta, theta_c), &head), DOM_OK);
            assert_status(geometry->law->change(geometry, head, PASS_PLAIN, &sums, NULL), DOM_OK);
            highest = fmax(highest, sums.dH);
        }
    }
    return highest;
}

/*
 * Returns how much the difference between the height of a barrier and H at its tilt exceeds what is allowed.
 * H at the tilt must not be higher, and at most H'' step^2 / 2 lower, where step is the possible distance of
 * the tilt from the top (TOP_TOL). Allowed are also the rounding errors that the sum reports, a few rounding
 * errors of the height, and those of the tilt if this is at an end of [0, theta_c] where H has a slope.
 */
static double height_off(const struct geometry *geometry, double theta_c, const struct barrier *barrier)
{
    struct tilt top;
    struct sums at, error, bend;
    assert_status(geometry_tilt(geometry, fmin(barrier->theta_m, theta_c), &top), DOM_OK);
    assert_status(geometry->law->change(geometry, top, PASS_PLAIN, &at, &error), DOM_OK);
    assert_status(chain_second_derivative(geometry, (struct tilt){0, 1, 0}, top, &bend), DOM_OK);
    double step = TOP_TOL(geometry) * barrier->theta_m, noise = error.dH + 8 * DBL_EPSILON * fabs(at.dH),
           edge = 4 * DBL_EPSILON * fabs(bend.H1) * barrier->theta_m,
           bend_down = fmax(-bend.H2, 0) * step * step / 2, off = barrier->height - at.dH;
    if (off >= 0)
        return off == 0 ? 0 : off / (bend_down + noise + edge);
    return off / (noise + edge);
}

TEST(no_tilt_is_higher)
{
    uint64_t seed = 11;
    double highest = 0, lowest = 0;
    int hills = 0;
    for (int i = 0; i < 500; i++) {
        struct asked train = random_train(&seed);
        struct geometry geometry;
        struct barrier barrier;
        const struct request request = request_of(&train);
        assert_status(dynamics_make(&request, &geometry), DOM_OK);
        double theta_c = tilt_angle(geometry.c), brute = brute_force(&geometry, theta_c);
        assert_status(barrier_search(&geometry, theta_c, TOP_TOL(&geometry), &barrier), DOM_OK);
        if (!(barrier.height >= brute * (1 - 1e-13)))
            fail_msg("s %.17g r %.17g d %.17g q %.17g: barrier %.17g, but %.17g is there", (double)train.s,
                     (double)train.r, (double)train.d, (double)train.q, barrier.height, brute);
        double off = height_off(&geometry, theta_c, &barrier);
        if (!(off >= -1 && off <= 1))
            fail_msg(
                "s %.17g r %.17g d %.17g q %.17g: barrier %.17g is not the height at %.17g: %g times what "
                "may be",
                (double)train.s, (double)train.r, (double)train.d, (double)train.q, barrier.height,
                barrier.theta_m, off);
        highest = fmax(highest, off);
        lowest = fmin(lowest, off);
        hills += barrier.height > 0;
    }
    print_message("# %d barriers, between %.2g and %.2g of what they may be off\n", hills, lowest, highest);
    assert_true(hills > 300);
}

/* Checks a barrier after a valley: H first decreases and then increases, so the paper's search stops at 0. */
TEST(barrier_after_a_valley)
{
    struct asked train = asked_default();
    struct domq_barrier barrier;
    struct domq_energy energy;
    train.s = 0.54;
    train.q = 3;
    train.r = 1.8318;
    assert_status(ask_barrier_find(&train, &barrier, NULL), DOM_OK);
    assert_true(barrier.barrier == 0 && barrier.theta_m == 0);
    train.r = 1 / train.s;
    assert_status(ask_barrier_find(&train, &barrier, NULL), DOM_OK);
    assert_near("barrier", barrier.barrier, 0.0106, 0.5e-4 / 0.0106);
    assert_true(barrier.theta_m > 0);
    train.r = 1.85;
    assert_status(ask_barrier_find(&train, &barrier, NULL), DOM_OK);
    assert_status(ask_energy_find(&train, 0.003, &energy, NULL), DOM_OK);
    assert_true(energy.dH < 0 && barrier.barrier > 0.006 && barrier.theta_m > 0.14);
}

/* Checks trains of small separation with the paper's fuel, where H increases up to the collision. */
TEST(barrier_at_the_end)
{
    struct asked train = asked_default();
    struct domq_barrier barrier;
    struct domq_angles angles;
    train.s = 1e-4;
    train.r = 1.5;
    train.q = 3;
    train.fuel = DOM_FUEL_PAPER;
    assert_status(ask_barrier_find(&train, &barrier, NULL), DOM_NO_FUEL);
    assert_status(ask_angles_find(&train, &angles, NULL), DOM_OK);
    assert_near("theta_m", barrier.theta_m, angles.theta_c, 1e-15);
}

/* Checks a thin domino at the reach, which climbs alone: hypot(1, d) - 1, which is 5e-17 for d = 1e-8. */
TEST(barrier_of_one_domino)
{
    for (double d = 1e-8; d < 1; d *= 10) {
        struct asked train = asked_default();
        struct domq_barrier barrier;
        train.s = 0.5;
        train.r = 2;
        train.d = d;
        train.tol = 1e-15;
        enum dom_status status = ask_barrier_find(&train, &barrier, NULL);
        assert_status(status, barrier.margin >= 0 ? DOM_OK : DOM_STOPS);
        assert_near("barrier", barrier.barrier, d * d / (1 + hypot(1, d)), 1e-15);
        assert_near("theta_m", barrier.theta_m, atan(d), 1e-14);
    }
}
