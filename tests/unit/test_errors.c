/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Error bounds compared with quad, for random trains with a slope, friction and rounded edges, in float and
 * double. Each number that has an error bound differs from the number in quad by no more than the bound, and
 * the bounds of a quantity are not much wider than its errors.
 */
#include "support.h"

enum { SCENES = 160, LINKS = 24, MEMBERS = 10 };

/* A bound is too wide if it is larger than the tolerance, and also larger than this many times the error and
 * the unit roundoff. At most half of the bounds of a quantity may be too wide. */
static const double wide = 100;

enum result {
    ANGLES,
    CONTACT,
    LINK,
    ENERGY,
    FUELS,
    LAUNCH,
    BARRIER,
    STATE,
    OMEGASQ,
    STOP,
    DURATION,
    RMAX,
    PAIR,
    RESULTS
};

static const char *const result_name[] = {"angles",   "contact", "chain", "energy",  "fuels",
                                          "launch",   "barrier", "state", "omegasq", "stop",
                                          "duration", "rmax",    "pair"};

/* The number of bounds of a quantity, and the number of those that are too wide. */
static struct tally {
    long bounds, wide;
} tally[RESULTS][MEMBERS];

static struct domq_train train;
static struct domq_compute compute, exact;

static double uniform(double lo, double hi)
{
    static uint64_t seed = 1;
    return lo + (hi - lo) * random_unit(&seed);
}

static double either(double a, double b)
{
    return uniform(0, 1) < 0.5 ? a : b;
}

static domq_real rounded(double value)
{
    return compute.precision == DOM_FLOAT ? (domq_real)(float)value : value;
}

static void scene(int k)
{
    double d = exp(uniform(log(1e-3), log(k % 8 ? 0.8 : 20))), s = exp(uniform(log(0.02), log(0.99)));
    double rho = k % 3 == 0 ? uniform(0, fmin(d / 2, 0.49)) : 0;
    compute = exact = domq_compute_default();
    compute.precision = k % 2 ? DOM_FLOAT : DOM_DOUBLE;
    compute.errors = true;
    compute.tol = domq_arithmetic(compute.precision)->tol_default * either(1, 10);
    exact.precision = DOM_QUAD;
    exact.tol = 1e-24;
    train = domq_train_default();
    train.s = rounded(s);
    train.d = rounded(d);
    train.r = rounded(1 + (1 / s - 1) * uniform(0, 1) * either(1, 0.05));
    train.q = rounded(either(3, uniform(2, 5)));
    train.alpha = k % 4 < 2 ? rounded(atan(d) * uniform(-1, 1) * either(0.9999, 0.3)) : 0;
    train.mu = k % 5 == 0 ? rounded(uniform(0, 0.5)) : 0;
    train.rho = rounded(rho);
}

/* Compares the members of a result with the same result in quad. */
static void compare(enum result result, const domq_real *got, const domq_real *want, const domq_real *error,
                    size_t size)
{
    const double unit = domq_arithmetic(compute.precision)->epsilon / 2;
    for (size_t i = 0; i < size / sizeof *error; i++) {
        struct tally *t = &tally[result][i];
        double off = fabs((double)(got[i] - want[i])), bound = (double)error[i];
        if (train.rho != 0)
            assert_true(isnan(bound));
        if (isnan(bound) || isnan((double)want[i]) || isnan((double)got[i]))
            continue;
        t->bounds++;
        t->wide += bound > fmax(wide * off, fmax(wide * unit, (double)compute.tol) * fabs((double)want[i]));
        if (off <= bound)
            continue;
        print_message("%s: %s[%zu] = %.20g, in quad %.20g: the error of %.3g is %.3g times its bound\n"
                      "s %.17g r %.17g d %.17g q %.17g alpha %.17g mu %.17g rho %.17g\n",
                      domq_arithmetic(compute.precision)->name, result_name[result], i, (double)got[i],
                      (double)want[i], off, off / bound, (double)train.s, (double)train.r, (double)train.d,
                      (double)train.q, (double)train.alpha, (double)train.mu, (double)train.rho);
        fail();
    }
}

/* Compares the result of a call with its result in quad. The call reads `how` and writes to `answer`. */
#define COMPARE(result, type, first, call)                                                                   \
    do {                                                                                                     \
        struct domq_##type got, want, *answer = &got;                                                        \
        const struct domq_compute *how = &compute;                                                           \
        enum dom_status status = call;                                                                       \
        answer = &want;                                                                                      \
        how = &exact;                                                                                        \
        if (status == DOM_OK && call == DOM_OK)                                                              \
            compare(result, &got.first, &want.first, (const domq_real *)&got.error, sizeof got.error);       \
    } while (0)

struct chain {
    struct domq_link link[LINKS];
    size_t count;
};

static bool link_seen(const struct domq_link *link, void *context)
{
    struct chain *chain = context;
    chain->link[chain->count++] = *link;
    return chain->count < LINKS;
}

static void compare_chains(domq_real theta)
{
    struct chain got = {.count = 0}, want = {.count = 0};
    if (domq_chain_walk(&train, &compute, theta, link_seen, &got) != DOM_OK ||
        domq_chain_walk(&train, &exact, theta, link_seen, &want) != DOM_OK)
        return;
    for (size_t i = 0; i < got.count && i < want.count; i++)
        compare(LINK, &got.link[i].theta, &want.link[i].theta, (domq_real *)&got.link[i].error,
                sizeof got.link[i].error);
}

TEST(bounds_hold)
{
    for (int k = 0; k < SCENES; k++) {
        struct domq_angles angles;
        scene(k);
        if (domq_angles_find(&train, &compute, &angles) != DOM_OK)
            continue;
        domq_real theta = rounded((double)angles.theta_c * uniform(0, 0.9999));
        COMPARE(ANGLES, angles, theta_c, domq_angles_find(&train, how, answer));
        COMPARE(CONTACT, contact, theta_1, domq_contact_find(&train, how, theta, answer));
        compare_chains(theta);
        COMPARE(ENERGY, energy, dH, domq_energy_find(&train, how, theta, answer));
        COMPARE(FUELS, fuels, exact, domq_fuel_find(&train, how, answer));
        COMPARE(LAUNCH, launch, fuel, domq_launch_find(&train, how, answer));
        COMPARE(BARRIER, barrier, theta_m, domq_barrier_find(&train, how, answer));
        COMPARE(STATE, state, theta, domq_cycle_state(&train, how, theta, answer));
        COMPARE(OMEGASQ, value, value, domq_cycle_omegasq(&train, how, theta, answer));
        COMPARE(STOP, value, value, domq_cycle_stop(&train, how, answer));
        COMPARE(DURATION, value, value, domq_cycle_duration(&train, how, answer));
        if (k % 5 == 1) {
            COMPARE(RMAX, limit, r_max, domq_limit_rmax(&train, how, answer));
            COMPARE(PAIR, limit, r_max, domq_limit_pair(&train, how, answer));
        }
    }
}

TEST(bounds_are_close)
{
    int failures = 0;
    for (int i = 0; i < RESULTS; i++)
        for (int k = 0; k < MEMBERS; k++) {
            const struct tally *t = &tally[i][k];
            if (2 * t->wide <= t->bounds)
                continue;
            print_message("%s[%d]: %ld of %ld bounds are too wide\n", result_name[i], k, t->wide, t->bounds);
            failures++;
        }
    for (int i = 0; i < RESULTS; i++)
        assert_true(tally[i][0].bounds > 0);
    assert_int_equal(failures, 0);
}
