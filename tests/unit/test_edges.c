/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Friction, rows and studies in difficult cases: thin dominoes, r s = 1, dominoes that detach during the
 * motion, and few rows. */
#include "run.h"
#include "support.h"

static struct asked train_of(double s, double r, double d, double q, double tol)
{
    struct asked train = asked_default();
    train.s = s;
    train.r = r;
    train.d = d;
    train.q = q;
    train.tol = tol;
    return train;
}

static struct asked friction_train(double s, double r, double d, double q, double mu)
{
    struct asked t = train_of(s, r, d, q, (double)asked_default().tol);
    t.mu = mu;
    return t;
}

/*
 * Checks the barrier of a thin domino against quad, which has enough digits in any case. The barrier is d^2
 * high at theta ~ d, and later u changes by 1.
 */
TEST(thin_dominoes_with_friction)
{
    for (double d = 1e-8; d < 1e-4; d *= 10) {
        struct asked t = friction_train(0.01, 1, d, 4, 0.2);
        struct domq_limit here, finer;
        assert_status(ask_limit_rmax(&t, &here, NULL), DOM_OK);
        t.precision = DOM_QUAD;
        t.tol = 1e-18;
        assert_status(ask_limit_rmax(&t, &finer, NULL), DOM_OK);
        assert_near("r_max", here.r_max, (double)finer.r_max, 1e-10);
    }
    static const struct {
        double d, r, duration;
    } lasts[] = {{1e-5, 15.332157616499686, 18.2693826177},
                 {1e-8, 18.099999466532033, 17.8721020258},
                 {1e-5, 8.9623097869442692, 13.3383189996}};
    for (size_t i = 0; i < sizeof lasts / sizeof *lasts; i++) {
        struct asked t = friction_train(0.05, lasts[i].r, lasts[i].d, 4, 0.2);
        domq_real duration;
        assert_status(ask_cycle_duration(&t, &duration, NULL), DOM_OK);
        assert_near("duration", duration, lasts[i].duration, 1e-10);
    }
    /* Very little friction changes no verdict. */
    struct asked t =
        friction_train(0.0037017997688205753, 220.24133472332022, 3.0897702704938297e-09, 4, 1e-300);
    struct domq_barrier barrier;
    assert_status(ask_barrier_find(&t, &barrier, NULL), DOM_STOPS);
}

enum { ROOM = 40 };

static void alike(struct run *seen, size_t count)
{
    for (size_t k = 0; k < count; k++)
        seen->domino[k] =
            (struct domq_domino){.height = 0.048, .thickness = 0.007, .gap = 0.013, .mass = 0.01};
    seen->row = asked_row_default(seen->domino, count, 5);
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

/*
 * Checks, against Newton's equations, a domino that detaches when a domino after it has already detached. The
 * gaps are near one at which a search for the barrier once met both events.
 */
TEST(one_detaches_after_another)
{
    static struct run seen;
    enum { N = 8 };
    static const double height[N] = {0.195551, 0.215106, 0.281467, 0.327719,
                                     0.38344,  0.489495, 0.631341, 0.863787};
    static const double thickness[N] = {0.0320505, 0.0269869, 0.0641206, 0.0796411,
                                        0.032173,  0.0710398, 0.132254,  0.258808};
    double gap[N] = {0, 0.0883088, 0.0640651, 0, 0.101058, 0.132368, 0.178456, 0.373084}, mass[N];
    for (int i = 0; i <= 40; i++) {
        struct direct_hit hits[N];
        struct direct_result result;
        gap[3] = 0.224 + 5e-5 * i;
        for (int k = 0; k < N; k++) {
            mass[k] = height[k] * height[k] * thickness[k];
            seen.domino[k] = (struct domq_domino){height[k], thickness[k], gap[k], mass[k], 0, 0};
        }
        seen.row = asked_row_default(seen.domino, N, 9.00688);
        struct direct_row direct = {N, height, thickness, gap, mass, 0, 9.81, 9.00688, 0, 0, NULL};
        assert_status(run_whole(&seen), DOM_OK);
        assert_null(direct_run(&direct, hits, &result));
        assert_true((seen.verdict.end == DOM_ROW_FALLS) == result.all_fall);
        assert_int_equal(seen.verdict.domino, result.hit);
        for (size_t k = 0; k < result.hit; k++) {
            assert_near("omega", seen.fall[k].omega, hits[k].omega, 1e-9);
            assert_near("kinetic", seen.fall[k].kinetic, hits[k].kinetic, 1e-9);
        }
        if (!result.all_fall)
            assert_near("rest", seen.fall[result.hit - 1].theta, result.stop_theta, 1e-8);
    }
}

/* Checks the verdicts of the simplest rows. */
TEST(ends)
{
    static struct run seen;
    alike(&seen, 6);
    seen.domino[3] = (struct domq_domino){.height = 0.2, .thickness = 0.05, .gap = 0.013, .mass = 1};
    assert_status(run_whole(&seen), DOM_OK);
    assert_int_equal(seen.verdict.end, DOM_ROW_STOPS);
    assert_true(seen.verdict.seconds == seen.fall[3].time);
    /* Without a push the first domino falls from its edge, and needs friction of the floor only from then
     * on. */
    alike(&seen, 2);
    seen.row.push = DOMQ_NAN;
    seen.row.floor = true;
    seen.domino[1].gap = 0.02;
    assert_status(run_whole(&seen), DOM_OK);
    assert_true((double)seen.fall[0].floor_motion > 0 && (double)seen.fall[1].floor_hit > 0);
    alike(&seen, 1);
    seen.row.push = DOMQ_NAN;
    seen.row.floor = true;
    assert_status(run_whole(&seen), DOM_OK);
    assert_true((double)seen.fall[0].floor_motion > 1); /* a rod needs any friction at cos theta = 1/3 */
    /* DOM_ROW_PARTS: none of the dominoes that keep falling has a negative margin. */
    alike(&seen, 6);
    seen.domino[1].gap = 0;
    seen.domino[3].gap = 0.048;
    assert_status(run_whole(&seen), DOM_OK);
    assert_true(!(seen.verdict.spare < 0));
    seen.row.tol = 1e-30;
    assert_status(run_whole(&seen), DOM_BAD_TOL);
}

/* Checks that a domino that is hit at its own hinge cannot stay on the floor. */
TEST(floor_at_the_reach)
{
    struct asked t = friction_train(0.5, 2, 0.1, 3, 0);
    struct domq_floor floor;
    assert_status(ask_cycle_floor(&t, &floor), DOM_OK);
    assert_true(isinf((double)floor.hit) && floor.hit_domino == 0);
}

/* Runs as many studies as the pool says, and then reports an interrupt. */
static enum dom_status few_studies(size_t count, dom_task *task, void *context, void *pool)
{
    int *left = pool;
    if ((*left)-- <= 0)
        return DOM_INTERRUPTED;
    for (size_t i = 0; i < count; i++)
        task(i, context);
    return DOM_OK;
}

/* Checks that an interrupted search returns the bounds that are known, which become closer with each
 * study. */
TEST(budget_interrupted)
{
    struct domq_domino domino[6];
    struct asked train = asked_default();
    const struct domq_scale scale = domq_scale_default();
    train.s = 0.3;
    train.r = 1.3;
    ask_row_of_train(&train, &scale, 0.01, domino, 6);
    const struct asked_row row = asked_row_default(domino, 6, 5);
    struct domq_placement p = {.seed = 5, .rows = 40};
    struct domq_budget whole, part;
    assert_status(ask_placement_budget(&row, &p, DOM_ERROR_gap, 0.9, &whole), DOM_OK);
    p.parallel = few_studies;
    int known = 0, bounded = 0;
    for (int studies = 0; studies < 18; studies++) {
        int left = studies;
        p.pool = &left;
        part = (struct domq_budget){.sigma = -1};
        assert_status(ask_placement_budget(&row, &p, DOM_ERROR_gap, 0.9, &part), DOM_INTERRUPTED);
        if (part.sigma == -1)
            continue;
        assert_true(part.sigma == part.low && part.low <= whole.sigma && whole.sigma <= part.high);
        known++;
        bounded += part.high < 1.5 * part.low;
    }
    print_message("# %d known, %d bounded\n", known, bounded);
    assert_true(known >= 5 && bounded >= 3);
}

/* Checks budgets with too few rows, and for a row that stops even without errors. */
TEST(budgets)
{
    static struct run seen;
    struct domq_budget budget;
    struct domq_placement p = {.seed = 3, .rows = 200};
    alike(&seen, 10);
    assert_status(ask_placement_budget(&seen.row, &p, DOM_ERROR_gap, 0.9999, &budget), DOM_OK);
    assert_true(budget.low == 0 && budget.sigma < budget.high);
    assert_status(ask_placement_budget(&seen.row, &p, DOM_ERROR_gap, 0.8, &budget), DOM_OK);
    assert_true(0 < budget.low && budget.low < budget.sigma && budget.sigma < budget.high);
    /* Run the same rows with the sigma that was found. */
    struct domq_study study;
    p.error[DOM_ERROR_gap].size = budget.sigma;
    assert_status(ask_placement_study(&seen.row, &p, &study, NULL), DOM_OK);
    assert_true(study.fall >= 160 && study.fall <= 161);
    /* If rows fall with a probability of 0.95, then of 200 rows at most 183 fall with a probability below 2.5
     * %, and at least 197 as well. */
    assert_status(ask_placement_budget(&seen.row, &p, DOM_ERROR_gap, 0.95, &budget), DOM_OK);
    p.error[DOM_ERROR_gap].size = budget.low;
    assert_status(ask_placement_study(&seen.row, &p, &study, NULL), DOM_OK);
    assert_in_range(study.fall, 197, 198);
    p.error[DOM_ERROR_gap].size = budget.high;
    assert_status(ask_placement_study(&seen.row, &p, &study, NULL), DOM_OK);
    assert_in_range(study.fall, 183, 184);
    assert_status(ask_placement_budget(&seen.row, &p, DOM_ERROR_gap, 1.5, &budget), DOM_BAD_PROBABILITY);
    seen.row.push = 2; /* too weak a push to tip the domino over its edge */
    assert_status(ask_placement_budget(&seen.row, &p, DOM_ERROR_gap, 0.5, &budget), DOM_STOPS);
}

/* ---- Loose tolerances, and results close to 0, for which a shortcut was once wrong ---- */

/* Checks that the tolerance is relative to the fuel, and not to the terms that cancel in it, so that the
 * verdict is right. */
TEST(nearly_no_fuel)
{
    struct asked train = train_of(1.237420463355369e-05, 1, 0.018356095505984882, 3, 1e-3);
    struct domq_barrier barrier;
    struct domq_limit limit;
    assert_status(ask_barrier_find(&train, &barrier, NULL), DOM_STOPS);
    assert_near("kinetic", barrier.kinetic, 2.08e-8, 2e-2);
    train = train_of(0.0012625496548142601, 1, 0.085573654891847373, 4, 0.1);
    assert_status(ask_limit_rmax(&train, &limit, NULL), DOM_OK);
    assert_int_equal(limit.ends, DOM_END_NONE);
}

/* Checks the durations of thin dominoes, whose slowness has a narrow peak at 0. Two levels of an integration
 * rule once agreed by chance. */
TEST(durations_of_thin_dominoes)
{
    struct asked train =
        train_of(0.02072704061889355, 11.027200294736572, 1.1351813090041499e-10, 4, 0.00781374);
    domq_real duration = DOMQ_NAN, error = DOMQ_NAN;
    train.fuel = DOM_FUEL_PAPER;
    assert_status(ask_cycle_duration(&train, &duration, &error), DOM_OK);
    assert_true(fabs((double)duration - 13.0849188) <= (double)error + 1e-6 && error < 0.1);
    train.tol = 1e-12;
    assert_status(ask_cycle_duration(&train, &duration, &error), DOM_OK);
    assert_near("duration", duration, 13.0849188, 1e-8);
}

TEST(the_reason_is_the_first)
{
    struct asked train = train_of(1, 1, 2.323309142409495e-10, 0.5653832953487673, 1e-12);
    struct domq_best best;
    assert_status(ask_limit_best(&train, &best, NULL), DOM_TOO_LONG);
}

/* Checks that studies of parts add up: how many rows fall, at which dominoes they stop, how many the model
 * cannot decide, and the interval. */
TEST(studies_add_up)
{
    static struct run seen;
    struct domq_study whole, part[2];
    size_t stops[10], stops_part[2][10], stopped = 0;
    struct domq_placement p = {
        .error = {[DOM_ERROR_gap].size = 0.008, [DOM_ERROR_height].size = 0.05}, .seed = 5, .rows = 500};
    alike(&seen, 10);
    assert_status(ask_placement_study(&seen.row, &p, &whole, stops), DOM_OK);
    for (int k = 0; k < 2; k++) {
        p.first = k == 0 ? 0 : 200;
        p.rows = k == 0 ? 200 : 300;
        assert_status(ask_placement_study(&seen.row, &p, &part[k], stops_part[k]), DOM_OK);
    }
    assert_true(whole.fall == part[0].fall + part[1].fall && whole.fall > 0 && whole.fall < 500);
    assert_int_equal(whole.unknown, part[0].unknown + part[1].unknown);
    for (int k = 0; k < 10; k++) {
        assert_int_equal(stops[k], stops_part[0][k] + stops_part[1][k]);
        stopped += stops[k];
    }
    assert_int_equal(stopped + whole.fall + whole.unknown, 500);
    p.seed = 6;
    assert_status(ask_placement_study(&seen.row, &p, &part[0], NULL), DOM_OK);
    assert_true(part[0].fall != part[1].fall);
    /* Without errors all rows are alike. In this row the third domino cannot reach the next one. */
    p = (struct domq_placement){.rows = 50};
    seen.domino[3].gap = 0.05;
    assert_status(run_whole(&seen), DOM_OK);
    assert_int_equal(seen.verdict.end, DOM_ROW_MISSES);
    assert_status(ask_placement_study(&seen.row, &p, &whole, stops), DOM_OK);
    assert_true(seen.verdict.domino == 3 && stops[2] == 50 && whole.fall == 0 && whole.low == 0);
    assert_near("Clopper and Pearson", whole.high, 1 - pow(0.025, 1.0 / 50), 1e-10);
    /* In this row the tip of a domino passes above the next one. */
    alike(&seen, 10);
    seen.domino[3].height *= 0.8;
    assert_status(run_whole(&seen), DOM_OK);
    assert_int_equal(seen.verdict.end, DOM_ROW_PASSES);
    assert_status(ask_placement_study(&seen.row, &p, &whole, stops), DOM_OK);
    assert_true(whole.unknown == 50 && stops[2] == 0 && whole.low == 0 && whole.high == 1);
    alike(&seen, 10);
    assert_status(ask_placement_study(&seen.row, &p, &whole, stops), DOM_OK);
    assert_true(whole.fall == 50 && whole.high == 1);
    assert_near("Clopper and Pearson", whole.low, pow(0.025, 1.0 / 50), 1e-10);
}
