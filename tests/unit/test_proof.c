/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Needs: proof */
/*
 * Tests each bound of the proofs. The sources of the proofs are compiled with a switch that replaces one
 * bound by a wrong one. If all bounds are right, every check must succeed; if any single bound is wrong, a
 * check must fail.
 */
#include "support.h"

#define BOUNDS(X)                                                                                            \
    X(ROUND_UP)                                                                                              \
    X(ROUND_DOWN)                                                                                            \
    X(SINE)                                                                                                  \
    X(TOP_OF_ONE)                                                                                            \
    X(DETACHED)                                                                                              \
    X(CORNERS)                                                                                               \
    X(CONTRACTION) X(REST_OF_T) X(REST_OF_FUEL) X(REST_OF_HEIGHT) X(MEAN_VALUE_TILT) X(MEAN_VALUE_GROWTH)

enum bound {
    ALL_RIGHT,
#define BOUND_ENUM(name) BREAK_##name,
    BOUNDS(BOUND_ENUM)
};

static enum bound broken;

#define PROOF_BOUND(name, right, wrong) (broken == BREAK_##name ? (wrong) : (right))

/* The interrupt flag of the proofs, which is raised after some number of checks. */
static size_t checks, raise_at = SIZE_MAX;

static bool raised_by_count(const volatile sig_atomic_t *flag)
{
    (void)flag;
    return ++checks >= raise_at;
}

#define dom_interrupted raised_by_count

/* NOLINTBEGIN(bugprone-suspicious-include): the sources themselves, with the switch. */
#include "proof/model/chain.c"
#include "proof/model/prove.c"
/* NOLINTEND(bugprone-suspicious-include) */

/* Returns 1 if a value is outside of the interval, or if a bound is NaN. */
static int outside(struct span a, double value, double slack)
{
    return !(a.lo <= value + slack && a.hi >= value - slack);
}

/* Checks that the bounds of operations enclose the exact result. An fma finds on which side of the exact
 * result a bound is. Fails if the compiler has removed a rounding. tests/hard/test_span.c has every
 * operation. */
static int arithmetic_wrong(void)
{
    uint64_t seed = 1;
    int wrong = 0;
    for (int k = 0; k < 2000; k++) {
        double a = 1 + random_unit(&seed), b = 1 + random_unit(&seed);
        struct span product = span_product(span_of(a), span_of(b)), ratio = span_over(span_of(a), span_of(b)),
                    root = span_sqrt(span_of(a)), sum = span_add(span_of(a), span_of(b * 0x1p-9));
        wrong += fma(a, b, -product.lo) < 0 || fma(a, b, -product.hi) > 0;
        wrong += fma(ratio.lo, b, -a) > 0 || fma(ratio.hi, b, -a) < 0;
        wrong += fma(root.lo, root.lo, -a) > 0 || fma(root.hi, root.hi, -a) < 0;
        wrong += (sum.lo - a) - b * 0x1p-9 > 0 || (sum.hi - a) - b * 0x1p-9 < 0;
        /* A tilt and its sine: x^2 = v (2 - v), exactly. */
        double v = ldexp(floor(ldexp(b - 1, 20)) + 1, -20), exact = v * (2 - v);
        struct span x = tilt_sine(span_of(v));
        wrong += fma(x.lo, x.lo, -exact) > 0 || fma(x.hi, x.hi, -exact) < 0;
    }
    /* 2^0.5, 3^2.75 and 10^0.1 to 20 digits are above the first double and below the second one. */
    const struct {
        double x, q, below;
    } known[] = {
        {2, 0.5, 0x1.6a09e667f3bccp+0}, {3, 2.75, 0x1.483fbf869990ap+4}, {10, 0.1, 0x1.4248ef8fc2603p+0}};
    for (size_t k = 0; k < sizeof known / sizeof *known; k++) {
        const struct span is = power_of(known[k].x, known[k].q);
        wrong += is.lo > known[k].below || is.hi < nextafter(known[k].below, 100);
        wrong += is.hi - is.lo > 1e-14 * is.hi;
    }
    return wrong;
}

/* Compares single trains with values of 25 digits, once with the largest allowed remainders and once with
 * small ones. */
static int points_wrong(struct proof *proof)
{
    int wrong = 0;
    struct csv *csv = csv_open("tests/reference/points.csv");
    while (csv_next(csv)) {
        double s = csv_number(csv, "s"), r = csv_number(csv, "r"), theta = csv_number(csv, "theta"),
               J0 = csv_number(csv, "J0");
        double w[2] = {csv_number(csv, "omega0sq_exact"), csv_number(csv, "omega0sq_paper")},
               P[2] = {csv_number(csv, "fuel_exact"), csv_number(csv, "fuel_paper")},
               sigma = 2 * sin(theta / 2);
        for (int k = 0; k < 8; k++) {
            struct shape shape = shape_make(s, csv_number(csv, "d"), csv_number(csv, "q"));
            struct upright *u = &proof->point;
            shape.paper = k % 2;
            if (!upright_find(&shape, r, r, k < 2 ? 1e-17 : k < 4 ? 1e-9 : k < 6 ? 1e-5 : 1e-2, 0, u))
                return wrong + 1;
            double slack = 4e-16 * (1 + J0);
            struct span D = climb_find(u, sigma, sigma, false).height.value;
            wrong += outside(u->fuel, P[k % 2], slack) + outside(u->T, J0 - 1, slack) +
                     outside(u->kinetic.value, J0 * w[k % 2], slack) +
                     outside(D, csv_number(csv, "dH"), slack);
            if (k < 2 && s >= 0.1)
                wrong += !(u->kinetic.value.hi - u->kinetic.value.lo < 1e-11 && D.hi - D.lo < 1e-11);
        }
    }
    return wrong;
}

/* Checks that the intervals for a box of tilts and growths contain the values at single points of the box,
 * and that the intervals of derivatives contain difference quotients. */
static int boxes_wrong(struct proof *proof, bool paper, bool pair)
{
    uint64_t seed = 7;
    int wrong = 0;
    for (int k = 0; k < 300; k++) {
        double s = 0.05 + 0.9 * random_unit(&seed), d = 0.02 + 0.3 * random_unit(&seed);
        struct shape shape = shape_make(s, d, k % 2 ? 3 : 2 + 2 * random_unit(&seed));
        double r[2], sigma[2], span = pow(10, -4 * random_unit(&seed));
        shape.paper = paper;
        shape.pair = pair;
        r[0] = 1 + (1 / s - 1) * 0.95 * random_unit(&seed);
        r[1] = r[0] + (0.99 / s - r[0]) * span;
        if (r[1] <= r[0] || !upright_find(&shape, r[0], r[1], 1e-6, 0, &proof->box))
            continue;
        double hit = proof->box.hit.lo;
        sigma[0] = hit * random_unit(&seed);
        sigma[1] = sigma[0] + (hit - sigma[0]) * span;
        struct climb box = climb_find(&proof->box, sigma[0], sigma[1], true);
        struct span D[2][2], K[2];
        double K_n[2], D_n[2]; /* the sums over as many dominoes as for the box, without their remainders */
        for (int i = 0; i < 2; i++) {
            if (!upright_find(&shape, r[i], r[i], 0, proof->box.n, &proof->point))
                return wrong + 1;
            K_n[i] = proof->point.kinetic.value.lo;
            D_n[i] = climb_find(&proof->point, sigma[0], sigma[0], false).height.value.hi;
            if (!upright_find(&shape, r[i], r[i], 1e-15, 0, &proof->point))
                return wrong + 1;
            K[i] = proof->point.kinetic.value;
            wrong += !pair && (outside(proof->box.T, proof->point.T.lo, 1e-14) ||
                               outside(proof->box.fuel, span_middle(proof->point.fuel), 1e-14));
            wrong += outside(proof->box.kinetic.value, span_middle(K[i]), 1e-14);
            for (int j = 0; j < 2; j++) {
                D[i][j] = climb_find(&proof->point, sigma[j], sigma[j], false).height.value;
                wrong +=
                    outside(box.height.value, D[i][j].lo, 0) || outside(box.height.value, D[i][j].hi, 1e-14);
            }
        }
        double slack = 2e-14, by_tilt = (span_middle(D[0][1]) - span_middle(D[0][0])) / (sigma[1] - sigma[0]);
        if (sigma[1] - sigma[0] > 1e-6)
            wrong += outside(box.by_tilt, by_tilt, slack / (sigma[1] - sigma[0]));
        double width = r[1] - r[0], by_r = (D_n[1] - D_n[0]) / width;
        if (width > 1e-6) {
            wrong += outside(box.height.by_r, by_r, slack / width);
            wrong += outside(proof->box.kinetic.by_r, (K_n[1] - K_n[0]) / width, slack / width);
        }
    }
    return wrong;
}

/* Returns the number of wrong verdicts. */
static int verdicts_wrong(struct proof *proof)
{
    static const struct {
        double s, d, q, low, high;
        bool pair, goes_on;
    } strip[] = {
        {0.4, 7.0 / 48, 4, 1.65, 1.65, false, false},     {0.4, 7.0 / 48, 4, 1.6, 1.6443, false, false},
        {0.4, 7.0 / 48, 4, 1.5, 1.501, false, true},      {0.53, 7.0 / 48, 3, 1.8866, 1.8866, false, false},
        {0.2, 7.0 / 48, 3, 1.5548, 1.5549, false, false}, {0.1, 7.0 / 48, 3, 1.5, 1.7, true, false},
        {0.1, 7.0 / 48, 0.65, 3.3, 3.6, true, false},
    };
    int wrong = 0;
    for (size_t k = 0; k < sizeof strip / sizeof *strip; k++) {
        proof->shape = shape_make(strip[k].s, strip[k].d, strip[k].q);
        proof->shape.pair = strip[k].pair;
        bool goes_on = strip_prove(proof, strip[k].low, strip[k].high, NULL);
        wrong += goes_on != strip[k].goes_on;
        wrong += strip[k].goes_on && stops_prove(proof, strip[k].low, strip[k].high);
    }
    return wrong;
}

/* Checks that limits from the reference tables are within the proved bounds, to 12 digits. */
static int limits_wrong(const char *path, bool pair)
{
    int wrong = 0;
    struct csv *csv = csv_open(path);
    while (csv_next(csv)) {
        const double r_max = csv_number(csv, "r_max");
        struct dom_train train = dom_train_default();
        train.s = csv_number(csv, "s");
        train.d = pair ? 7.0 / 48 : csv_number(csv, "d");
        train.q = csv_number(csv, "q");
        train.fuel = !pair && strcmp(csv_text(csv, "fuel"), "paper") == 0 ? DOM_FUEL_PAPER : DOM_FUEL_EXACT;
        struct dom_proof limit;
        assert_status(prove_limit(&train, NULL, pair, &limit), DOM_OK);
        const bool reach = strcmp(csv_text(csv, "ends_by"), "reach") == 0;
        wrong += reach ? limit.ends != DOM_PROVED_REACH
                       : limit.ends != DOM_PROVED_BARRIER || !(limit.low <= r_max && r_max <= limit.high) ||
                             limit.high - limit.low > 4e-12 * r_max;
    }
    return wrong;
}

static int all_wrong(struct proof *proof)
{
    int wrong = arithmetic_wrong();
    wrong += points_wrong(proof);
    wrong +=
        boxes_wrong(proof, false, false) + boxes_wrong(proof, true, false) + boxes_wrong(proof, false, true);
    return wrong + verdicts_wrong(proof);
}

static void proof_begin(struct proof *proof)
{
    const struct dom_train train = dom_train_default();
    assert_status(begin(proof, &train, NULL, false), DOM_OK);
}

TEST(every_bound_holds)
{
    struct proof proof;
    proof_begin(&proof);
    assert_int_equal(all_wrong(&proof), 0);
    free(proof.box.link);
}

TEST(limits_of_the_reference_lie_in_what_is_proved)
{
    assert_int_equal(limits_wrong("tests/reference/rmax.csv", false), 0);
    assert_int_equal(limits_wrong("tests/reference/pair.csv", true), 0);
}

/* Checks that at most a few checks follow an interrupt at any moment, and that everything proved by then is
 * true. */
TEST(an_interrupt_ends_every_stage)
{
    static const struct {
        double s, q, r_max;
        bool pair;
    } given[] = {{0.4, 4, 1.6442290395351491, false},
                 {0.3, 3, 1.654207309921, true},
                 {0.1, 0.65, 9.907306223703, true}};
    struct dom_compute compute = dom_compute_default();
    compute.tol = 1e-3;
    for (size_t k = 0; k < sizeof given / sizeof *given; k++) {
        struct dom_train train = dom_train_default();
        struct dom_proof limit;
        train.s = given[k].s;
        train.d = 7.0 / 48;
        train.q = given[k].q;
        checks = 0;
        assert_status(prove_limit(&train, &compute, given[k].pair, &limit), DOM_OK);
        const size_t in_all = checks;
        assert_true(limit.ends != DOM_PROVED_PARTLY && in_all > 300);
        for (raise_at = 1; raise_at <= in_all; raise_at += 1 + in_all / 499) {
            checks = 0;
            assert_status(prove_limit(&train, &compute, given[k].pair, &limit), DOM_OK);
            assert_true(limit.ends != DOM_PROVED_PARTLY || limit.gap == DOM_PROOF_INTERRUPTED);
            assert_true(isnan(limit.low) || limit.low <= given[k].r_max);
            assert_true(limit.high >= given[k].r_max);
            assert_true(checks <= raise_at + 12);
        }
        raise_at = SIZE_MAX;
    }
}

TEST(each_wrong_bound_is_noticed)
{
    static const char *const name[] = {"none",
#define BOUND_NAME(name) #name,
                                       BOUNDS(BOUND_NAME)};
    struct proof proof;
    int missed = 0;
    proof_begin(&proof);
    for (int k = 1; k < (int)(sizeof name / sizeof *name); k++) {
        broken = (enum bound)k;
        int wrong = all_wrong(&proof);
        if (wrong == 0)
            print_error("%s is wrong, and nothing notices\n", name[k]);
        missed += wrong == 0;
    }
    broken = ALL_RIGHT;
    free(proof.box.link);
    assert_int_equal(missed, 0);
}
