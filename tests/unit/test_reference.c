/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Compares every quantity of the model with tables in tests/reference, which were computed with 40 digits.
 * The points have condition numbers up to about 100, for the slope just before a follower detaches ("wide")
 * and for the weights r^-qi of 6000 dominoes ("very-close"). So at tol = 1e-15 errors of 100 to 200 times
 * 2^-53 are allowed, which is 3e-14. Durations are printed with 14 digits, and are compared to 1e-13. At the
 * default tol = 1e-12 all quantities must be right to tol.
 */
#include "support.h"

struct bounds {
    double tol, digits, duration;
};

static const struct bounds tight = {1e-15, 3e-14, 1e-13}, usual = {1e-12, 1e-12, 1e-12};

static void check_geometry(const struct csv *csv, const struct asked *train, double bound)
{
    struct domq_angles angles;
    struct domq_contact first, second;
    double theta = csv_number(csv, "theta");
    assert_status(ask_angles_find(train, &angles, NULL), DOM_OK);
    assert_near("theta_c", angles.theta_c, csv_number(csv, "theta_c"), bound);
    assert_near("theta_f", angles.theta_f, csv_number(csv, "theta_f"), bound);
    double leave = csv_number(csv, "theta_leave");
    assert_int_equal(angles.detaches, !isnan(leave));
    if (angles.detaches)
        assert_near("theta_leave", angles.theta_leave, leave, bound);
    assert_status(ask_contact_find(train, theta, &first, NULL), DOM_OK);
    assert_near("theta_1", first.theta_1, csv_number(csv, "theta_1"), bound);
    assert_near("slope", first.slope, csv_number(csv, "dtheta_1"), bound);
    assert_near("a / b", first.arm_a / first.arm_b, first.slope, 1e-12);
    double theta_2 = csv_number(csv, "theta_2");
    if (!isnan(theta_2) && first.theta_1 < angles.theta_c) {
        assert_status(ask_contact_find(train, first.theta_1, &second, NULL), DOM_OK);
        assert_near("theta_2", second.theta_1, theta_2, bound);
    }
}

static void check_dynamics(const struct csv *csv, struct asked train, const struct bounds *bounds, bool paper)
{
    double theta = csv_number(csv, "theta");
    domq_real duration = DOMQ_NAN, omegasq = DOMQ_NAN;
    struct domq_energy energy;
    struct domq_fuels fuels;
    struct domq_launch launch;
    struct domq_barrier barrier;
    train.fuel = paper ? DOM_FUEL_PAPER : DOM_FUEL_EXACT;

    assert_status(ask_energy_find(&train, theta, &energy, NULL), DOM_OK);
    assert_near("J0", energy.J0, csv_number(csv, "J0"), bounds->digits);
    assert_near("J", energy.J, csv_number(csv, "J"), bounds->digits);
    assert_near("dH", energy.dH, csv_number(csv, "dH"), bounds->digits);
    assert_status(ask_fuel_find(&train, &fuels, NULL), DOM_OK);
    assert_near("fuel_paper", fuels.paper, csv_number(csv, "fuel_paper"), bounds->digits);
    assert_near("fuel_exact", fuels.exact, csv_number(csv, "fuel_exact"), bounds->digits);

    double P = paper ? fuels.paper : fuels.exact;
    double omega0sq = csv_number(csv, paper ? "omega0sq_paper" : "omega0sq_exact");
    assert_status(ask_launch_find(&train, &launch, NULL), P > 0 ? DOM_OK : DOM_NO_FUEL);
    enum dom_status verdict = ask_barrier_find(&train, &barrier, NULL);
    assert_near("barrier", barrier.barrier, csv_number(csv, "barrier"), bounds->digits);
    /* The tilt of a flat maximum is the zero of H', and is as well conditioned as H'. */
    assert_near("theta_m", barrier.theta_m, csv_number(csv, "theta_m"), 10 * bounds->digits);
    if (P <= 0) {
        assert_status(verdict, DOM_NO_FUEL);
        assert_true(isnan(launch.omegasq) && isnan(barrier.kinetic) && isnan(barrier.margin));
        assert_status(ask_cycle_omegasq(&train, theta, &omegasq, NULL), DOM_NO_FUEL);
        assert_true(isnan(omegasq));
        assert_status(ask_cycle_duration(&train, &duration, NULL), DOM_NO_FUEL);
        return;
    }
    assert_near("omega0sq", launch.omegasq, omega0sq, bounds->digits);
    assert_near("kinetic", launch.kinetic, energy.J0 * omega0sq, bounds->digits);
    double margin = launch.kinetic - csv_number(csv, "barrier");
    assert_status(verdict, margin >= 0 ? DOM_OK : DOM_STOPS);

    double formal = csv_number(csv, paper ? "omegasq_paper" : "omegasq_exact");
    enum dom_status way = ask_cycle_omegasq(&train, theta, &omegasq, NULL);
    if (way == DOM_OK)
        assert_near("omegasq", omegasq, formal, bounds->digits);
    else
        assert_true(verdict == DOM_STOPS && isnan(omegasq));
    double expected = csv_number(csv, paper ? "duration_paper" : "duration_exact");
    enum dom_status whole = ask_cycle_duration(&train, &duration, NULL);
    assert_status(whole, verdict);
    if (!isnan(expected))
        assert_near("duration", duration, expected, bounds->duration);
}

static void check_points(const struct bounds *bounds)
{
    int rows = 0;
    struct csv *csv = csv_open("tests/reference/points.csv");
    for (; csv_next(csv); rows++) {
        struct asked train = csv_train(csv);
        train.r = csv_number(csv, "r");
        train.d = csv_number(csv, "d");
        train.tol = bounds->tol;
        check_geometry(csv, &train, bounds->digits);
        check_dynamics(csv, train, bounds, false);
        check_dynamics(csv, train, bounds, true);
    }
    assert_int_equal(rows, 16);
}

TEST(points_to_the_last_digits)
{
    check_points(&tight);
}

TEST(points_to_the_default_tolerance)
{
    check_points(&usual);
}

/* Checks r_max to 1e-13, where the margin is a steep function of r, and also where r_max is the reach 1/s. */
TEST(largest_growth)
{
    int rows = 0;
    struct csv *csv = csv_open("tests/reference/rmax.csv");
    for (; csv_next(csv); rows++) {
        struct domq_limit limit;
        struct asked train = csv_train(csv);
        train.d = csv_number(csv, "d");
        train.fuel = strcmp(csv_text(csv, "fuel"), "paper") == 0 ? DOM_FUEL_PAPER : DOM_FUEL_EXACT;
        train.tol = 1e-15;
        assert_status(ask_limit_rmax(&train, &limit, NULL), DOM_OK);
        assert_near("r_max", limit.r_max, csv_number(csv, "r_max"), 1e-13);
        assert_string_equal(dom_end_text(limit.ends), csv_text(csv, "ends_by"));
        train.tol = 1e-12;
        assert_status(ask_limit_rmax(&train, &limit, NULL), DOM_OK);
        assert_near("r_max at 1e-12", limit.r_max, csv_number(csv, "r_max"), 1e-12);
    }
    assert_int_equal(rows, 42);
}

TEST(largest_growth_of_a_pair)
{
    int rows = 0;
    struct csv *csv = csv_open("tests/reference/pair.csv");
    for (; csv_next(csv); rows++) {
        struct domq_limit limit;
        struct asked train = csv_train(csv);
        train.tol = 1e-15;
        assert_status(ask_limit_pair(&train, &limit, NULL), DOM_OK);
        assert_near("pair r_max", limit.r_max, csv_number(csv, "r_max"), 1e-13);
        assert_string_equal(dom_end_text(limit.ends), csv_text(csv, "ends_by"));
    }
    assert_int_equal(rows, 18);
}

/* Checks best separations, which are known to 6 digits, and their growths, which are known to 7 digits. */
TEST(best_separation)
{
    static const struct {
        double q;
        enum dom_fuel fuel;
        double s, r_max;
    } known[] = {
        {3, DOM_FUEL_EXACT, 0.443615, 2.172869},
        {3, DOM_FUEL_PAPER, 0.432413, 2.202558},
        {4, DOM_FUEL_EXACT, 0.533651, 1.810436},
        {4, DOM_FUEL_PAPER, 0.520419, 1.831348},
    };
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        struct asked train = asked_default();
        struct domq_best best;
        struct domq_limit beside;
        train.q = known[i].q;
        train.fuel = known[i].fuel;
        assert_status(ask_limit_best(&train, &best, NULL), DOM_OK);
        assert_near("best s", best.s, known[i].s, 0.5e-6 / known[i].s);
        assert_near("best r_max", best.r_max, known[i].r_max, 0.5e-6 / known[i].r_max);
        for (int side = -1; side <= 1; side += 2) {
            train.s = best.s * (1 + side * 1e-5);
            assert_status(ask_limit_rmax(&train, &beside, NULL), DOM_OK);
            assert_true(beside.r_max < best.r_max);
        }
    }
}

/*
 * Checks followers that detach at small angles, where naive formulas for sin theta_f and for the energy of
 * the detaching follower would lose digits. The expected values come from 256-bit arithmetic.
 */
TEST(detaching_at_small_angles)
{
    static const struct {
        const char *quantity;
        double s, r, d, q, value, bound;
    } known[] = {
        {"theta_f", 3.3218168398828681e-05, 321.25105028829063, 0.14583333333333334, 3, 0.021341907012756661,
         2e-15},
        {"paper", 3.7116290225179591e-05, 76.735199681883813, 2.2877715991300551, 1.5150948304658971,
         -0.013015394059843347, 2e-15},
        {"exact", 1.9049790079244013e-05, 407.93455594939269, 0.43502259373183116, 0.5,
         -0.0034097934075310566, 4e-15},
        {"dH", 2.4458569011092586e-05, 414.98468406832978, 2.484130149454693, 0.65668514063612715,
         0.003549098981117767, 4e-15},
    };
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        struct asked train = asked_default();
        struct domq_angles angles;
        struct domq_fuels fuels;
        struct domq_energy energy;
        train.tol = 1e-15;
        train.s = known[i].s;
        train.r = known[i].r;
        train.d = known[i].d;
        train.q = known[i].q;
        assert_status(ask_angles_find(&train, &angles, NULL), DOM_OK);
        assert_status(ask_fuel_find(&train, &fuels, NULL), DOM_OK);
        assert_status(ask_energy_find(&train, 0.0014198964972401396, &energy, NULL), DOM_OK);
        const domq_real value[] = {angles.theta_f, fuels.paper, fuels.exact, energy.dH};
        assert_near(known[i].quantity, value[i], known[i].value, known[i].bound);
    }
}

/* Checks the separation at which the curve of the barrier meets r = 1/s. For the exact fuel, six digits are
 * known. */
TEST(barrier_curve_meets_reach)
{
    static const double meets[][2] = {{3, 0.53929}, {4, 0.61901}};
    for (size_t i = 0; i < 2; i++) {
        struct asked train = asked_default();
        struct domq_limit limit;
        train.q = meets[i][0];
        train.s = meets[i][1] - 1e-5;
        assert_status(ask_limit_rmax(&train, &limit, NULL), DOM_OK);
        assert_int_equal(limit.ends, DOM_END_BARRIER);
        train.s = meets[i][1] + 1e-5;
        assert_status(ask_limit_rmax(&train, &limit, NULL), DOM_OK);
        assert_int_equal(limit.ends, DOM_END_REACH);
    }
}
