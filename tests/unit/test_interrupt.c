/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Needs: rows chance planning proof explain */
/*
 * Interrupts, without a clock. The library's check of the flag is replaced by one that counts the checks and
 * raises the flag at the k-th. Every long function must check often, and must end soon after the flag is
 * raised, whatever k is.
 */
#include "domino_proof.h"
#include "domino_study.h"
#include "numerics/interrupt.h"
#include "suite.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static size_t checks, raise_at;
static struct dom_work work;

bool __wrap_dom_interrupted(const volatile sig_atomic_t *flag);
bool __wrap_dom_interrupted(const volatile sig_atomic_t *flag)
{
    (void)flag;
    return ++checks >= raise_at;
}

/* The checks that may follow the one that raises the flag. */
enum { FURTHER = 8 };
enum { ROW = 3 * CHECK_EVERY, RANDOM_ROWS = 24 };

static struct dom_train train;
static struct dom_row row;
static struct dom_domino domino[ROW], other[ROW];
static struct dom_compute compute;

typedef enum dom_status function(void);

/* Defines a function without arguments, which asks the library. */
#define ASKS(name, result, ...)                                                                              \
    static enum dom_status name(void)                                                                        \
    {                                                                                                        \
        static result;                                                                                       \
        return __VA_ARGS__;                                                                                  \
    }

static const struct dom_placement placement = {.error[DOM_ERROR_gap] = {.size = 1e-3}, .rows = RANDOM_ROWS};
static const struct dom_limits limits = {.q = 4, .hall = HUGE_VAL};
static const struct dom_wish wish = {
    .first = 0.05, .height = 1, .safety = 1.1, .hall = HUGE_VAL, .g = 9.81, .push = (double)NAN};

ASKS(rmax, struct dom_limit limit, dom_limit_rmax(&train, &compute, &limit))
ASKS(best, struct dom_best found, dom_limit_best(&train, &compute, &found))
ASKS(barrier, struct dom_barrier found, dom_barrier_find(&train, &compute, &found))
ASKS(duration, double found, dom_cycle_duration(&train, &compute, &found))
ASKS(paper_barrier, struct dom_barrier found, dom_paper_barrier(&train, &compute, &found))
ASKS(least_force, struct dom_least_force found, dom_cycle_least_force(&train, &compute, &found))
ASKS(run, struct dom_verdict verdict, dom_row_run(&row, &compute, true, NULL, NULL, &verdict))
ASKS(windows, struct dom_window window[ROW],
     dom_row_windows(&row, &compute, DOM_WINDOW_GAP, NULL, NULL, window))
ASKS(push, dom_real found, dom_row_weakest_push(&row, &compute, 100, &found))
ASKS(study, struct dom_study found, dom_placement_study(&row, &compute, &placement, &found, NULL))
ASKS(budget, struct dom_budget found,
     dom_placement_budget(&row, &compute, &placement, DOM_ERROR_gap, 0.5, &found))
ASKS(improve, struct dom_study found[2],
     dom_row_improve(&row, &compute, &placement, &limits, NULL, NULL, other, found))
ASKS(design, struct dom_design found, dom_design_find(&train, &wish, NULL, &compute, &found, NULL))

static enum dom_status prove(void)
{
    struct dom_proof proof;
    const enum dom_status status = dom_prove_rmax(&train, &compute, &proof);
    return status == DOM_OK && proof.gap == DOM_PROOF_INTERRUPTED ? DOM_INTERRUPTED : status;
}

/* Calls the function and raises the flag at check number `at`. Returns the number of checks. */
static size_t checks_of(function *f, size_t at, enum dom_status *status)
{
    static volatile sig_atomic_t flag;
    checks = 0;
    raise_at = at;
    memset(&work, 0, sizeof work);
    compute.work = &work;
    compute.interrupt = &flag;
    *status = f();
    return checks;
}

/* Checks that a function ends soon after the flag is raised at each of several checks, but not at the last,
 * after which the answer may be complete. Checks also that the function visits at most CHECK_EVERY dominoes
 * between two checks on average, as far as the work is counted. */
static void ends_soon(const char *name, function *f)
{
    enum dom_status status;
    const size_t all = checks_of(f, SIZE_MAX, &status), dominoes = work.dominoes;
    if (dominoes > CHECK_EVERY * (all + 1))
        fail_msg("%s: %s after %zu dominoes and %zu checks", name, dom_status_text(status), dominoes, all);
    for (size_t i = 0; i <= 12; i++) {
        const size_t at = i < 4 ? 1 + i : all * (i - 3) / 10;
        if (at == 0 || at >= all)
            continue;
        const size_t made = checks_of(f, at, &status);
        if (status != DOM_INTERRUPTED || made > at + FURTHER)
            fail_msg("%s, interrupted at check %zu of %zu: %s after %zu more", name, at, all,
                     dom_status_text(status), made - at);
    }
}
#define ENDS_SOON(f) ends_soon(#f, f)

static void train_set(double s, double r, double mu, double rho)
{
    train = dom_train_default();
    compute = dom_compute_default();
    train.s = s;
    train.r = r;
    train.mu = mu;
    train.rho = rho;
}

static void row_set(size_t count, double r)
{
    const struct dom_scale scale = {.h = 0.05, .g = 9.81};
    train_set(0.3, r, 0, 0);
    row = dom_row_default();
    row.domino = domino;
    row.count = count;
    dom_row_of_train(&train, &scale, 1, domino, count);
}

TEST(trains)
{
    static const struct {
        double s, r, mu, rho;
    } of[] = {{0.4, 1.2, 0, 0}, {1e-4, 2, 0, 0}, {0.4, 1.1, 0.1, 0}, {0.4, 1.2, 0, 0.01}};
    for (size_t i = 0; i < sizeof of / sizeof *of; i++) {
        train_set(of[i].s, of[i].r, of[i].mu, of[i].rho);
        ENDS_SOON(rmax);
        ENDS_SOON(barrier);
        ENDS_SOON(duration);
        ENDS_SOON(least_force);
    }
    train_set(0.4, 1.2, 0, 0);
    ENDS_SOON(best);
    ENDS_SOON(prove);
}

/* Interrupts the search for the best gap of thin dominoes, whose margins dip, at many checks. The sanitizers
 * see whether a function uses what an interrupted one has not computed. */
TEST(a_search_with_dips)
{
    enum dom_status status;
    train_set(0.4, 1, 0, 0);
    train.d = 1e-12;
    const size_t all = checks_of(best, SIZE_MAX, &status);
    if (status != DOM_OK)
        fail_msg("%s", dom_status_text(status));
    for (size_t at = 1; at + 1 < all; at += 1 + all / 60) {
        checks_of(best, at, &status);
        if (status != DOM_INTERRUPTED)
            fail_msg("check %zu of %zu: %s", at, all, dom_status_text(status));
    }
}

TEST(the_recipe_of_the_paper)
{
    train_set(0.4, 1.2, 0, 0);
    compute.tol = 1e-4;
    ENDS_SOON(paper_barrier);
}

TEST(rows)
{
    row_set(40, 1.02);
    domino[20].gap *= 1.1;
    ENDS_SOON(run);
    ENDS_SOON(windows);
    ENDS_SOON(study);
    ENDS_SOON(budget);
    ENDS_SOON(improve);
    domino[20].gap = domino[19].height * 1.01;
    domino[1].gap = 0.001;
    ENDS_SOON(push);
    ENDS_SOON(design);
}

/* Checks that even before the first domino falls, the passes over a long row look at the flag. */
static size_t checks_before;
static bool first_fall(const struct dom_fall *fall, void *context)
{
    (void)fall;
    (void)context;
    checks_before = checks;
    return false;
}

TEST(long_rows_before_the_first_domino_falls)
{
    enum dom_status status;
    struct dom_verdict verdict;
    row_set(ROW, 1);
    domino[ROW / 2].gap *= 1.01; /* not all alike */
    raise_at = SIZE_MAX;
    checks = 0;
    assert_int_equal(dom_row_run(&row, &compute, false, first_fall, NULL, &verdict), DOM_OK);
    assert_true(checks_before > ROW / CHECK_EVERY);
    for (size_t at = 1; at <= 2 * ROW / CHECK_EVERY; at++) {
        function *const functions[] = {run, windows, push, study};
        for (size_t i = 0; i < sizeof functions / sizeof *functions; i++) {
            const size_t made = checks_of(functions[i], at, &status);
            if (status != DOM_INTERRUPTED || made > at + FURTHER)
                fail_msg("function %zu, check %zu: %s, %zu", i, at, dom_status_text(status), made);
        }
    }
}
