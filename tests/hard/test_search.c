/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Compares the limits with a dense scan that uses no bounds, but computes the margin of random trains at many
 * growths, each time with a complete search for the barrier. The library has missed a root if the train stops
 * at a growth below r_max, or if a pair still succeeds at a growth above r_max in its first band.
 */
#include "../unit/support.h"
#include "growth.h"
#include "library.h"
#include "sweep.h"

/* Just below r_max, rounding errors hide the sign of the margin. */
#define RESOLVED 1e-5

/* Returns how many of `all` trains are checked. */
static int part_of(int all)
{
    return (int)ceil(sweep_size() * all);
}

static struct setup any_train(uint64_t *seed, double mu)
{
    struct setup train = setup_default();
    train.d = random_log(seed, 1e-6, 0.75);
    train.s = random_log(seed, 0.01, 1);
    train.q = random_log(seed, 0.4, 4);
    train.fuel = random_unit(seed) < 0.3 && mu == 0 ? DOM_FUEL_PAPER : DOM_FUEL_EXACT;
    train.mu = mu > 0 ? mu * random_unit(seed) : 0;
    return train;
}

/* Returns the margin divided by the sum of its terms, or -1 if the train cannot start. */
static double share(const struct setup *train, double r)
{
    struct domq_barrier b;
    struct setup at = *train;
    at.r = r;
    at.tol = 1e-6;
    enum dom_status status = ask_barrier_find(&at, &b);
    if (status != DOM_OK && status != DOM_STOPS)
        return -1;
    return (double)(b.margin / (b.kinetic + b.barrier));
}

/* Returns the first growth at which the train stops, among n growths up to r_max. These are evenly spaced in
 * ln r, with additional ones near the end. */
static double first_stop(const struct setup *train, double r_max, int n)
{
    double ln_r = log(r_max);
    for (int k = 0; k < 2 * n; k++) {
        double part = k < n ? (double)k / n : 1 - pow(10, -6.0 * (k - n + 1) / n);
        double r = exp(ln_r * part);
        if (r < r_max * (1 - RESOLVED) && share(train, r) < -1e-5)
            return r;
    }
    return NAN;
}

TEST(no_train_stops_below_r_max)
{
    uint64_t seed = 4711;
    int limits = 0, reached = 0, missed = 0;
    for (int i = 0; i < part_of(1000); i++) {
        struct setup train = any_train(&seed, 0);
        struct domq_limit limit;
        if (ask_limit_rmax(&train, &limit) != DOM_OK || limit.ends == DOM_END_NONE)
            continue;
        limits++;
        reached += limit.ends == DOM_END_REACH;
        double r = first_stop(&train, (double)limit.r_max, 150);
        if (r > 0 && ++missed)
            print_error("s %.17g d %.17g q %.17g fuel %d: stops at %.12g < %.12g\n", (double)train.s,
                        (double)train.d, (double)train.q, train.fuel, r, (double)limit.r_max);
        if (limit.ends == DOM_END_BARRIER && (double)(limit.r_max * train.s) < 1 - 1e-9 &&
            share(&train, (double)limit.r_max * (1 + 1e-9)) > 1e-6)
            fail_msg("goes on behind r_max");
    }
    print_message("# %d limits, %d of them the reach, %d missed\n", limits, reached, missed);
    assert_true(missed == 0 && limits > part_of(600));
}

/* Checks limits with friction, which are found without bounds. One miss in a hundred is allowed. */
TEST(few_trains_with_friction_stop_below_r_max)
{
    uint64_t seed = 815;
    int limits = 0, missed = 0;
    for (int i = 0; i < part_of(100); i++) {
        struct setup train = any_train(&seed, 0.4);
        struct domq_limit limit;
        if (ask_limit_rmax(&train, &limit) != DOM_OK || limit.ends == DOM_END_NONE)
            continue;
        limits++;
        missed += first_stop(&train, (double)limit.r_max, 30) > 0;
    }
    print_message("# %d limits with friction, %d missed\n", limits, missed);
    assert_true(missed * 100 <= limits && limits >= part_of(30));
}

/* Returns the margin of a pair, in plain formulas: domino 1, just tipped over, hits domino 0, (9; b5),
 * (15; b11) and (17; b13). */
static double pair_share(double s, double d, double q, double r)
{
    double k = pow(r, -q - 1), theta_c = asin(fmin(r * s, 1)), up = sqrt(1 + d * d), most = 0;
    if (theta_c <= atan(d))
        return -1;
    double push = up - (cos(theta_c) + d * sin(theta_c)), kinetic = r * push * k * k / (1 + k);
    double last = fmin(theta_c, 1.2 * atan(d)), before = cos(theta_c) + d * sin(theta_c), follower = 0;
    for (int i = 1; i <= 400; i++) {
        double theta = last * i / 400, X = r * ((s + d) * cos(theta) - d),
               now = theta + asin(fmax(fmin(X, 1), -1));
        follower = fmax(follower, now); /* a domino that has detached does not come back */
        double rise =
            cos(theta) + d * sin(theta) - 1 + pow(r, -q) * (cos(follower) + d * sin(follower) - before);
        most = fmax(most, rise);
    }
    return (kinetic - most) / (kinetic + most);
}

TEST(pairs_succeed_in_their_first_band)
{
    uint64_t seed = 99;
    int bands = 0, missed = 0;
    for (int i = 0; i < part_of(4000); i++) {
        struct setup train = any_train(&seed, 0);
        struct domq_limit limit;
        double s = (double)train.s, d = (double)train.d, q = (double)train.q;
        train.fuel = DOM_FUEL_EXACT;
        assert_status(ask_limit_pair(&train, &limit), DOM_OK);
        double end = limit.ends == DOM_END_NONE ? 0 : (double)limit.r_max, first = 0, last = 0;
        for (int k = 0; k <= 100 && last == 0; k++) {
            double r = pow(s, -k / 100.0), left = pair_share(s, d, q, r);
            if (left > 1e-3 && first == 0)
                first = r;
            else if (left < -1e-3 && first > 0)
                last = r;
        }
        bands += end > 0;
        bool wrong = first > 0 && (end < first || (last > 0 && end > last));
        if (wrong && ++missed)
            print_error("s %.17g d %.17g q %.17g: %.12g, not in %.12g to %.12g\n", s, d, q, end, first, last);
    }
    print_message("# %d bands, %d missed\n", bands, missed);
    assert_true(missed == 0 && bands >= part_of(400));
}
