/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Trains with friction between dominoes. */
#include "support.h"

static struct setup friction_train(double s, double r, double mu)
{
    struct setup train = setup_default();
    train.s = s;
    train.r = r;
    train.mu = mu;
    return train;
}

/* Returns a random train with friction and r s <= 1, which may keep falling or stop. */
static struct setup random_friction_train(uint64_t *seed, double s_least, double mu_most)
{
    double s = random_log(seed, s_least, 1);
    struct setup train = friction_train(s, 1 + (fmin(3, 1 / s) - 1) * random_unit(seed), 0);
    train.d = random_log(seed, 0.01, 0.5);
    train.q = 1 + 4 * random_unit(seed);
    train.mu = random_log(seed, 1e-6, mu_most);
    return train;
}

/* ---- Digits ---- */

/*
 * Compares with tests/reference/friction.csv, which was computed as follows. (A/2) w' + B w = C is solved in
 * 32-digit arithmetic (mpmath). A, B and C are summed domino by domino to 1e-30, with angles and
 * trigonometric functions. The equation is integrated for W and G together by Gauss collocation with 10
 * stages (order 20), piece by piece between the tilts at which a follower detaches, in 90 steps for the
 * points and in 7 for r_max. The duration comes from the same nodes. r_max is the zero, found by the secant
 * method to 1e-20, of the smallest w of the repeating cycle, which is at a zero of C or at theta_c. With 60
 * and 4 steps no number changed by more than 3e-15, and most changed by less than 1e-19. At tol = 1e-13, the
 * flow is right to tol / 8 and each sum has about 64 rounding errors, so the points are compared to 1e-12. At
 * r_max the margin changes its sign with a slope of the order of the kinetic energy, so that 1e-11 leaves a
 * factor of ten.
 */
TEST(digits)
{
    int rows = 0;
    struct csv *csv = csv_open("tests/reference/friction.csv");
    for (; csv_next(csv); rows++) {
        struct setup train = csv_train(csv);
        struct domq_limit limit;
        struct domq_launch launch;
        domq_real w, duration;
        train.d = csv_number(csv, "d");
        train.mu = csv_number(csv, "mu");
        train.tol = 1e-13;
        assert_status(ask_limit_rmax(&train, &limit), DOM_OK);
        assert_int_equal(limit.ends, DOM_END_BARRIER);
        assert_near("r_max", limit.r_max, csv_number(csv, "r_max"), 1e-11);
        train.r = csv_number(csv, "r");
        assert_status(ask_launch_find(&train, &launch), DOM_OK);
        assert_near("omegasq_0", launch.omegasq, csv_number(csv, "omegasq_0"), 1e-12);
        assert_status(ask_cycle_omegasq(&train, csv_number(csv, "theta_1"), &w), DOM_OK);
        assert_near("omegasq_1", w, csv_number(csv, "omegasq_1"), 1e-11);
        assert_status(ask_cycle_omegasq(&train, csv_number(csv, "theta_2"), &w), DOM_OK);
        assert_near("omegasq_2", w, csv_number(csv, "omegasq_2"), 1e-11);
        assert_status(ask_cycle_duration(&train, &duration), DOM_OK);
        assert_near("duration", duration, csv_number(csv, "duration"), 1e-11);
    }
    assert_int_equal(rows, 26);
}

/* ---- Tolerance ---- */

/* Checks float near 1 - r s = 0.01, where rounding leaves few correct digits of the sums. The scan for r_max
 * meets this case. */
TEST(float_near_the_reach)
{
    struct setup train = friction_train((double)0.54788214F, 1, (double)0.0312876888F);
    struct domq_limit limit;
    struct domq_launch launch;
    train.d = 0.0992909595F;
    train.q = 3.49999905F;
    train.precision = IN_FLOAT;
    train.tol = any_arithmetic(IN_FLOAT).tol_default;
    for (int k = 0; k <= 40; k++) {
        train.r = (1 - pow(10, -1 - k / 20.0)) / (double)train.s;
        assert_status(ask_launch_find(&train, &launch), DOM_OK);
    }
    assert_status(ask_limit_rmax(&train, &limit), DOM_OK);
}

/* Checks that a search that fails is an error: this train releases no energy near the reach, where float
 * cannot compute its motion to the tolerance. */
TEST(a_root_that_is_not_found_is_no_reach)
{
    struct setup train = friction_train((double)0.0014900344F, 1, (double)0.167359814F);
    struct domq_limit limit, in_float;
    train.d = (double)0.000413613336F;
    train.q = (double)0.300378799F;
    assert_status(ask_limit_rmax(&train, &limit), DOM_OK);
    assert_int_equal(limit.ends, DOM_END_BARRIER);
    train.precision = IN_FLOAT;
    train.tol = any_arithmetic(IN_FLOAT).tol_default;
    const enum dom_status status = ask_limit_rmax(&train, &in_float);
    if (status == DOM_OK)
        assert_near("r_max", in_float.r_max, limit.r_max, 1e-4);
    else
        assert_status(status, DOM_NOT_CONVERGED);
}

/* Checks that errors are within ten times the tolerance, since the launch and the margin amplify errors of
 * the flow. */
TEST(tolerance_is_kept)
{
    static const double tols[] = {1e-3, 1e-5, 1e-7, 1e-9};
    uint64_t seed = 54;
    int checked = 0;
    for (int i = 0; i < 150; i++) {
        struct setup train = random_friction_train(&seed, 0.02, 2);
        struct domq_launch exact, rough;
        if (ask_launch_find(&train, &exact) != DOM_OK)
            continue;
        for (int k = 0; k < 4; k++) {
            train.tol = tols[k];
            assert_status(ask_launch_find(&train, &rough), DOM_OK);
            /* An error of G is weighted with the part of a cycle's energy that carries over to the next
             * cycle. */
            double errs = fabs((double)(rough.kinetic / exact.kinetic) - 1);
            if (!(errs <= 10 * tols[k] * (double)train.r))
                fail_train("kinetic at a tolerance", &train, rough.kinetic, exact.kinetic);
            checked++;
        }
    }
    assert_true(checked > 100);
}

/* ---- Verdicts ---- */

TEST(refusals)
{
    struct setup train = friction_train(0.4, 1.3, 0.1);
    struct domq_launch launch;
    struct domq_barrier barrier;
    struct domq_limit limit;
    train.fuel = DOM_FUEL_PAPER;
    assert_status(ask_launch_find(&train, &launch), DOM_NO_METHOD);
    assert_status(ask_barrier_find(&train, &barrier), DOM_NO_METHOD);
    assert_status(ask_limit_rmax(&train, &limit), DOM_NO_METHOD);
    train.fuel = DOM_FUEL_EXACT;
    /* The train locks in the hit. The sums for the motion after the hit, which would be infinite, must not
     * hide this. */
    train = friction_train(0.10240983347041695, 2.2984965160834889, 11.465967489938446);
    train.d = 0.61451534241036898;
    train.q = 2.9636499594514638;
    assert_status(ask_launch_find(&train, &launch), DOM_LOCKS);
    /* The arm of the contact force is Y / r, and the arm of the friction is mu d. The train locks if these
     * are equal. */
    train = friction_train(0.5, 1, 1);
    train.d = 0.1;
    double edge = sqrt(1 / (0.01 + 0.25)); /* sqrt(1 - r^2 s^2) / r = mu d */
    train.r = edge * (1 - 1e-6);
    assert_status(ask_launch_find(&train, &launch), DOM_OK);
    assert_true(launch.velocity_ratio > 0 && launch.velocity_ratio < 1e-4);
    assert_status(ask_barrier_find(&train, &barrier), DOM_STOPS);
    train.r = edge * (1 + 1e-6);
    assert_status(ask_launch_find(&train, &launch), DOM_LOCKS);
    assert_status(ask_barrier_find(&train, &barrier), DOM_LOCKS);
    /* If equal dominoes lock, there is no largest growth. */
    train = friction_train(0.25, 1, 100);
    train.d = 0.0167772;
    assert_status(ask_limit_rmax(&train, &limit), DOM_OK);
    assert_true(limit.ends == DOM_END_NONE && isnan((double)limit.r_max));
    assert_status(limit.why, DOM_LOCKS);
}

/* Checks that r_max decreases with mu and is never the reach, and that trains keep falling 1e-6 below r_max
 * and stop 1e-6 above it. */
TEST(growth_falls_with_friction)
{
    uint64_t seed = 57;
    int met = 0, none = 0;
    for (int i = 0; i < 60; i++) {
        struct setup train = random_friction_train(&seed, 0.02, 3);
        double before = INFINITY, mu = train.mu;
        for (int k = 0; k < 3; k++) {
            struct domq_limit limit;
            struct domq_barrier barrier;
            train.mu = mu * (k == 0 ? 1 : k == 1 ? 1.01 : 2);
            assert_status(ask_limit_rmax(&train, &limit), DOM_OK);
            assert_true(limit.ends == DOM_END_NONE || limit.ends == DOM_END_BARRIER);
            double r_max = limit.ends == DOM_END_NONE ? 0 : (double)limit.r_max;
            if (!(r_max < before || (r_max == 0 && before == 0)))
                fail_train("growth with more friction", &train, r_max, before);
            before = r_max;
            none += limit.ends == DOM_END_NONE;
            if (r_max == 0 || r_max * (1 - 1e-6) < 1)
                continue;
            train.r = r_max * (1 - 1e-6);
            assert_status(ask_barrier_find(&train, &barrier), DOM_OK);
            train.r = fmin(r_max * (1 + 1e-6), 1 / (double)train.s);
            enum dom_status above = ask_barrier_find(&train, &barrier);
            assert_true(above == DOM_STOPS || above == DOM_LOCKS);
            met++;
        }
    }
    assert_true(met > 60 && none > 5);
}
