/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Properties that do not depend on digits, such as conservation, self-similarity, order and continuity, and
 * results that need no sweep. Where two results are compared, the library's own error bounds are the
 * tolerance.
 */
#include "../unit/support.h"
#include "growth.h"
#include "library.h"

static const enum dom_precision precisions[] = {DOM_FLOAT, DOM_DOUBLE, DOM_QUAD};
#define FOR_PRECISIONS(p)                                                                                    \
    for (const enum dom_precision *p = precisions; p < precisions + 3; p++)                                  \
        if (domq_arithmetic(*p)->bits > 0)

static domq_real rounded(double x, enum dom_precision precision)
{
    return precision == DOM_FLOAT ? (domq_real)(float)x : (domq_real)x;
}

/* Returns a random input away from the limits of the ranges, which the sweeps cover. */
static struct ref_input random_input(uint64_t *seed, enum dom_precision precision)
{
    struct ref_input input = {.s = rounded(random_log(seed, 0.01, 1), precision),
                              .d = rounded(random_log(seed, 1e-3, 0.5), precision),
                              .q = rounded(1 + 4 * random_unit(seed), precision),
                              .paper = random_unit(seed) < 0.5};
    input.r = rounded(pow(0.999 / (double)input.s, random_unit(seed)), precision);
    input.r = input.r < 1 ? 1 : input.r;
    return input;
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

/* ---- Along a cycle ---- */

/* Checks J w + H - H(0) = K (21; c3). */
TEST(energy_is_conserved)
{
    FOR_PRECISIONS(p)
    {
        uint64_t seed = 11;
        int cycles = 0;
        for (int k = 0; k < 400; k++) {
            struct ref_input input = random_input(&seed, *p);
            struct asked train = library_train(&input, *p);
            struct answers a;
            library_nothing(&a);
            library_ask(&train, 0, REF_THETA_C, &a);
            input.tilt = rounded((double)a.value[REF_THETA_C] * random_unit(&seed), *p);
            library_ask(&train, input.tilt, REF_OMEGASQ, &a);
            if (a.status[REF_OMEGASQ] != DOM_OK)
                continue;
            library_ask(&train, input.tilt, REF_DH, &a);
            library_ask(&train, 0, REF_KINETIC, &a);
            domq_real J = a.value[REF_J], w = a.value[REF_OMEGASQ];
            domq_real bound =
                J * a.error[REF_OMEGASQ] + w * a.error[REF_J] + a.error[REF_DH] + a.error[REF_KINETIC];
            assert_close("J w + dH and K", &input, J * w + a.value[REF_DH], a.value[REF_KINETIC], bound);
            cycles++;
        }
        assert_true(cycles > 100);
    }
}

struct walk {
    struct domq_link before;
    domq_real theta_f;
    size_t links;
    bool ordered;
};

static bool in_order(const struct domq_link *link, void *context)
{
    struct walk *walk = context;
    if (walk->links++ > 0)
        walk->ordered &= link->theta >= walk->before.theta && link->slope <= walk->before.slope &&
                         link->slope >= 0 && link->weight <= walk->before.weight &&
                         link->theta <= walk->theta_f * (1 + (domq_real)1e-15);
    walk->before = *link;
    return true;
}

/* Checks that every domino leans further than its leader, turns more slowly and weighs less, up to
 * theta_f. */
TEST(dominoes_are_in_order)
{
    uint64_t seed = 13;
    size_t links = 0;
    for (int k = 0; k < 400; k++) {
        struct ref_input input = random_input(&seed, DOM_DOUBLE);
        struct asked train = library_train(&input, DOM_DOUBLE);
        struct answers a;
        library_nothing(&a);
        library_ask(&train, 0, REF_THETA_C, &a);
        input.tilt = (domq_real)((double)a.value[REF_THETA_C] * random_unit(&seed));
        struct walk walk = {.ordered = true, .theta_f = a.value[REF_THETA_F]};
        /* If the head has passed the tilt at which its follower has theta_f, no follower leans further than
         * the head. */
        assert_status(ask_chain_walk(&train, input.tilt, in_order, &walk), DOM_OK);
        assert_close("order", &input, walk.ordered, 1, 0);
        links += walk.links;
    }
    assert_true(links > 4000);
}

/* ---- Fuel ---- */

/* Checks that the second equality of (25; c7), a telescoping sum, is true for r = 1. */
TEST(fuels_are_equal_for_equal_dominoes)
{
    FOR_PRECISIONS(p)
    {
        uint64_t seed = 14;
        for (int k = 0; k < 200; k++) {
            struct ref_input input = random_input(&seed, *p);
            input.r = 1;
            struct asked train = library_train(&input, *p);
            struct answers a;
            library_nothing(&a);
            library_ask(&train, 0, REF_FUEL_EXACT, &a);
            assert_close("fuels", &input, a.value[REF_FUEL_EXACT], a.value[REF_FUEL_PAPER],
                         a.error[REF_FUEL_EXACT] + a.error[REF_FUEL_PAPER]);
        }
    }
}

/* ---- Limits of growth ---- */

static domq_real growth_of(double s, double q, double d, enum ref_quantity quantity, struct answers *a)
{
    struct ref_input input = {.s = (domq_real)s, .r = 1, .d = (domq_real)d, .q = (domq_real)q};
    struct asked train = library_train(&input, DOM_DOUBLE);
    library_nothing(a);
    library_ask(&train, 0, quantity, a);
    assert_status(a->status[quantity], DOM_OK);
    return a->value[quantity];
}

/*
 * Checks that a train at its limit is a chain of marginal pairs, if domino 1 detaches before the head reaches
 * its highest point.
 */
TEST(pairs_are_trains_where_only_two_touch)
{
    int alike = 0;
    for (double q = 2; q <= 10; q += 0.5)
        for (double s = 0.45; s < 0.7; s += 0.005) {
            const double d = 0.12;
            struct answers train, pair, angles;
            struct ref_input input = {.s = (domq_real)s, .d = (domq_real)d, .q = (domq_real)q};
            input.r = growth_of(s, q, d, REF_R_MAX, &train);
            growth_of(s, q, d, REF_PAIR, &pair);
            if (train.ends != DOM_END_BARRIER)
                continue;
            struct asked at = library_train(&input, DOM_DOUBLE);
            library_nothing(&angles);
            library_ask(&at, 0, REF_THETA_C, &angles);
            if (!(angles.value[REF_THETA_LEAVE] < angles.value[REF_THETA_U]))
                continue;
            assert_close("r_max of train and pair", &input, train.value[REF_R_MAX], pair.value[REF_PAIR],
                         train.error[REF_R_MAX] + pair.error[REF_PAIR]);
            alike++;
        }
    assert_true(alike > 20);
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
            if (domq_arithmetic(precisions[p])->bits == 0)
                continue;
            struct ref_input input = {.s = (domq_real)0.4,
                                      .r = 1,
                                      .d = rounded(known[k].d, precisions[p]),
                                      .q = rounded(known[k].q, precisions[p]),
                                      .paper = known[k].paper};
            struct asked train = library_train(&input, precisions[p]);
            struct answers a;
            double scale;
            library_nothing(&a);
            library_ask(&train, 0, REF_BEST_S, &a);
            assert_status(a.status[REF_BEST_S], DOM_OK);
            input.s = a.value[REF_BEST_S];
            input.r = a.value[REF_BEST_R];
            const double error_of_r = growth_error(&input, false, 110, input.r, &scale);
            const double error_of_s = distance_from_top(&input);
            assert_close("best r_max", &input, (domq_real)error_of_r, 0, a.error[REF_BEST_R]);
            assert_close("best s", &input, (domq_real)error_of_s, 0, a.error[REF_BEST_S]);
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
            struct domq_count count, error;
            mpfr_t a, b;
            mpfr_inits2(400, a, b, (mpfr_ptr)0);
            assert_status(ask_count_find(*p, first, height, r, &count, &error), DOM_OK);
            ref_set_real(a, height);
            ref_set_real(b, first);
            mpfr_div(a, a, b, MPFR_RNDN);
            mpfr_log(a, a, MPFR_RNDN);
            ref_set_real(b, *p == DOM_FLOAT    ? (domq_real)(float)r
                            : *p == DOM_DOUBLE ? (domq_real)(double)r
                                               : r);
            mpfr_log(b, b, MPFR_RNDN);
            mpfr_div(a, a, b, MPFR_RNDN);
            assert_int_equal((long)count.dominoes, (long)ceil(mpfr_get_d(a, MPFR_RNDN)));
            ref_set_real(b, count.exact);
            mpfr_sub(a, a, b, MPFR_RNDN);
            const double wrong = fabs(mpfr_get_d(a, MPFR_RNDN));
            mpfr_clears(a, b, (mpfr_ptr)0);
            if (!(wrong <= (double)error.exact))
                fail_msg("%.17g from %.17g by %.17g: %.17g is wrong by %.3g > %.3g", (double)height,
                         (double)first, (double)r, (double)count.exact, wrong, (double)error.exact);
        }
    }
}
