/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Needs: chance */
/* Studies of rows with random errors, and the largest errors with which enough of the rows fall. */
#include "run.h"
#include "support.h"

/* Checks the budget of a row, also with too few rows for the probability, and the budget of a row that stops
 * even without errors. */
TEST(budgets)
{
    static struct run seen;
    struct dom_budget budget;
    struct dom_placement p = {.seed = 3, .rows = 200};
    alike(&seen, 10);
    assert_status(ask_placement_budget(&seen.row, &p, DOM_ERROR_gap, 0.9999, &budget), DOM_OK);
    assert_true(budget.low == 0 && budget.sigma < budget.high);
    assert_status(ask_placement_budget(&seen.row, &p, DOM_ERROR_gap, 0.8, &budget), DOM_OK);
    assert_true(0 < budget.low && budget.low < budget.sigma && budget.sigma < budget.high);
    /* Run the same rows with the sigma that was found. */
    struct dom_study study;
    p.error[DOM_ERROR_gap].size = budget.sigma;
    assert_status(ask_placement_study(&seen.row, &p, &study, NULL), DOM_OK);
    assert_true(study.fall >= 160 && study.fall <= 161);
    /* If each of 200 rows falls with a probability of 0.95, the probability that at most 183 of them fall is
     * below 2.5 %. The probability that at least 197 fall is below 2.5 %, too. */
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

/* Checks that studies of parts add up: how many rows fall, at which dominoes they stop, how many the model
 * cannot decide, and the interval. */
TEST(studies_add_up)
{
    static struct run seen;
    struct dom_study whole, part[2];
    size_t stops[10], stops_part[2][10], stopped = 0;
    struct dom_placement p = {
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
    p = (struct dom_placement){.rows = 50};
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
