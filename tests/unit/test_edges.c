/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Friction and rows in difficult cases: thin dominoes, r s = 1, and dominoes that touch or that detach during
 * the motion. */
#include "run.h"
#include "support.h"

static struct setup train_of(double s, double r, double d, double q, double mu)
{
    struct setup train = setup_default();
    train.s = s;
    train.r = r;
    train.d = d;
    train.q = q;
    train.mu = mu;
    return train;
}

/*
 * Compares r_max of thin dominoes with quad, which has enough digits in any case, and durations with known
 * values. The barrier is at theta ~ d. Up to there the solution of the flow (dynamics.c) changes by only d^2,
 * and after that by about 1.
 */
TEST(thin_dominoes_with_friction)
{
    for (double d = 1e-8; d < 1e-4; d *= 10) {
        struct setup t = train_of(0.01, 1, d, 4, 0.2);
        struct domq_limit here, finer;
        assert_status(ask_limit_rmax(&t, &here), DOM_OK);
        t.precision = IN_QUAD;
        t.tol = 1e-18;
        assert_status(ask_limit_rmax(&t, &finer), DOM_OK);
        assert_near("r_max", here.r_max, (double)finer.r_max, 1e-10);
    }
    static const struct {
        double d, r, duration;
    } lasts[] = {{1e-5, 15.332157616499686, 18.2693826177},
                 {1e-8, 18.099999466532033, 17.8721020258},
                 {1e-5, 8.9623097869442692, 13.3383189996}};
    for (size_t i = 0; i < sizeof lasts / sizeof *lasts; i++) {
        struct setup t = train_of(0.05, lasts[i].r, lasts[i].d, 4, 0.2);
        domq_real duration;
        assert_status(ask_cycle_duration(&t, &duration), DOM_OK);
        assert_near("duration", duration, lasts[i].duration, 1e-10);
    }
    /* Very little friction changes no verdict. */
    struct setup t = train_of(0.0037017997688205753, 220.24133472332022, 3.0897702704938297e-09, 4, 1e-300);
    struct domq_barrier barrier;
    assert_status(ask_barrier_find(&t, &barrier), DOM_STOPS);
}

/* Checks dominoes that touch, so that they hit each other at once. Without friction nothing locks. */
TEST(touching)
{
    static struct run at, near;
    for (int mu = 0; mu < 2; mu++) {
        alike(&at, 8);
        alike(&near, 8);
        at.row.mu = near.row.mu = (domq_real)mu / 5;
        at.domino[4].gap = 0;
        near.domino[4].gap = 1e-12;
        assert_status(run_whole(&at), DOM_OK);
        assert_status(run_whole(&near), DOM_OK);
        assert_int_equal(at.verdict.end, DOM_ROW_FALLS);
        assert_near("seconds", at.verdict.seconds, (double)near.verdict.seconds, 1e-8);
        assert_near("spare", at.verdict.spare, (double)near.verdict.spare, 1e-8);
    }
}

/* Checks, against Newton's equations, a domino that detaches when a domino after it has already detached. In
 * rows with similar gaps, a search for the barrier once came across both events. */
TEST(one_detaches_after_another)
{
    static const double size[][3] = {/* height, thickness, gap */
                                     {0.195551, 0.0320505, 0},         {0.215106, 0.0269869, 0.0883088},
                                     {0.281467, 0.0641206, 0.0640651}, {0.327719, 0.0796411, 0},
                                     {0.38344, 0.032173, 0.101058},    {0.489495, 0.0710398, 0.132368},
                                     {0.631341, 0.132254, 0.178456},   {0.863787, 0.258808, 0.373084}};
    static struct run seen;
    static struct newton n;
    for (int i = 0; i <= 40; i++) {
        seen.row = row_setup_default(seen.domino, 8, 9.00688);
        for (int k = 0; k < 8; k++) {
            const double *of = size[k];
            seen.domino[k] = (struct domq_domino){of[0], of[1], of[2], of[0] * of[0] * of[1], 0, 0, 0};
        }
        seen.domino[3].gap = 0.224 + 5e-5 * i;
        assert_status(run_whole(&seen), DOM_OK);
        newton_run(&seen, &n);
        newton_compare(&seen, &n);
    }
}

/* ---- Loose tolerances, and results close to 0, for which a shortcut was once wrong ---- */

/* Checks that the tolerance is relative to the fuel, and not to the terms that cancel in the fuel, so that
 * the verdict is right. */
TEST(nearly_no_fuel)
{
    struct setup train = train_of(1.237420463355369e-05, 1, 0.018356095505984882, 3, 0);
    struct domq_barrier barrier;
    struct domq_limit limit;
    train.tol = 1e-3;
    assert_status(ask_barrier_find(&train, &barrier), DOM_STOPS);
    assert_near("kinetic", barrier.kinetic, 2.08e-8, 2e-2);
    train = train_of(0.0012625496548142601, 1, 0.085573654891847373, 4, 0);
    train.tol = 0.1;
    assert_status(ask_limit_rmax(&train, &limit), DOM_OK);
    assert_int_equal(limit.ends, DOM_END_NONE);
}

/* Checks durations of thin dominoes. 1 / omega, which is integrated, has a narrow peak at theta = 0, and two
 * levels of the integration rule once agreed by chance. */
TEST(durations_of_thin_dominoes)
{
    struct setup train = train_of(0.02072704061889355, 11.027200294736572, 1.1351813090041499e-10, 4, 0);
    domq_real duration = DOMQ_NAN;
    train.tol = 0.00781374;
    train.fuel = DOM_FUEL_PAPER;
    assert_status(ask_cycle_duration(&train, &duration), DOM_OK);
    assert_near("duration", duration, 13.0849188, 0.00781374);
    train.tol = 1e-12;
    assert_status(ask_cycle_duration(&train, &duration), DOM_OK);
    assert_near("duration", duration, 13.0849188, 1e-8);
}

/* ---- Trains that cannot grow, the texts of statuses, and physical units ---- */

/* Checks that there is no domino effect for s <= 2 d^3 / (1 - d^2): 0.0063378 for the standard domino. */
TEST(no_fuel_below_a_separation)
{
    struct setup train = setup_default();
    struct domq_limit limit;
    double edge = 2 * pow(train.d, 3) / (1 - train.d * train.d);
    assert_near("edge", edge, 0.0063378, 1e-5);
    train.s = edge * (1 - 1e-9);
    assert_status(ask_limit_rmax(&train, &limit), DOM_OK);
    assert_int_equal(limit.ends, DOM_END_NONE);
    assert_true(isnan(limit.r_max));
    assert_status(limit.why, DOM_NO_FUEL);
    train.s = edge * (1 + 1e-3);
    struct domq_fuels fuels;
    train.r = 1;
    assert_status(ask_fuel_find(&train, &fuels), DOM_OK);
    assert_true(fuels.exact > 0 && fuels.paper > 0);
}

/* Checks d > h: no domino tips over far enough to topple a larger one, at any separation. */
TEST(thick_dominoes_do_not_grow)
{
    struct setup train = setup_default();
    struct domq_best best;
    struct domq_limit limit;
    train.d = 1.5;
    assert_status(ask_limit_best(&train, &best), DOM_NO_GROWTH);
    assert_status(ask_limit_rmax(&train, &limit), DOM_OK);
    assert_int_equal(limit.ends, DOM_END_NONE);
    assert_status(ask_limit_pair(&train, &limit), DOM_OK);
    assert_int_equal(limit.ends, DOM_END_NONE);
}

TEST(every_status_has_a_text)
{
    for (enum dom_status k = DOM_OK; k <= DOM_INTERRUPTED; k++) {
        assert_true(strlen(dom_status_text(k)) > 5);
        for (enum dom_status j = DOM_OK; j < k; j++)
            assert_string_not_equal(dom_status_text(k), dom_status_text(j));
    }
}

TEST(metres_and_seconds)
{
    struct setup train = setup_default();
    struct domq_scale scale = domq_scale_default();
    /* (1; a1) by hand: sqrt((0.048^2 + 0.007^2) / (3 9.81 0.048)) s. */
    double tau = sqrt((0.048 * 0.048 + 0.007 * 0.007) / (3 * 9.81 * 0.048));
    assert_near("tau", domq_scale_tau(&scale, &(struct domq_train){.d = train.d}), tau, 1e-15);
    /* Frictionless equal dominoes of 48 x 7 mm at a pitch of 20 mm run at 1.28427 m/s. */
    domq_real duration;
    train.r = 1;
    train.s = 13.0 / 48;
    assert_status(ask_cycle_duration(&train, &duration), DOM_OK);
    assert_near("speed", ask_scale_speed(&scale, &train, duration), 1.28427, 5e-6);
    /* In a growing train, the front moves in each cycle by the pitch of the next, larger domino. */
    train.r = 1.5;
    assert_near("speed", ask_scale_speed(&scale, &train, 2), 1.5 * 0.020 / (2 * tau), 1e-14);
}
