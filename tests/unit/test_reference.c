/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Compares every quantity of the model with tables in tests/reference, which were computed with 40 digits.
 * The points have condition numbers up to about 100, for the slope just before a follower detaches ("wide")
 * and for the weights r^-qi of 6000 dominoes ("very-close"). So at tol = 1e-15 errors of 100 to 200 times
 * 2^-53 are allowed, which is 3e-14. Durations are printed with 14 digits, and are compared to 1e-13. At the
 * default tol = 1e-12 all quantities must be right to tol.
 */
#include "support.h"

/* the finest tolerance and the default one, and the errors that they allow */
static const struct bounds {
    double tol, digits, duration;
} bounds[] = {{1e-15, 3e-14, 1e-13}, {1e-12, 1e-12, 1e-12}};

static void check_geometry(const struct csv *csv, const struct setup *train, double bound)
{
    struct domq_angles angles;
    struct domq_contact first, second;
    double theta = csv_number(csv, "theta");
    assert_status(ask_angles_find(train, &angles), DOM_OK);
    assert_near("theta_c", angles.theta_c, csv_number(csv, "theta_c"), bound);
    assert_near("theta_f", angles.theta_f, csv_number(csv, "theta_f"), bound);
    double leave = csv_number(csv, "theta_leave");
    assert_int_equal(angles.detaches, !isnan(leave));
    if (angles.detaches)
        assert_near("theta_leave", angles.theta_leave, leave, bound);
    assert_status(ask_contact_find(train, theta, &first), DOM_OK);
    assert_near("theta_1", first.theta_1, csv_number(csv, "theta_1"), bound);
    assert_near("slope", first.slope, csv_number(csv, "dtheta_1"), bound);
    assert_near("a / b", first.arm_a / first.arm_b, first.slope, 1e-12);
    double theta_2 = csv_number(csv, "theta_2");
    if (!isnan(theta_2) && first.theta_1 < angles.theta_c) {
        assert_status(ask_contact_find(train, first.theta_1, &second), DOM_OK);
        assert_near("theta_2", second.theta_1, theta_2, bound);
    }
}

static void check_dynamics(const struct csv *csv, struct setup train, const struct bounds *allowed,
                           bool paper)
{
    double theta = csv_number(csv, "theta");
    domq_real duration = DOMQ_NAN, omegasq = DOMQ_NAN;
    struct domq_energy energy;
    struct domq_fuels fuels;
    struct domq_launch launch;
    struct domq_barrier barrier;
    train.fuel = paper ? DOM_FUEL_PAPER : DOM_FUEL_EXACT;

    assert_status(ask_energy_find(&train, theta, &energy), DOM_OK);
    assert_near("J0", energy.J0, csv_number(csv, "J0"), allowed->digits);
    assert_near("J", energy.J, csv_number(csv, "J"), allowed->digits);
    assert_near("dH", energy.dH, csv_number(csv, "dH"), allowed->digits);
    assert_status(ask_fuel_find(&train, &fuels), DOM_OK);
    assert_near("fuel_paper", fuels.paper, csv_number(csv, "fuel_paper"), allowed->digits);
    assert_near("fuel_exact", fuels.exact, csv_number(csv, "fuel_exact"), allowed->digits);

    double P = paper ? fuels.paper : fuels.exact;
    double omega0sq = csv_number(csv, paper ? "omega0sq_paper" : "omega0sq_exact");
    assert_status(ask_launch_find(&train, &launch), P > 0 ? DOM_OK : DOM_NO_FUEL);
    enum dom_status verdict = ask_barrier_find(&train, &barrier);
    assert_near("barrier", barrier.barrier, csv_number(csv, "barrier"), allowed->digits);
    /* The tilt of a flat maximum is the zero of H', and is as well conditioned as H'. */
    assert_near("theta_m", barrier.theta_m, csv_number(csv, "theta_m"), 10 * allowed->digits);
    if (P <= 0) {
        assert_status(verdict, DOM_NO_FUEL);
        assert_true(isnan(launch.omegasq) && isnan(barrier.kinetic) && isnan(barrier.margin));
        assert_status(ask_cycle_omegasq(&train, theta, &omegasq), DOM_NO_FUEL);
        assert_true(isnan(omegasq));
        assert_status(ask_cycle_duration(&train, &duration), DOM_NO_FUEL);
        assert_status(ask_cycle_stop(&train, &duration), DOM_NO_FUEL);
        return;
    }
    assert_near("omega0sq", launch.omegasq, omega0sq, allowed->digits);
    assert_near("kinetic", launch.kinetic, energy.J0 * omega0sq, allowed->digits);
    double margin = launch.kinetic - csv_number(csv, "barrier");
    assert_status(verdict, margin >= 0 ? DOM_OK : DOM_STOPS);

    double formal = csv_number(csv, paper ? "omegasq_paper" : "omegasq_exact");
    enum dom_status way = ask_cycle_omegasq(&train, theta, &omegasq);
    if (way == DOM_OK)
        assert_near("omegasq", omegasq, formal, allowed->digits);
    else
        assert_true(verdict == DOM_STOPS && isnan(omegasq));
    double expected = csv_number(csv, paper ? "duration_paper" : "duration_exact");
    enum dom_status whole = ask_cycle_duration(&train, &duration);
    assert_status(whole, verdict);
    if (!isnan(expected))
        assert_near("duration", duration, expected, allowed->duration);
}

TEST(points)
{
    int rows = 0;
    struct csv *csv = csv_open("tests/reference/points.csv");
    for (; csv_next(csv); rows++) {
        struct setup train = csv_train(csv);
        train.r = csv_number(csv, "r");
        train.d = csv_number(csv, "d");
        for (int k = 0; k < 2; k++) {
            train.tol = bounds[k].tol;
            check_geometry(csv, &train, bounds[k].digits);
            check_dynamics(csv, train, &bounds[k], false);
            check_dynamics(csv, train, &bounds[k], true);
        }
    }
    assert_int_equal(rows, 16);
}

/* Checks r_max to 1e-13, of trains and of pairs. In some rows of the tables the limit is a margin of 0, which
 * is a steep function of r, and in others the reach 1/s. */
TEST(largest_growths)
{
    for (int pair = 0; pair < 2; pair++) {
        int rows = 0;
        struct csv *csv = csv_open(pair ? "tests/reference/pair.csv" : "tests/reference/rmax.csv");
        for (; csv_next(csv); rows++) {
            struct domq_limit limit;
            struct setup train = csv_train(csv);
            if (!pair) {
                train.d = csv_number(csv, "d");
                train.fuel = strcmp(csv_text(csv, "fuel"), "paper") == 0 ? DOM_FUEL_PAPER : DOM_FUEL_EXACT;
            }
            for (int k = 0; k < 2; k++) {
                train.tol = bounds[k].tol;
                assert_status((pair ? ask_limit_pair : ask_limit_rmax)(&train, &limit), DOM_OK);
                assert_near("r_max", limit.r_max, csv_number(csv, "r_max"), bounds[k].duration);
                assert_string_equal(dom_end_text(limit.ends), csv_text(csv, "ends_by"));
            }
        }
        assert_int_equal(rows, pair ? 18 : 42);
    }
}
