/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Needs: rows */
/* Gaps and pushes that mend a row, compared with verdicts for nearby values and with a plain search. */
#include "run.h"
#include "support.h"

/* A change of one gap: the window that is nearest to the gap. */
struct mend {
    size_t domino;
    double gap, to, until;
};
static struct mend mends[ROW_MOST];
static struct dom_window windows[ROW_MOST];

static double change_of(const struct mend *m)
{
    return fabs(m->to - m->gap);
}

/* Lists the changes that mend a row, the smallest first. */
static size_t mend(struct run *run)
{
    size_t count = 0;
    const bool falls = row_end(run) == DOM_ROW_FALLS;
    run->row.domino = run->domino;
    assert_status(ask_row_windows(&run->row, DOM_WINDOW_GAP, NULL, NULL, windows), DOM_OK);
    for (size_t k = 0; k + 1 < run->row.count && !falls; k++) {
        const struct dom_window *w = &windows[k];
        const bool wider = w->now < w->low;
        if (isnan(w->low))
            continue;
        const struct mend found = {w->domino, w->now, wider ? w->low : w->high, wider ? w->high : w->low};
        size_t i = count++;
        for (; i > 0 && change_of(&mends[i - 1]) > change_of(&found); i--)
            mends[i] = mends[i - 1];
        mends[i] = found;
    }
    return count;
}

static bool falls_with(const struct run *run, size_t domino, double gap)
{
    static struct run other;
    other = *run;
    other.domino[domino - 1].gap = gap;
    return row_end(&other) == DOM_ROW_FALLS;
}

static bool falls_pushed(const struct run *run, double push)
{
    static struct run other;
    other = *run;
    other.row.push = push;
    return row_end(&other) == DOM_ROW_FALLS;
}

/* Makes a row of random sizes with one gap that is too wide or too narrow. Most such rows do not fall. */
static void random_row(struct run *run, uint64_t *seed)
{
    size_t count = 3 + (size_t)(6 * random_unit(seed)),
           at = 1 + (size_t)((double)(count - 1) * random_unit(seed));
    make_row(run, count, 0.2 + 0.4 * random_unit(seed), 1.2 + 0.3 * random_unit(seed),
             random_unit(seed) < 0.7 ? 0 : 0.3 * random_unit(seed));
    for (size_t k = 0; k < count; k++) {
        run->domino[k].gap *= 0.8 + 0.4 * random_unit(seed);
        run->domino[k].thickness *= 0.7 + 0.6 * random_unit(seed);
    }
    run->domino[at].gap *= random_unit(seed) < 0.5 ? random_log(seed, 0.02, 0.5) : random_log(seed, 1.5, 4);
    run->row.push *= random_log(seed, 0.6, 4);
    run->row.floor = random_unit(seed) < 0.2; /* changes nothing */
}

/* Tries 500 larger and 500 smaller values for every gap of the row. No value may mend the row with a smaller
 * change than the first mend that was found. */
TEST(no_smaller_change)
{
    enum { FINE = 500 };
    static struct run run;
    uint64_t seed = 83;
    int compared = 0;
    for (int i = 0; i < 40 && compared < 4; i++) {
        random_row(&run, &seed);
        if (row_end(&run) == DOM_ROW_FALLS)
            continue;
        size_t count = mend(&run);
        double least = count ? fabs((double)(mends[0].to - mends[0].gap)) : (double)INFINITY;
        for (size_t k = 1; k < run.row.count; k++)
            for (int up = 0; up < 2; up++) {
                double gap = run.domino[k].gap, end = up ? (double)run.domino[k - 1].height : 0;
                for (int j = 1; j <= FINE && fabs(end - gap) * j / FINE < 0.999 * least; j++)
                    if (falls_with(&run, k + 1, fmax(gap + (end - gap) * j / FINE, 0)))
                        fail_msg("row %d: domino %zu falls with a change of %g, not %g", i, k + 1,
                                 fabs(end - gap) * j / FINE, least);
            }
        compared += count > 0;
    }
    assert_int_equal(compared, 4);
}

/* Checks a long row, in which only the gap after the last domino that is hit and the 30 gaps before it are
 * tried. */
TEST(a_long_row)
{
    static struct run run;
    make_row(&run, 60, 0.3, 1, 0);
    run.domino[49].height *= 3;
    run.domino[49].thickness *= 3;
    run.domino[49].mass *= 200;
    assert_int_equal(row_end(&run), DOM_ROW_STOPS);
    assert_int_equal(run.verdict.domino, 50);
    const size_t count = mend(&run);
    for (size_t j = 0; j < count; j++)
        assert_in_range(mends[j].domino, 51 - 30, 51);
}

/* ---- A push ---- */

/* Checks that a single domino falls with the push that turns it over its edge. */
TEST(over_its_edge)
{
    static struct run run;
    make_row(&run, 1, 0.3, 1, 0);
    double edge = push_over(run.domino);
    double push;
    for (double own = 0; own < 1; own += 0.3) {
        run.row.push = own * edge;
        assert_status(ask_row_weakest_push(&run.row, 100, &push), DOM_OK);
        assert_true(push >= edge * (1 - 1e-12) && push <= 1.002 * edge);
    }
    /* A push stronger than needed is returned unchanged. */
    run.row.push = 2 * edge;
    assert_status(ask_row_weakest_push(&run.row, 100, &push), DOM_OK);
    assert_true(push == (double)run.row.push);
    run.row.push = 0;
    push = 0;
    assert_status(ask_row_weakest_push(&run.row, 0.99 * edge, &push), DOM_OK);
    assert_true(isnan((double)push));
}

/* Checks that all dominoes fall with the weakest push and not with 0.2 % less, even if the first domino
 * touches the second before it tips over its edge. */
TEST(the_weakest_push)
{
    static struct run run;
    uint64_t seed = 84;
    int found = 0, none = 0;
    for (int i = 0; i < 100; i++) {
        random_row(&run, &seed);
        run.row.push = i % 2 ? DOMQ_NAN : 0.3 * push_over(run.domino);
        if (i % 3 == 0)
            run.domino[1].gap = 0.05 * (double)run.domino[0].height;
        if (row_end(&run) == DOM_ROW_FALLS)
            continue;
        double push;
        assert_status(ask_row_weakest_push(&run.row, 1e3, &push), DOM_OK);
        none += isnan((double)push);
        if (isnan((double)push))
            continue;
        assert_true(falls_pushed(&run, push));
        assert_false(falls_pushed(&run, 0.998 * (double)push));
        char digits[32];
        snprintf(digits, sizeof digits, "%.4g", (double)push);
        assert_near("four digits", push, strtod(digits, NULL), 1e-15);
        found++;
    }
    print_message("# %d pushes, %d rows have none\n", found, none);
    assert_true(found > 20 && none > 5);
}
