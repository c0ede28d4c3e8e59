/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The best separations, compared with values in many bits, and limits with friction. */
#include "../unit/support.h"
#include "sweep.h"

static const enum precision precisions[] = {IN_FLOAT, IN_DOUBLE, IN_QUAD};

static void small(const char *what, const struct ref_input *in, double error, double bound)
{
    if (!(fabs(error) <= bound))
        fail_msg("%s: s=%.17g r=%.17g d=%.17g q=%.17g: off by %.3g > %.3g", what, (double)in->s,
                 (double)in->r, (double)in->d, (double)in->q, error, bound);
}

/* Returns the weighted sum of the margins at s - step, s and s + step. */
static double difference(const struct ref_input *best, double step, const int weight[3])
{
    mpfr_t sum, term;
    mpfr_inits2(640, sum, term, (mpfr_ptr)0);
    mpfr_set_zero(sum, 1);
    for (int k = 0; k < 3; k++) {
        struct ref_input input = *best;
        input.s += (domq_real)((k - 1) * step);
        struct ref *ref = ref_open(&input, 640, 300);
        mpfr_mul_si(term, ref_value(ref, REF_MARGIN), weight[k], MPFR_RNDN);
        mpfr_add(sum, sum, term, MPFR_RNDN);
        ref_close(ref);
    }
    double value = mpfr_get_d(sum, MPFR_RNDN);
    mpfr_clears(sum, term, (mpfr_ptr)0);
    return value;
}

/* Returns how far s is from the maximum of r_max(s), at which the derivative of the margin with respect to s
 * is 0. */
static double distance_from_top(const struct ref_input *best)
{
    static const int first[] = {-1, 0, 1}, second[] = {1, -2, 1};
    const double fine = 0x1p-57, coarse = 0x1p-20;
    return difference(best, fine, first) / (2 * fine) /
           (difference(best, coarse, second) / (coarse * coarse));
}

TEST(best_separations)
{
    static const struct {
        double d, q;
        bool paper;
        int precisions; /* number of precisions, from float on */
    } known[] = {
        {7 / 48.0, 3, false, 3}, {7 / 48.0, 4, false, 2}, {7 / 48.0, 3, true, 2}, {7 / 48.0, 4, true, 2},
        {0.1, 3.5, false, 2},    {0.2, 2.5, false, 2},    {0.3, 4, true, 2},
    };
    for (size_t k = 0; k < sizeof known / sizeof *known; k++)
        for (int p = 0; p < known[k].precisions; p++) {
            if (any_arithmetic(precisions[p]).bits == 0)
                continue;
            struct ref_input input = {.s = (domq_real)0.4,
                                      .r = 1,
                                      .d = rounded_to(precisions[p], known[k].d),
                                      .q = rounded_to(precisions[p], known[k].q),
                                      .paper = known[k].paper};
            struct setup train = library_train(&input, precisions[p]);
            struct answers a;
            double scale;
            library_nothing(&a);
            library_ask(&train, 0, REF_BEST_S, &a);
            assert_status(a.status[REF_BEST_S], DOM_OK);
            input.s = a.value[REF_BEST_S];
            input.r = a.value[REF_BEST_R];
            const double unit = library_unit(precisions[p]),
                         error_of_r = growth_error(&input, false, 110, input.r, &scale),
                         error_of_s = distance_from_top(&input);
            /* The maximum is flat, so half of the digits of s would be enough for r_max, but the library
             * finds all of them. */
            small("best r_max", &input, error_of_r, 64 * scale * unit);
            small("best s", &input, error_of_s,
                  fmin((double)a.best_s_uncertainty + 8 * unit, 1e4 * (double)input.s * unit));
        }
}

/* ---- Limits with friction ---- */

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

/* Returns true if the train stops at one of 60 growths up to r_max. Half of these are evenly spaced in ln r,
 * the others are near the end. Just below r_max, rounding errors hide the sign of the margin. */
static bool stops_before(const struct setup *train, double r_max)
{
    enum { n = 30 };
    double ln_r = log(r_max);
    for (int k = 0; k < 2 * n; k++) {
        double part = k < n ? (double)k / n : 1 - pow(10, -6.0 * (k - n + 1) / n);
        double r = exp(ln_r * part);
        if (r < r_max * (1 - 1e-5) && share(train, r) < -1e-5)
            return true;
    }
    return false;
}

/* Checks limits with friction, which are found without bounds. One miss in a hundred is allowed. */
TEST(few_trains_with_friction_stop_below_r_max)
{
    uint64_t seed = 815;
    int limits = 0, missed = 0;
    const int trains = (int)ceil(100 * sweep_size());
    for (int i = 0; i < trains; i++) {
        struct setup train = setup_default();
        train.d = random_log(&seed, 1e-6, 0.75);
        train.s = random_log(&seed, 0.01, 1);
        train.q = random_log(&seed, 0.4, 4);
        train.mu = 0.4 * random_unit(&seed);
        struct domq_limit limit;
        if (ask_limit_rmax(&train, &limit) != DOM_OK || limit.ends == DOM_END_NONE)
            continue;
        limits++;
        missed += stops_before(&train, (double)limit.r_max);
    }
    print_message("# %d limits with friction, %d missed\n", limits, missed);
    assert_true(missed * 100 <= limits && limits * 10 >= trains * 3);
}
