/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Properties of all trains that do not depend on digits: identities, limits, monotony and continuity. */
#include "request.h"
#include "support.h"
#include <float.h>

enum { TRAINS = 400 };

/* Checks J(0) = 1 + r^-(q+1) J(theta_c) (50; d8), and that the train at 0 is the train at theta_c, shifted by
 * one domino. */
TEST(inertia_shifts_by_one)
{
    uint64_t seed = 1;
    for (int i = 0; i < TRAINS; i++) {
        struct asked train = random_train(&seed);
        struct geometry geometry;
        struct sums at_0, at_c;
        const struct request request = request_of(&train);
        assert_status(dynamics_make(&request, &geometry), DOM_OK);
        assert_status(geometry.law->sum(&geometry, (struct tilt){0, 1, 0}, &at_0), DOM_OK);
        assert_status(geometry.law->sum(&geometry, geometry.c, &at_c), DOM_OK);
        assert_near("J(0)", at_0.J, 1 + geometry.inertia * at_c.J, 1e-13);
    }
}

/*
 * Checks that the sum that the barrier search uses is dH/dtheta. The difference quotient of dH has an error
 * of h^2 |H'''| / 6, plus rounding errors of 1e-16 / h. H''' is large where a follower is about to detach.
 */
TEST(slope_is_derivative_of_energy)
{
    uint64_t seed = 2;
    int checked = 0;
    for (int i = 0; i < TRAINS; i++) {
        struct asked train = random_train(&seed);
        struct geometry geometry;
        struct sums left, here, right;
        const struct request request = request_of(&train);
        assert_status(dynamics_make(&request, &geometry), DOM_OK);
        double theta_c = tilt_angle(geometry.c), theta = theta_c * (0.1 + 0.8 * random_unit(&seed)),
               h = 1e-5 * theta;
        if (geometry.detaches && fabs(theta - tilt_angle(geometry.leave)) < 0.05 * theta_c)
            continue;
        geometry.law->change(&geometry, tilt_make(sin(theta - h), cos(theta - h)), PASS_PLAIN, &left, NULL);
        geometry.law->change(&geometry, tilt_make(sin(theta), cos(theta)), PASS_PLAIN, &here, NULL);
        geometry.law->change(&geometry, tilt_make(sin(theta + h), cos(theta + h)), PASS_PLAIN, &right, NULL);
        double scale = fabs(here.H1) + train.d + sin(theta);
        if (!(fabs((right.dH - left.dH) / (2 * h) - here.H1) <= 1e-5 * scale))
            fail_msg("s %.17g r %.17g d %.17g q %.17g theta %.17g: %g, not %g", (double)train.s,
                     (double)train.r, (double)train.d, (double)train.q, theta, (right.dH - left.dH) / (2 * h),
                     here.H1);
        checked++;
    }
    assert_true(checked > TRAINS / 2);
}

/*
 * Checks that the sum of differences agrees with the difference of two sums of h, up to the rounding errors
 * of these sums, which are 1e-14 of the sum of weights.
 */
TEST(energy_agrees_with_its_definition)
{
    uint64_t seed = 3;
    for (int i = 0; i < TRAINS; i++) {
        struct asked train = random_train(&seed);
        struct geometry geometry;
        struct sums sums;
        const struct request request = request_of(&train);
        assert_status(dynamics_make(&request, &geometry), DOM_OK);
        double theta = random_unit(&seed) * tilt_angle(geometry.c), H[2] = {0, 0}, size = 0;
        struct tilt head = tilt_make(sin(theta), cos(theta));
        assert_status(geometry.law->change(&geometry, head, PASS_PLAIN, &sums, NULL), DOM_OK);
        for (int k = 0; k < 2; k++) {
            struct link link = link_head(&geometry, k ? head : (struct tilt){0, 1, 0});
            for (size_t n = 0; n < 4000; n++) {
                struct tilt t = link.tilt;
                H[k] += link.weight * (t.y + geometry.d * t.x);
                size += link.weight;
                if (!link.leads) {
                    /* Dominoes that have already detached have the tilt theta_f in both sums. Add them until
                     * their weight is 0. */
                    for (double w = link.weight * geometry.weight; n < 4000; n++, w *= geometry.weight) {
                        H[k] += w * (geometry.f.y + geometry.d * geometry.f.x);
                        size += w;
                    }
                    break;
                }
                link_next(&link);
            }
        }
        /* The terms after 4000 dominoes are below the rounding errors, since s >= 3e-3. */
        if (!(fabs(H[1] - H[0] - sums.dH) <= 4e-15 * size * (1 + geometry.d)))
            fail_msg("s %.17g r %.17g d %.17g q %.17g theta %.17g: dH %.17g, by definition %.17g",
                     (double)train.s, (double)train.r, (double)train.d, (double)train.q, theta, sums.dH,
                     H[1] - H[0]);
    }
}

/* Checks that at the reach every follower detaches at once, at pi/2. s is a power of 2, so that r s is
 * exactly 1. */
TEST(fuels_agree_at_the_reach)
{
    uint64_t seed = 4;
    for (int i = 0; i < TRAINS; i++) {
        struct asked train = random_train(&seed);
        struct domq_fuels fuels;
        train.s = ldexp(1, -i % 8);
        train.r = 1 / train.s;
        assert_status(ask_fuel_find(&train, &fuels, NULL), DOM_OK);
        assert_near("fuel at reach", fuels.exact, 1 - train.d, 1e-15 / fabs((double)(1 - train.d)));
        assert_near("paper fuel at reach", fuels.paper, 1 - train.d, 1e-15 / fabs((double)(1 - train.d)));
    }
}

/* Checks that energy is conserved during a cycle, J w + dH = K (21; c3), and that the speed at the end of a
 * cycle gives the speed at the beginning of the next one. */
TEST(cycle_closes)
{
    uint64_t seed = 5;
    int closed = 0;
    for (int i = 0; i < TRAINS; i++) {
        struct asked train = random_train(&seed);
        struct domq_launch launch;
        struct domq_energy energy;
        struct domq_angles angles;
        domq_real w = DOMQ_NAN;
        if (ask_launch_find(&train, &launch, NULL) != DOM_OK)
            continue;
        assert_status(ask_angles_find(&train, &angles, NULL), DOM_OK);
        double theta = random_unit(&seed) * angles.theta_c;
        assert_status(ask_energy_find(&train, theta, &energy, NULL), DOM_OK);
        if (ask_cycle_omegasq(&train, theta, &w, NULL) == DOM_OK)
            assert_near("J w + dH", energy.J * w + energy.dH, launch.kinetic,
                        1e-13 * (1 + fabs((double)(energy.dH / launch.kinetic))));
        if (ask_cycle_omegasq(&train, angles.theta_c, &w, NULL) != DOM_OK)
            continue;
        /* (22; c4) and (23; c5): J(0) omega(0) = (J(0) - 1) sqrt(r) omega(theta_c). */
        double T = pow(train.r, -(train.q + 1)), J_c = 0;
        assert_status(ask_energy_find(&train, angles.theta_c, &energy, NULL), DOM_OK);
        J_c = energy.J;
        T *= J_c;
        assert_near("collision", T * sqrt(train.r * w), launch.J0 * sqrt(launch.omegasq), 1e-11);
        assert_near("keeps", launch.velocity_ratio * sqrt(train.r * w), sqrt(launch.omegasq), 1e-11);
        closed++;
    }
    assert_true(closed > TRAINS / 4);
}

/* Checks a train at the reach. Its follower detaches at once, but after the collision, so omega(0) is that of
 * the launch. */
TEST(cycle_begins_at_the_reach)
{
    static const double train_at[][4] = {{0.5, 2, 0.1, 3},
                                         {0.5148788313082803, 1.9422045327811441, 0.003, 4},
                                         {0.25, 4, 0.01, 0.5},
                                         {1, 1, 1e-7, 3}};
    for (size_t i = 0; i < 4; i++) {
        struct asked train = asked_default();
        struct domq_launch launch;
        domq_real w = DOMQ_NAN;
        train.s = train_at[i][0];
        train.r = train_at[i][1];
        train.d = train_at[i][2];
        train.q = train_at[i][3];
        assert_status(ask_launch_find(&train, &launch, NULL), DOM_OK);
        assert_status(ask_cycle_omegasq(&train, 0, &w, NULL), DOM_OK);
        assert_near("omegasq(0)", w, launch.omegasq, 1e-15);
    }
}

/* Checks that cycles converge: starting from any speed, the collision law leads to the stationary speed. */
TEST(train_forgets_its_push)
{
    struct asked train = asked_default();
    struct domq_launch launch;
    struct domq_angles angles;
    struct domq_energy at_c;
    assert_status(ask_launch_find(&train, &launch, NULL), DOM_OK);
    assert_status(ask_angles_find(&train, &angles, NULL), DOM_OK);
    assert_status(ask_energy_find(&train, angles.theta_c, &at_c, NULL), DOM_OK);
    double w = 100 * launch.omegasq;
    for (int cycle = 0; cycle < 40; cycle++) {
        double w_c = (launch.J0 * w - at_c.dH) / at_c.J;
        w = train.r * w_c * pow((launch.J0 - 1) / launch.J0, 2);
    }
    assert_near("stationary omega0sq", w, launch.omegasq, 1e-13);
}

/* Checks that the margin is 0 at r_max, positive just below and negative just above. */
TEST(margin_vanishes_at_the_limit)
{
    uint64_t seed = 6;
    int met = 0;
    for (int i = 0; i < 60; i++) {
        struct asked train = random_train(&seed);
        struct domq_limit limit;
        struct domq_barrier barrier;
        assert_status(ask_limit_rmax(&train, &limit, NULL), DOM_OK);
        if (limit.ends != DOM_END_BARRIER)
            continue;
        train.r = fmax(limit.r_max * (1 - 1e-9), 1);
        assert_status(ask_barrier_find(&train, &barrier, NULL), DOM_OK);
        train.r = fmin(limit.r_max * (1 + 1e-9), 1 / train.s);
        assert_status(ask_barrier_find(&train, &barrier, NULL), DOM_STOPS);
        met++;
    }
    assert_true(met > 10);
}

/* Checks that the remaining energy has the relative tolerance tol, even if it is a small difference of large
 * energies. */
TEST(small_margins_keep_their_digits)
{
    for (int i = 0; i < 12; i++) {
        struct asked train = asked_default();
        struct domq_limit limit;
        struct domq_barrier rough, fine;
        train.s = 0.1 + 0.1 * (i % 4);
        train.q = 3 + 0.5 * (i % 3);
        assert_status(ask_limit_rmax(&train, &limit, NULL), DOM_OK);
        train.r = limit.r_max * (1 - (domq_real)1e-8);
        train.tol = 1e-14;
        assert_status(ask_barrier_find(&train, &fine, NULL), DOM_OK);
        train.tol = 1e-3;
        assert_status(ask_barrier_find(&train, &rough, NULL), DOM_OK);
        assert_near("margin", rough.margin, fine.margin, 1e-3);
    }
}

/* Checks (5; b0): a domino that has not tipped over its edge when it hits the next one does not push it. */
TEST(pairs_tip_over_before_they_hit)
{
    uint64_t seed = 8;
    int ends[3] = {0};
    for (int i = 0; i < 2 * TRAINS; i++) {
        struct asked train = random_train(&seed);
        struct domq_limit limit;
        assert_status(ask_limit_pair(&train, &limit, NULL), DOM_OK);
        if (limit.ends != DOM_END_NONE)
            assert_true((double)(limit.r_max * train.s) * hypot(1, (double)train.d) > (double)train.d);
        ends[limit.ends]++;
    }
    assert_true(ends[DOM_END_NONE] > TRAINS / 10 && ends[DOM_END_BARRIER] > TRAINS / 10);
}

/* Checks narrow bands of r in which a pair succeeds, which begin at (5; b0). A scan of r must not step over a
 * band. */
TEST(pairs_succeed_in_narrow_bands)
{
    static const double band[][4] = {
        /* s, d, q, and the end of the band */
        {0.41043361309668785, 0.32266631706171017, 1.6758005526800597, 1.6906981},
        {0.20984676777913347, 0.14262314360317227, 2.344918696588473, 1.2175004},
        {0.01161971101033242, 0.00780759682969328, 1.9981531957259211, 1.5718772}};
    for (size_t i = 0; i < sizeof band / sizeof *band; i++) {
        struct asked train = asked_default();
        struct domq_limit limit;
        train.s = band[i][0];
        train.d = band[i][1];
        train.q = band[i][2];
        assert_status(ask_limit_pair(&train, &limit, NULL), DOM_OK);
        assert_int_equal(limit.ends, DOM_END_BARRIER);
        assert_near("r_max of the pair", limit.r_max, band[i][3], 1e-4);
    }
}

/* Checks that solid dominoes can grow less than hollow ones, and that r_max increases towards the best
 * separation. */
TEST(growth_is_monotone)
{
    double before = 1;
    for (double s = 0.02; s < 0.44; s += 0.01) {
        struct asked train = asked_default();
        struct domq_limit hollow, massive;
        train.s = s;
        assert_status(ask_limit_rmax(&train, &massive, NULL), DOM_OK);
        train.q = 3;
        assert_status(ask_limit_rmax(&train, &hollow, NULL), DOM_OK);
        assert_true(hollow.r_max > before && hollow.r_max > massive.r_max);
        before = hollow.r_max;
    }
}

/* Checks that there is no domino effect for s <= 2 d^3 / (1 - d^2): 0.0063378 for the standard domino. */
TEST(no_fuel_below_a_separation)
{
    struct asked train = asked_default();
    struct domq_limit limit;
    double edge = 2 * pow(train.d, 3) / (1 - train.d * train.d);
    assert_near("edge", edge, 0.0063378, 1e-5);
    train.s = edge * (1 - 1e-9);
    assert_status(ask_limit_rmax(&train, &limit, NULL), DOM_OK);
    assert_int_equal(limit.ends, DOM_END_NONE);
    assert_true(isnan(limit.r_max));
    assert_status(limit.why, DOM_NO_FUEL);
    train.s = edge * (1 + 1e-3);
    struct domq_fuels fuels;
    train.r = 1;
    assert_status(ask_fuel_find(&train, &fuels, NULL), DOM_OK);
    assert_true(fuels.exact > 0 && fuels.paper > 0);
}

/* Checks that fewer dominoes are needed for a larger tol, and that the error is below tol. */
TEST(tolerance_decides_the_work)
{
    uint64_t seed = 7;
    static const double tols[] = {1e-2, 1e-4, 1e-6, 1e-9};
    size_t total[4] = {0};
    for (int i = 0; i < TRAINS; i++) {
        struct asked train = random_train(&seed);
        struct geometry geometry;
        struct sums exact, sums;
        const struct request request = request_of(&train);
        assert_status(dynamics_make(&request, &geometry), DOM_OK);
        double theta = random_unit(&seed) * tilt_angle(geometry.c);
        struct tilt head = tilt_make(sin(theta), cos(theta));
        assert_status(geometry.law->change(&geometry, head, PASS_PLAIN, &exact, NULL), DOM_OK);
        for (int k = 0; k < 4; k++) {
            geometry.tol = tols[k];
            assert_status(geometry.law->change(&geometry, head, PASS_PLAIN, &sums, NULL), DOM_OK);
            assert_near("J at tol", sums.J, exact.J, tols[k]);
            assert_near("dH at tol", sums.dH, exact.dH, tols[k]);
            total[k] += sums.n;
        }
    }
    for (int k = 1; k < 4; k++)
        assert_true(total[k] > total[k - 1]);
}

/* Checks that the energy is used up at the tilt where the train stops. */
TEST(train_stops_where_its_energy_ends)
{
    struct asked train = asked_default();
    domq_real stop = DOMQ_NAN, w = DOMQ_NAN;
    struct domq_energy energy;
    struct domq_launch launch;
    train.r = 1.7;
    assert_status(ask_cycle_stop(&train, &stop, NULL), DOM_OK);
    assert_status(ask_energy_find(&train, stop, &energy, NULL), DOM_OK);
    assert_status(ask_launch_find(&train, &launch, NULL), DOM_OK);
    assert_near("dH at the stop", energy.dH, launch.kinetic, 1e-11);
    assert_status(ask_cycle_omegasq(&train, stop * 0.999, &w, NULL), DOM_OK);
    assert_true(w > 0);
    assert_status(ask_cycle_omegasq(&train, stop * 1.001, &w, NULL), DOM_STOPS);
    assert_true(isnan(w));
    train.r = 1.5;
    assert_status(ask_cycle_stop(&train, &stop, NULL), DOM_OK);
    assert_true(isnan(stop));
}

/* Checks that the duration grows like ln(1 / margin) as the margin goes to 0. */
TEST(duration_diverges_logarithmically)
{
    struct asked train = asked_default();
    struct domq_limit limit;
    domq_real duration[4];
    train.tol = 1e-13;
    assert_status(ask_limit_rmax(&train, &limit, NULL), DOM_OK);
    for (int k = 0; k < 4; k++) {
        train.r = limit.r_max * (1 - pow(10, -5 - k));
        assert_status(ask_cycle_duration(&train, &duration[k], NULL), DOM_OK);
    }
    assert_near("steps", duration[3] - duration[2], duration[2] - duration[1], 1e-3);
    assert_true(duration[1] - duration[0] > 0.5);
    train.r = limit.r_max * (1 + 1e-6);
    assert_status(ask_cycle_duration(&train, &duration[0], NULL), DOM_STOPS);
}

/* Checks that error bounds take no work unless they are requested, and do not change any digit of the
 * result. */
TEST(bounds_are_extra)
{
    uint64_t seed = 77;
    int barriers = 0, limits = 0;
    for (int i = 0; i < 60; i++) {
        struct asked train = random_train(&seed);
        struct dom_work plain = {0}, bounded = {0};
        struct domq_barrier without, with, error;
        struct domq_limit limit, limit_with, limit_error;
        train.precision = (enum dom_precision)(i % 3);
        train.tol = domq_arithmetic(train.precision)->tol_default;
        train.r = fmin(train.r, 3);
        train.work = &plain;
        enum dom_status status = ask_barrier_find(&train, &without, NULL);
        size_t passes = plain.passes;
        train.work = &bounded;
        if (ask_barrier_find(&train, &with, &error) != status)
            fail_msg("another verdict with bounds");
        if (status != DOM_OK && status != DOM_STOPS)
            continue;
        barriers++;
        assert_true(with.barrier == without.barrier && with.margin == without.margin &&
                    with.theta_m == without.theta_m);
        assert_true(error.margin > 0 && error.margin < without.kinetic + without.barrier);
        assert_true(bounded.passes >= passes);
        train.work = &plain;
        plain.passes = bounded.passes = 0;
        assert_status(ask_limit_rmax(&train, &limit, NULL), DOM_OK);
        train.work = &bounded;
        assert_status(ask_limit_rmax(&train, &limit_with, &limit_error), DOM_OK);
        assert_int_equal(limit.ends, limit_with.ends);
        if (limit.ends != DOM_END_BARRIER)
            continue;
        limits++;
        assert_true(limit.r_max == limit_with.r_max && limit_error.r_max > 0);
        assert_true(bounded.passes > plain.passes);
    }
    print_message("# %d barriers and %d limits with bounds\n", barriers, limits);
    assert_true(barriers > 30 && limits > 10);
}

/* Checks that the precisions agree to the digits of the less accurate one. */
TEST(precisions_agree)
{
    uint64_t seed = 78;
    int compared = 0;
    for (int i = 0; i < 30; i++) {
        struct asked train = random_train(&seed);
        struct domq_limit limit[3];
        /* Parameters that a float represents exactly. */
        train.s = (float)fmin(0.05 + (double)train.s, 0.9);
        train.d = (float)fmax((double)train.d, 0.01);
        train.q = (float)train.q;
        for (int p = DOM_FLOAT; p <= DOM_QUAD; p++) {
            train.precision = (enum dom_precision)p;
            train.tol = domq_arithmetic(train.precision)->tol_default;
            assert_status(ask_limit_rmax(&train, &limit[p], NULL), DOM_OK);
        }
        assert_true(limit[0].ends == limit[2].ends && limit[1].ends == limit[2].ends);
        if (limit[2].ends == DOM_END_NONE)
            continue;
        /* the margins of thin dominoes change slowly with r */
        assert_near("float", limit[0].r_max, limit[2].r_max, 1e-3);
        assert_near("double", limit[1].r_max, limit[2].r_max, 1e-10);
        compared++;
    }
    print_message("# %d limits in all precisions\n", compared);
    assert_true(compared > 15);
}
