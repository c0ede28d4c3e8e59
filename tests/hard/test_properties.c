/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How r_max depends on the train, the best separations, and numbers of dominoes. The last two are compared
 * with values in many bits. */
#include "../unit/support.h"
#include "growth.h"
#include "library.h"

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

/* ---- Limits of growth ---- */

static domq_real growth_of(double s, double q, double d, enum ref_quantity quantity, struct answers *a)
{
    struct ref_input input = {.s = (domq_real)s, .r = 1, .d = (domq_real)d, .q = (domq_real)q};
    struct setup train = library_train(&input, IN_DOUBLE);
    library_nothing(a);
    library_ask(&train, 0, quantity, a);
    assert_status(a->status[quantity], DOM_OK);
    return a->value[quantity];
}

/*
 * Checks that r_max is continuous, and that it decreases with the thickness, because the head has to climb
 * more, and with the exponent of the mass, because its followers are lighter. The thinnest dominoes are left
 * out, since their margin may increase again near 1/s.
 */
TEST(growth_is_continuous_and_falls_with_d_and_q)
{
    const double h = 1e-8;
    int compared = 0;
    for (double s = 0.08; s < 1; s += 0.07)
        for (double q = 2.5; q < 6; q += 0.7)
            for (double d = 0.06; d < 0.3; d += 0.06) {
                struct answers a;
                struct ref_input input = {.s = (domq_real)s, .r = 1, .d = (domq_real)d, .q = (domq_real)q};
                domq_real r = growth_of(s, q, d, REF_R_MAX, &a);
                if (a.ends == DOM_END_NONE)
                    continue;
                const domq_real near = (domq_real)(20 * h) * r, equal = 4 * (domq_real)0x1p-53 * r;
                assert_close("by s", &input, growth_of(s * (1 + h), q, d, REF_R_MAX, &a), r, near);
                domq_real by_q = growth_of(s, q * (1 + h), d, REF_R_MAX, &a);
                assert_close("by q", &input, by_q, r, near);
                domq_real by_d = growth_of(s, q, d * (1 + h), REF_R_MAX, &a);
                assert_close("by d", &input, by_d, r, near);
                assert_true(by_q <= r + equal && by_d <= r + equal);
                compared++;
            }
    assert_true(compared > 200);
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
