/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Cases in which a search for a limit once failed: dips of the margin, narrow bands, and maxima between two
 * separations. */
#include "support.h"

static struct setup train_of(double s, double d, double q, double mu, enum precision precision)
{
    struct setup train = setup_default();
    train.s = s;
    train.d = d;
    train.q = q;
    train.mu = mu;
    train.precision = precision;
    train.tol = any_arithmetic(precision).tol_default;
    return train;
}

/*
 * Checks the first root against values of 10 digits, which independent programs computed with sums of 30
 * digits. Dips of the margin are narrower than the steps in which r is raised, and a margin that is only
 * slightly below 0 is not visible in float.
 */
TEST(the_first_root_counts)
{
    static const struct {
        double s, d, q, mu, r_max, bound;
        bool paper;
    } cases[] = {
        {0.2, 0.225, 1.045, 0, 3.389170782, 1e-9, false},
        {0.1293, 0.2, 0.65, 0.1, 4.40969, 2e-6, false},
        {0.012128376507914842, 0.0089507755427695561, 1.0982787021882383, 0, 78.7589963324, 1e-11, false},
        {0.97, 0.7, 3, 0, 1.008242542, 1e-9, false},
        {0.89707461069654282, 0.66076923965943846, 1.2165593014670335, 0, 1.0506314420456, 1e-11, false},
        {0.36734999806042479, 0.45929295403908421, 0.32726005034519973, 0, 1.5703902231761672, 1e-11, false},
        {0.38560115946349943, 0.44546286174077077, 0.74467728097552022, 0, 1.6576833795185, 1e-11, true},
        {0.37099426266065866, 0.38699109308628765, 0.98654822402858566, 0, 1.7891406276440615, 1e-11, false},
        {0.096285919065617093, 0.24748533405701234, 0.44528726227386245, 0, 5.0486849610969580, 1e-11, true},
        {0.078117283841271631, 0.00025671705257970269, 3.371739529610752, 0, 12.781762617326, 1e-11, false},
        {0.50140717804106072, 0.50829806206800721, 0.47287566425845079, 0, 1.2805135240214840, 1e-11, false},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct domq_limit limit[2];
        for (int p = 0; p < (cases[i].mu > 0 ? 1 : 2); p++) {
            struct setup train =
                train_of(cases[i].s, cases[i].d, cases[i].q, cases[i].mu, p == 0 ? IN_DOUBLE : IN_QUAD);
            train.fuel = cases[i].paper ? DOM_FUEL_PAPER : DOM_FUEL_EXACT;
            assert_status(ask_limit_rmax(&train, &limit[p]), DOM_OK);
            assert_int_equal(limit[p].ends, DOM_END_BARRIER);
            assert_near("r_max", limit[p].r_max, cases[i].r_max, cases[i].bound);
        }
        if (cases[i].mu == 0)
            assert_near("double and quad", limit[0].r_max, limit[1].r_max, 1e-10);
    }
}

/* Checks bands of growths that begin and end between two samples. Successive samples differ by a factor of
 * e^(1/8). */
TEST(narrow_bands_of_pairs)
{
    static const struct {
        double s, d, q, r_max;
    } cases[] = {
        {0.72, 0.565, 2, 1.10790400424}, {0.66, 0.507, 2.5, 1.09210699}, {0.12, 0.278, 0.5, 6.55740614}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        for (int p = 0; p < 3; p++) {
            struct setup train = train_of(cases[i].s, cases[i].d, cases[i].q, 0, (enum precision)p);
            struct domq_limit limit;
            assert_status(ask_limit_pair(&train, &limit), DOM_OK);
            assert_int_equal(limit.ends, DOM_END_BARRIER);
            assert_near("pair", limit.r_max, cases[i].r_max, p == 0 ? 1e-4 : 5e-9);
        }
}

/* Checks that a pair does not begin at the growth at which domino 1 just tips over. It has no kinetic energy
 * there, and the barrier is positive, even if no digits are left to refine them: at the finest tolerance. */
TEST(a_domino_at_rest_topples_nothing)
{
    static const double d[] = {7.0 / 48, 0.25, 0.5, 1.5};
    for (int p = 0; p < 3; p++)
        for (size_t i = 0; i < sizeof d / sizeof *d; i++)
            for (int k = 0; k < 4; k++) {
                struct setup train = train_of(0.1, d[i], 3, 0, (enum precision)p);
                struct domq_limit limit;
                train.tol = (domq_real)pow(10, k) * any_arithmetic((enum precision)p).tol_floor;
                assert_status(ask_limit_pair(&train, &limit), DOM_OK);
                assert_int_equal(limit.ends, DOM_END_NONE);
            }
    struct setup in_air = train_of(0.0732569, 0.48576, 4, 0, IN_DOUBLE);
    struct domq_limit limit;
    in_air.air = 1.2 / 650;
    assert_status(ask_limit_pair(&in_air, &limit), DOM_OK);
    assert_int_equal(limit.ends, DOM_END_NONE);
}

/*
 * Checks that no separation is better than the best one, neither nearby nor in steps over the whole range,
 * and that r_max there is the growth that was reported. Where s or r_max is known, it is found to tol;
 * samples of r_max alone would give only sqrt(tol).
 */
TEST(no_separation_is_better)
{
    static const struct {
        double d, q, mu, rho, alpha, s, r_max;
        bool paper;
    } cases[] = {
        /* r_max jumps, because a dip touches 0 there; the train passes the dip */
        {0.134101, 0.370576, 0, 0, 0, 0.02760431303202, 34.1206806955, false},
        {0.0124453, 0.522, 0, 0, 0, 0.00274654571703, 364.044522361, false},
        {0.0758594, 0.312005, 0, 0, 0, 0.01063775410219, 92.855140264, false},
        /* smooth maxima */
        {0.014, 3, 0, 0, 0, 0.206532218328, 0, false},
        {0.49, 4, 0, 0, 0, 0.775717721697, 0, false},
        {0.12778554479402274, 2.7824337707394533, 0, 0, 0, 0.39923974909131787, 0, false},
        /* two maxima are close to the same sample s = 0.9^k */
        {0.087418934476537202, 0.69962152853913306, 0, 0, 0, 0, 29.8327373, true},
        /* thick dominoes, which grow only above s = 0.9, if at all */
        {0.665, 3, 0, 0, 0, 0, 0, false},
        {0.705, 3, 0, 0, 0, 0, 0, false},
        {0.745, 3, 0, 0, 0, 0, 0, false},
        /* effects */
        {0.01, 4, 0.05, 0, 0.005, 0, 0, false},
        {0.2, 4, 0.05, 0, 0, 0, 0, false},
        {0.046, 1, 2e-8, 0, 0, 0, 0, false},
        {7 / 48., 3, 0.1, 0.01, 0, 0, 0, false},
        {0.0585, 4, 0.27, 4e-5, 0.02, 0, 0, false},
        {0.052, 1, 0.52, 3e-6, 0, 0, 0, false},
        {0.16, 3, 0, 9e-9, 0, 0, 0, false},
        {0.034825971307705643, 1.6536063293099532, 0.2, 0, 0, 0.12789450551568, 0, false}, /* a kink */
        {0.1, 4, 0, 0.01, -0.02, 0, 0, false},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct setup train = train_of(1, cases[i].d, cases[i].q, cases[i].mu, IN_DOUBLE);
        struct domq_best best;
        struct domq_limit limit;
        train.rho = cases[i].rho;
        train.alpha = cases[i].alpha;
        train.fuel = cases[i].paper ? DOM_FUEL_PAPER : DOM_FUEL_EXACT;
        assert_status(ask_limit_best(&train, &best), DOM_OK);
        assert_true(best.r_max > 1 && (cases[i].d < 0.6 || best.s > 0.9));
        if (cases[i].s > 0)
            assert_near("best s", best.s, cases[i].s, 4e-12);
        if (cases[i].r_max > 0)
            assert_near("best r_max", best.r_max, cases[i].r_max, 1e-8);
        train.s = best.s;
        assert_status(ask_limit_rmax(&train, &limit), DOM_OK);
        assert_near("r_max there", limit.r_max, best.r_max, 1e-11);
        for (int k = -8; k <= 40; k++) {
            train.s = k <= 8 ? (double)best.s * (1 + 5e-4 * k) : 0.031 * (k - 8);
            train.s = fmin((double)train.s, 1 - cases[i].rho);
            assert_status(ask_limit_rmax(&train, &limit), DOM_OK);
            assert_true(!(limit.r_max > best.r_max * (1 + 1e-9)));
        }
    }
}

/* Checks that quad precision adds its digits to the best separation that double precision has found, at a
 * kink and at a smooth top: a search of all separations in quad takes ten times the work. The expected values
 * come from such a complete search. */
TEST(the_best_separation_in_quad_begins_near)
{
    static const struct {
        int mu, rho;        /* in percent */
        double first, rest; /* the first 12 digits of s, and what follows them */
        size_t most;
    } cases[] = {{20, 0, 538644284488, 7.46838654970e-14, 700000},
                 {0, 1, 514185281824, 5.18853554156e-13, 200000}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct setup train = train_of(1, 0, 4, 0, IN_QUAD);
        struct dom_work work = {0};
        struct domq_best best;
        train.d = domq_train_default().d;
        train.mu = (domq_real)cases[i].mu / 100;
        train.rho = (domq_real)cases[i].rho / 100;
        train.tol = (domq_real)1e-20;
        train.work = &work;
        assert_status(ask_limit_best(&train, &best), DOM_OK);
        assert_near("last digits of s", (double)(best.s - (domq_real)cases[i].first / 1000000000000),
                    cases[i].rest, 1e-7);
        assert_true(work.dominoes <= cases[i].most);
    }
}

/* Checks that a search that would take more than the allowed work soon ends with an error, and that thin
 * dominoes with tiny gaps are quick, for which hundreds of thousands of followers matter at r = 1, but only a
 * few at r_max. */
TEST(work)
{
    struct setup endless = train_of(1, 1e-12, 1e-6, 0.57735, IN_DOUBLE),
                 thin = train_of(1e-5, 3e-6, 0.9, 0, IN_DOUBLE);
    struct dom_work work = {0};
    struct domq_best best;
    struct domq_limit limit;
    endless.work = thin.work = &work;
    assert_status(ask_limit_best(&endless, &best), DOM_TOO_LONG);
    assert_true(work.dominoes < 70000000);
    work.dominoes = 0;
    assert_status(ask_limit_rmax(&thin, &limit), DOM_OK);
    assert_true(work.dominoes > 0 && work.dominoes < 1000000);
}
