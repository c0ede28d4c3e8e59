/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Needs: chance */
/* Studies save work: they run only the part of a row that a change affects, and those of random rows leave
 * out the search for the barrier. They are compared here with runs of whole rows, and in test_verdicts for
 * random rows. */

#include "chance/model/verdict.c" // NOLINT(bugprone-suspicious-include)
#include "request.h"
#include "rows/model/windows.c" // NOLINT(bugprone-suspicious-include)
#include "support.h"

static double uniform(uint64_t *seed, double lo, double hi)
{
    return lo + (hi - lo) * random_unit(seed);
}

/* ---- Rows that are run again ---- */

enum { ROW = 24 };

struct random_dominoes {
    struct dom_domino domino[ROW];
    struct dom_row row;
};

/* Makes a row of dominoes whose sizes differ. */
static void dominoes_make(struct random_dominoes *row, uint64_t *seed, double mu)
{
    const double s = uniform(seed, 0.2, 0.6), r = uniform(seed, 1, 1.35);
    double height = 0.05;
    row->row = dom_row_default();
    row->row.domino = row->domino;
    row->row.count = 3 + (size_t)(random_unit(seed) * (ROW - 3));
    row->row.push = uniform(seed, 3, 9);
    row->row.mu = mu;
    for (size_t k = 0; k < ROW; k++, height *= r) {
        struct dom_domino *d = &row->domino[k];
        const double thickness = 0.15 * uniform(seed, 0.7, 1.4);
        *d = (struct dom_domino){.height = height * uniform(seed, 0.97, 1.03)};
        d->thickness = thickness * d->height;
        d->gap = s * d->height * uniform(seed, 0.8, 1.25);
        d->mass = 500 * d->thickness * d->height * d->height * uniform(seed, 0.8, 1.25);
    }
}

/* Changes one property of a domino. */
static void domino_change(struct dom_domino *d, uint64_t *seed)
{
    const double factor = random_unit(seed) < 0.5 ? uniform(seed, 0.6, 1.7) : uniform(seed, 0.99, 1.01);
    double *const measure[] = {&d->gap, &d->mass, &d->height, &d->thickness};
    *measure[(int)(random_unit(seed) * 4)] *= factor;
}

static bool falls_all(const struct dom_row *row)
{
    struct dom_verdict verdict;
    assert_status(dom_row_run(row, NULL, false, NULL, NULL, &verdict), DOM_OK);
    return verdict.end == DOM_ROW_FALLS;
}

/*
 * Makes the last domino almost heavy enough to stop the row, or slightly heavier, so that a small change of a
 * much earlier domino decides how the row ends. If even a light last domino does not fall, the last domino
 * stays light.
 */
static void last_domino_balance(struct random_dominoes *row, uint64_t *seed)
{
    double *mass = &row->domino[row->row.count - 1].mass, light = 1e-3 * *mass, heavy = 1e3 * *mass;
    *mass = light;
    if (!falls_all(&row->row))
        return;
    while (heavy > light * (1 + 1e-9)) {
        *mass = sqrt(light * heavy);
        *(falls_all(&row->row) ? &light : &heavy) = *mass;
    }
    *mass *= 1 + (random_unit(seed) < 0.5 ? 1 : -1) * random_log(seed, 1e-7, 1e-2);
}

/* Checks that a row with one changed domino ends in the same way, whether the whole row is run or only the
 * part that the change can affect. */
TEST(rows_again_end_like_whole_rows)
{
    uint64_t seed = 43;
    int falls = 0, other = 0;
    for (int i = 0; i < 150; i++) {
        static struct random_dominoes row;
        struct dom_domino changed[ROW];
        struct study study = {.mark = NULL};
        struct dom_verdict again, whole;
        dominoes_make(&row, &seed, i % 5 ? 0 : 0.2);
        if (i % 4)
            last_domino_balance(&row, &seed);
        struct dom_row copy = row.row;
        enum dom_status status = study_begin(&study, &copy, NULL);
        const bool falls_before = study.verdict.end == DOM_ROW_FALLS;
        for (int j = 0; j < 20 && status == DOM_OK; j++) {
            const size_t k = (size_t)(random_unit(&seed) * (double)row.row.count);
            memcpy(changed, row.domino, sizeof changed);
            domino_change(&changed[k], &seed);
            copy.domino = changed;
            assert_status(dom_row_run(&copy, NULL, false, NULL, NULL, &whole), DOM_OK);
            assert_status(study_change(&study, &copy, k, k, &again), DOM_OK);
            assert_int_equal(again.end == DOM_ROW_FALLS, whole.end == DOM_ROW_FALLS);
            falls += whole.end == DOM_ROW_FALLS;
            other += (whole.end == DOM_ROW_FALLS) != falls_before;
        }
        row.domino[1].thickness *= -1;
        copy.domino = row.domino;
        assert_status(study_change(&study, &copy, 0, 1, &again), DOM_BAD_THICKNESS);
        row_free(&study.row);
        free(study.mark);
    }
    print_message("# %d rows fall; %d changes also change the verdict\n", falls, other);
    assert_true(falls > 500 && other > 100);
}

/* ---- Heads that certainly keep falling ---- */

/* Checks the next head of a run. With too little energy, the head must not be certain to keep falling. A head
 * that is certain to keep falling must arrive with the energy of a full run. */
static void head_check(const struct run *run, size_t k, int *count)
{
    struct run full = *run, slow = *run, quick = *run;
    struct descent d;
    struct dom_fall fall = {.domino = k + 1};
    struct start at;
    assert_status(row_descend(&full, k, &d, &fall), DOM_OK);
    count[0]++;
    const double need = run->omegasq - d.least_margin / d.J0;
    slow.omegasq = need * (1 - 1e-7);
    assert_false(need > 1e-9 * run->omegasq && head_passes(&slow, k, &at));
    if (!head_passes(&quick, k, &at))
        return;
    count[1]++;
    assert_false(d.stops);
    assert_near("omegasq", at.omegasq, d.st.start.omegasq, 1e-9);
}

TEST(heads_that_keep_falling)
{
    uint64_t seed = 47;
    int count[2] = {0, 0};
    for (int i = 0; i < 150; i++) {
        static struct random_dominoes row;
        struct row begun;
        size_t wrong;
        dominoes_make(&row, &seed, 0);
        row.row.alpha = i % 3 ? 0 : uniform(&seed, -0.05, 0.05);
        assert_status(row_begin(&row.row, NULL, &begun, &wrong), DOM_OK);
        struct quick precise = {.rough = false};
        const struct run_options options = {.context = &precise};
        struct run run = row_launch(&begun, &options);
        for (size_t k = 0; k < row.row.count && run.verdict.end == DOM_ROW_FALLS; k++) {
            struct descent d;
            struct dom_fall fall;
            head_check(&run, k, count);
            assert_status(row_head(&run, k, &d, &fall), DOM_OK);
            if (k + 1 < row.row.count && run.verdict.end == DOM_ROW_FALLS)
                assert_status(row_hit(&run, k, &d.st.geometry, &d.st.start), DOM_OK);
        }
        row_free(&begun);
    }
    print_message("# %d of %d heads certainly keep falling\n", count[1], count[0]);
    assert_true(count[1] > 300 && count[1] > count[0] / 2);
}
