/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The best separations, numbers of dominoes and limits with friction. The first two are compared with values
 * in many bits. */
#include "../unit/support.h"
#include "sweep.h"

static const enum precision precisions[] = {IN_FLOAT, IN_DOUBLE, IN_QUAD};
#define FOR_PRECISIONS(p)                                                                                    \
    for (const enum precision *p = precisions; p < precisions + 3; p++)                                      \
        if (any_arithmetic(*p).bits > 0)

static domq_real rounded(double x, enum precision precision)
{
    return precision == IN_FLOAT ? (domq_real)(float)x : (domq_real)x;
}

static domq_real magnitude(domq_real x)
{
    return x < 0 ? -x : x;
}

#define assert_close(what, input, got, want, bound) close_(what, input, got, want, bound, __FILE__, __LINE__)

static void close_(const char *what, const struct ref_input *in, domq_real got, domq_real want,
                   domq_real bound, const char *file, int line)
{
    if (magnitude(got - want) <= bound)
        return;
    fprintf(stderr,
            "# %s: s=%.17g r=%.17g d=%.17g q=%.17g tilt=%.17g: %.17g and %.17g differ by %.3g > %.3g\n", what,
            (double)in->s, (double)in->r, (double)in->d, (double)in->q, (double)in->tilt, (double)got,
            (double)want, (double)magnitude(got - want), (double)bound);
    _fail(file, line);
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
                                      .d = rounded(known[k].d, precisions[p]),
                                      .q = rounded(known[k].q, precisions[p]),
                                      .paper = known[k].paper};
            struct setup train = library_train(&input, precisions[p]);
            struct answers a;
            double scale;
            library_nothing(&a);
            library_ask(&train, 0, REF_BEST_S, &a);
            assert_status(a.status[REF_BEST_S], DOM_OK);
            input.s = a.value[REF_BEST_S];
            input.r = a.value[REF_BEST_R];
            const double error_of_r = growth_error(&input, false, 110, input.r, &scale);
            const double error_of_s = distance_from_top(&input);
            assert_close("best s", &input, (domq_real)error_of_s, 0,
                         a.best_s_uncertainty + (domq_real)(8 * library_unit(precisions[p])));
            /* The maximum is flat, so half of the digits of s would be enough for r_max, but the library
             * finds all of them. */
            assert_close("best r_max", &input, (domq_real)error_of_r, 0,
                         (domq_real)(64 * scale * library_unit(precisions[p])));
            assert_close("best s", &input, (domq_real)error_of_s, 0,
                         (domq_real)(1e4 * (double)input.s * library_unit(precisions[p])));
        }
}

/* ---- Counting ---- */

TEST(counts)
{
    FOR_PRECISIONS(p)
    {
        uint64_t seed = 15;
        for (int k = 0; k < 300; k++) {
            const domq_real first = rounded(random_log(&seed, 1e-3, 1), *p);
            const domq_real height = rounded(random_log(&seed, 1, 1e3), *p);
            const domq_real r = 1 + rounded(random_log(&seed, 1e-3, 3), *p);
            struct domq_count count;
            mpfr_t a, b;
            mpfr_inits2(400, a, b, (mpfr_ptr)0);
            assert_status(ask_count_find(*p, first, height, r, &count), DOM_OK);
            ref_set_real(a, height);
            ref_set_real(b, first);
            mpfr_div(a, a, b, MPFR_RNDN);
            mpfr_log(a, a, MPFR_RNDN);
            ref_set_real(b, *p == IN_FLOAT    ? (domq_real)(float)r
                            : *p == IN_DOUBLE ? (domq_real)(double)r
                                              : r);
            mpfr_log(b, b, MPFR_RNDN);
            mpfr_div(a, a, b, MPFR_RNDN);
            assert_int_equal((long)count.dominoes, (long)ceil(mpfr_get_d(a, MPFR_RNDN)));
            ref_set_real(b, count.exact);
            mpfr_sub(a, a, b, MPFR_RNDN);
            const double wrong = fabs(mpfr_get_d(a, MPFR_RNDN));
            mpfr_clears(a, b, (mpfr_ptr)0);
            const double unit = any_arithmetic(*p).epsilon,
                         most = unit * (1 / log((double)r) + 3 * fabs((double)count.exact));
            if (!(wrong <= most))
                fail_msg("%.17g from %.17g by %.17g: %.17g is wrong by %.3g > %.3g", (double)height,
                         (double)first, (double)r, (double)count.exact, wrong, most);
        }
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
