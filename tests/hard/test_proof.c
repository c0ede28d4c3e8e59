/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Needs: proof */
/*
 * Compares proofs with computed results, for random trains and for the hard cases: r_max is within the proved
 * bounds, a change of r_max in the ninth digit is refuted, and verdicts agree.
 */
#include "../unit/support.h"
#include "domino_proof.h"
#include "sweep.h"

#include <fenv.h>

struct counts {
    int brackets, reaches, none, partly, wrong, refuted;
};

static void say(const char *what, const struct dom_train *t, bool pair, const struct dom_proof *p,
                double r_max)
{
    print_error("%s: s %.17g d %.17g q %.17g fuel %d%s: proved %.17g ... %.17g, computed %.17g\n", what, t->s,
                t->d, t->q, t->fuel, pair ? " pair" : "", p->low, p->high, r_max);
}

/* Returns true if r_max is refuted, because the train keeps falling beyond r_max or stops before it. */
static bool refutes(const struct dom_proof *p, double r_max)
{
    return r_max < p->low * (1 - 1e-15) || r_max > p->high * (1 + 1e-15);
}

/* Compares a computed limit with proved bounds whose relative distance is 1e-10. */
static void compare(const struct setup *setup, bool pair, struct counts *c)
{
    const struct dom_train train = train_in_double((const struct domq_train[]){setup_train(setup)});
    struct dom_compute compute = dom_compute_default();
    struct dom_limit limit;
    struct dom_proof proof;
    compute.tol = 1e-10;
    enum dom_status status = (pair ? dom_limit_pair : dom_limit_rmax)(&train, NULL, &limit);
    if (status != DOM_OK)
        return;
    assert_status((pair ? dom_prove_pair : dom_prove_rmax)(&train, &compute, &proof), DOM_OK);
    c->brackets += proof.ends == DOM_PROVED_BARRIER;
    c->reaches += proof.ends == DOM_PROVED_REACH;
    c->none += proof.ends == DOM_PROVED_NONE;
    c->partly += proof.ends == DOM_PROVED_PARTLY;
    /* A limit close to the reach may be on either side of a bound because of rounding. */
    bool beside = (double)limit.r_max * train.s > 1 - 1e-12;
    bool wrong = limit.ends == DOM_END_NONE ? proof.ends != DOM_PROVED_NONE && !isnan(proof.low) && !pair
                                            : proof.ends == DOM_PROVED_NONE || refutes(&proof, limit.r_max);
    if (limit.ends == DOM_END_BARRIER && !beside)
        wrong = wrong || proof.ends == DOM_PROVED_REACH;
    if (limit.ends == DOM_END_REACH && proof.ends == DOM_PROVED_BARRIER)
        wrong = wrong || proof.high * train.s < 1 - 1e-12;
    if (wrong && ++c->wrong)
        say("outside the proved bounds", &train, pair, &proof, limit.r_max);
    if (proof.ends != DOM_PROVED_BARRIER)
        return;
    double unit = pow(10, floor(log10(limit.r_max)) - 8);
    if (proof.high - proof.low > 0.5 * unit)
        return; /* rounding leaves fewer than nine digits */
    if (refutes(&proof, limit.r_max + unit) && refutes(&proof, limit.r_max - unit))
        c->refuted++;
    else if (++c->wrong)
        say("does not refute", &train, pair, &proof, limit.r_max);
}

static struct setup any_train(uint64_t *seed)
{
    struct setup train = setup_default();
    train.d = random_log(seed, 1e-3, 0.75);
    train.s = random_log(seed, 0.02, 1);
    train.q = random_unit(seed) < 0.5 ? 3 + (random_unit(seed) < 0.5) : random_log(seed, 0.4, 6);
    train.fuel = random_unit(seed) < 0.3 ? DOM_FUEL_PAPER : DOM_FUEL_EXACT;
    return train;
}

TEST(limits_of_random_trains_lie_in_what_is_proved)
{
    uint64_t seed = 2026;
    struct counts c = {0};
    int trains = (int)ceil(200 * sweep_size());
    for (int i = 0; i < trains; i++) {
        struct setup train = any_train(&seed);
        compare(&train, false, &c);
        train.fuel = DOM_FUEL_EXACT;
        compare(&train, true, &c);
    }
    print_message("# %d brackets, %d reaches, %d none, %d in part, %d refute a ninth digit\n", c.brackets,
                  c.reaches, c.none, c.partly, c.refuted);
    assert_int_equal(c.wrong, 0);
    assert_true(c.refuted > trains / 3 && c.partly * 50 <= trains);
}

TEST(limits_of_hard_cases_lie_in_what_is_proved)
{
    struct counts c = {0};
    int step = sweep_size() < 1 ? 4 : 1;
    for (int i = 0; i < hard_cases_number; i += step) {
        const struct hard_case *h = &hard_cases[i];
        struct setup train = setup_default();
        train.s = h->s;
        train.d = h->d;
        train.q = h->q;
        train.fuel = h->paper ? DOM_FUEL_PAPER : DOM_FUEL_EXACT;
        if (h->s >= 0.001)
            compare(&train, false, &c);
    }
    print_message("# %d brackets, %d reaches, %d none, %d in part\n", c.brackets, c.reaches, c.none,
                  c.partly);
    assert_int_equal(c.wrong, 0);
    assert_true(c.brackets + c.reaches + c.none > 3 * c.partly);
}

/* Checks that a proved verdict agrees with the computed one. */
TEST(verdicts_agree)
{
    uint64_t seed = 88;
    /* of fewer trains, too few stop to tell their share */
    int goes = 0, stops = 0, open = 0, wrong = 0, trains = (int)ceil(fmax(150 * sweep_size(), 50));
    for (int i = 0; i < trains; i++) {
        struct setup setup = any_train(&seed);
        setup.r = pow((double)setup.s, -0.8 * random_unit(&seed));
        const struct dom_train train = train_in_double((const struct domq_train[]){setup_train(&setup)});
        struct dom_barrier b;
        struct dom_proof_cycle proof;
        enum dom_status status = dom_barrier_find(&train, NULL, &b);
        assert_status(dom_prove_cycle(&train, NULL, &proof), DOM_OK);
        goes += proof.verdict == DOM_PROVED_GOES_ON;
        stops += proof.verdict == DOM_PROVED_STOPS || proof.verdict == DOM_PROVED_NO_FUEL;
        open += proof.verdict == DOM_PROVED_NOTHING;
        bool agree = proof.verdict == DOM_PROVED_NOTHING ||
                     (proof.verdict == DOM_PROVED_GOES_ON ? status == DOM_OK
                      : proof.verdict == DOM_PROVED_STOPS ? status == DOM_STOPS
                                                          : status == DOM_NO_FUEL);
        /* The computed energies have relative errors of about 1e-12. Apart from these, both intervals contain
         * them. */
        if (status == DOM_OK && proof.verdict == DOM_PROVED_GOES_ON) {
            double slack = 4e-12 * (b.kinetic + b.barrier);
            agree = agree && b.kinetic >= proof.kinetic.low - slack &&
                    b.kinetic <= proof.kinetic.high + slack && b.barrier >= proof.barrier.low - slack &&
                    b.barrier <= proof.barrier.high + slack;
        }
        if (!agree && ++wrong)
            print_error("s %.17g d %.17g q %.17g r %.17g fuel %d: %s, proved %d\n", train.s, train.d, train.q,
                        train.r, train.fuel, dom_status_text(status), proof.verdict);
    }
    print_message("# %d go on, %d stop, %d are open\n", goes, stops, open);
    assert_int_equal(wrong, 0);
    assert_true(goes > trains / 5 && stops > trains / 5 && open * 50 <= trains);
}

/* Checks that an interrupt makes a proof incomplete but is not an error, that wrong parameters are errors,
 * and that the bounds of a number of dominoes are right. */
TEST(gaps_statuses_and_counts)
{
    const volatile sig_atomic_t raised = 1;
    struct dom_train train = dom_train_default(), wrong = train, rubs = train;
    struct dom_compute compute = dom_compute_default();
    struct dom_proof proof;
    struct dom_proof_cycle cycle;
    double least, most;
    compute.interrupt = &raised;
    assert_status(dom_prove_rmax(&train, &compute, &proof), DOM_OK);
    assert_true(proof.ends == DOM_PROVED_PARTLY && proof.gap == DOM_PROOF_INTERRUPTED && isnan(proof.low) &&
                isinf(proof.high));
    assert_status(dom_prove_cycle(&train, &compute, &cycle), DOM_OK);
    assert_true(cycle.verdict == DOM_PROVED_NOTHING && cycle.gap == DOM_PROOF_INTERRUPTED);
    rubs.mu = 0.1;
    assert_status(dom_prove_pair(&rubs, NULL, &proof), DOM_OK);
    assert_true(proof.ends == DOM_PROVED_PARTLY && proof.gap == DOM_PROOF_EFFECT);
    assert_string_equal(dom_proof_gap_text(proof.gap),
                        "there is no proof for trains with effects that change their motion");
    wrong.s = 2;
    assert_status(dom_prove_rmax(&wrong, NULL, &proof), DOM_BAD_S);
    wrong = train;
    wrong.q = NAN;
    assert_status(dom_prove_cycle(&wrong, NULL, &cycle), DOM_BAD_Q);
    compute.tol = 0;
    assert_status(dom_prove_pair(&train, &compute, &proof), DOM_BAD_TOL);

    /* 1.1^2 and 1.21 are equal as decimals, but not as doubles. */
    assert_status(dom_prove_count(1, 1.21, 1.1, &least, &most), DOM_OK);
    assert_true(least == 2 && most == 3);
    assert_status(dom_prove_count(1, 2, 1, &least, &most), DOM_OK);
    assert_true(isinf(least) && isinf(most));
    assert_status(dom_prove_count(0, 2, 2, &least, &most), DOM_BAD_HEIGHT);
    assert_status(dom_prove_count(1, 2, 0.5, &least, &most), DOM_BAD_R);
}

/* Checks that in another rounding mode nothing is proved, that wrong parameters are still errors, and that
 * the mode is not changed. */
TEST(another_rounding_mode_proves_nothing)
{
    static const int modes[] = {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
    for (size_t k = 0; k < sizeof modes / sizeof *modes; k++) {
        struct dom_train train = dom_train_default(), wrong = train;
        struct dom_proof limit[2];
        struct dom_proof_cycle cycle;
        double least, most;
        wrong.s = 2;
        assert_int_equal(fesetround(modes[k]), 0);
        enum dom_status status[] = {dom_prove_rmax(&train, NULL, &limit[0]),
                                    dom_prove_pair(&train, NULL, &limit[1]),
                                    dom_prove_cycle(&train, NULL, &cycle),
                                    dom_prove_count(0.048, 112, 1.5, &least, &most)},
                        bad = dom_prove_rmax(&wrong, NULL, &(struct dom_proof){.low = 0});
        int mode = fegetround();
        fesetround(FE_TONEAREST);
        assert_int_equal(mode, modes[k]);
        for (size_t i = 0; i < sizeof status / sizeof *status; i++)
            assert_status(status[i], DOM_OK);
        for (int i = 0; i < 2; i++)
            assert_true(limit[i].ends == DOM_PROVED_PARTLY && limit[i].gap == DOM_PROOF_MODE &&
                        isnan(limit[i].low) && isinf(limit[i].high));
        assert_true(cycle.verdict == DOM_PROVED_NOTHING && cycle.gap == DOM_PROOF_MODE);
        assert_true(least == 0 && isinf(most));
        assert_status(bad, DOM_BAD_S);
    }
}
