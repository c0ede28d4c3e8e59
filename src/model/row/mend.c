/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * What saves a row that does not fall: another gap, or a stronger push; how far each gap of a row that falls
 * may be off; and the largest growth of a row. Each is a search for the boundary between rows that fall and
 * rows that do not.
 */
#ifdef DOMQ
#define REAL_QUAD
#endif
#include "numerics/real.h"
#include <stdlib.h>
#include <string.h>

/* The row with one change. After a status other than DOM_OK no row is run, and none counts as falling. */
struct trial {
    struct dom_row row;
    struct dom_compute compute;
    struct dom_domino *domino; /* dominoes of the row, which the search changes */
    size_t k;                  /* index of the domino whose gap is changed, from 0 */
    dom_row_make *make;        /* writes the row of a growth */
    void *context;
    enum dom_status status;
    struct dom_verdict verdict; /* of the last row */
    enum dom_row_end ends;      /* of the last row that did not fall */
};

static struct trial trial_of(const struct dom_row *row, const struct dom_compute *compute)
{
    struct trial t = {.row = *row, .compute = compute ? *compute : dom_compute_default(), .status = DOM_OK};
    t.row.floor = false;
    return t;
}

static bool trial_falls(struct trial *t)
{
    t->verdict.end = DOM_ROW_STOPS;
    if (t->status == DOM_OK)
        t->status = dom_row_run(&t->row, &t->compute, false, NULL, NULL, &t->verdict);
    if (t->verdict.end != DOM_ROW_FALLS)
        t->ends = t->verdict.end;
    return t->status == DOM_OK && t->verdict.end == DOM_ROW_FALLS;
}

typedef bool trial_test(dom_real x, void *trial);

/*
 * Returns the last x found with which the test is true, on the way from `good`, where it is true, to `bad`,
 * where it is not. Halves the distance until it is at most absolute + relative * x, or no number is between.
 * This is bisection, and neither num_root nor a solver of GSL: a test has no values to interpolate, the
 * answer must be a point that was tested, and GSL computes in double alone.
 */
static dom_real edge_find(trial_test *test, struct trial *t, dom_real good, dom_real bad, dom_real absolute,
                          dom_real relative)
{
    while (fabs(good - bad) > absolute + relative * good) {
        dom_real middle = (good + bad) / 2;
        if (middle == good || middle == bad)
            break;
        *(test(middle, t) ? &good : &bad) = middle;
    }
    return good;
}

/* Returns one unit of the first digit of a number, or of the digit that many places after the first. */
static dom_real digit_of(dom_real value, int places)
{
    return pow(10, floor(log10(value)) - (dom_real)places);
}

/* ---- Gaps ---- */

/* Gaps are rounded to this relative size, so that a person can type them. */
#define GAP_DIGITS ((dom_real)1e-6)

enum { STEPS = 40 };

/* Gaps farther back than this do not save a row, which forgets what happened that many dominoes ago. */
enum { BACK = DOM_MENDS - 1 };

static bool falls_with(dom_real gap, void *context)
{
    struct trial *t = context;
    dom_real kept = t->domino[t->k].gap;
    t->domino[t->k].gap = gap;
    bool falls = trial_falls(t);
    t->domino[t->k].gap = kept;
    return falls;
}

/* Finds the last gap with which all fall, between a good gap and a bad one, and rounds it to few digits, away
 * from the bad one. */
static dom_real gap_edge(struct trial *t, dom_real good, dom_real bad)
{
    dom_real digit = digit_of(fmax(good, bad), 0) * GAP_DIGITS;
    good = edge_find(falls_with, t, good, bad, digit / 8, 0);
    dom_real rounded = (good > bad ? ceil(good / digit) : floor(good / digit)) * digit;
    return falls_with(rounded, t) ? rounded : good;
}

/* Returns step i on the way from a gap to `end`: the first steps are short, so that a small change is
 * found. */
static dom_real gap_step(dom_real gap, dom_real end, int i)
{
    dom_real part = (dom_real)i / STEPS;
    return gap + (end - gap) * part * part * part;
}

/* Finds the nearest gap on the way to `end` with which all fall. Returns false if there is none. */
static bool mend_towards(struct trial *t, dom_real end, struct dom_mend *mend)
{
    dom_real gap = t->domino[t->k].gap, bad = gap, good = gap;
    int i = 1;
    while (i <= STEPS && !falls_with(good = gap_step(gap, end, i), t)) {
        bad = good;
        i++;
    }
    if (i > STEPS)
        return false;
    *mend = (struct dom_mend){.domino = t->k + 1, .gap = gap, .to = gap_edge(t, good, bad), .until = end};
    for (i++; i <= STEPS; i++) {
        bad = gap_step(gap, end, i);
        if (!falls_with(bad, t)) {
            mend->until = gap_edge(t, good, bad);
            break;
        }
        good = bad;
    }
    return t->status == DOM_OK;
}

static int by_change(const void *a, const void *b)
{
    const struct dom_mend *x = a, *y = b;
    dom_real dx = fabs(x->to - x->gap), dy = fabs(y->to - y->gap);
    return dx < dy ? -1 : dx > dy;
}

/*
 * Changes gaps, the last of them the one after the domino where the row ends, since gaps after that one do
 * not matter. If that gap is too wide for the domino to reach over, only that gap is changed.
 */
static size_t gaps_search(struct trial *t, const struct dom_verdict *v, dom_progress *progress, void *context,
                          struct dom_mend *mends)
{
    size_t found = 0, last = v->domino < t->row.count ? v->domino : t->row.count - 1, first = 1;
    if (v->end == DOM_ROW_MISSES)
        first = last;
    else if (last > BACK)
        first = last - BACK;
    for (t->k = first; t->k <= last && t->status == DOM_OK; t->k++) {
        struct dom_mend closer, wider;
        bool in = mend_towards(t, 0, &closer), out = mend_towards(t, t->domino[t->k - 1].height, &wider);
        if (in || out)
            mends[found++] = !in || (out && by_change(&wider, &closer) < 0) ? wider : closer;
        if (progress)
            progress(t->k - first + 1, last - first + 1, context);
    }
    qsort(mends, found, sizeof *mends, by_change);
    return found;
}

enum dom_status dom_row_mend(const struct dom_row *row, const struct dom_compute *compute,
                             dom_progress *progress, void *context, struct dom_mend mends[DOM_MENDS],
                             size_t *count)
{
    struct trial t = trial_of(row, compute);
    struct dom_mend found[DOM_MENDS];
    size_t most = 0;
    bool falls = trial_falls(&t);
    const struct dom_verdict verdict = t.verdict;
    if (t.status == DOM_OK && !falls && row->count > 1) {
        t.row.domino = t.domino = malloc(row->count * sizeof *t.domino);
        if (!t.domino)
            return DOM_NO_MEMORY;
        memcpy(t.domino, row->domino, row->count * sizeof *t.domino);
        most = gaps_search(&t, &verdict, progress, context, found);
        free(t.domino);
    }
    if (t.status != DOM_OK)
        return t.status;
    memcpy(mends, found, most * sizeof *mends);
    *count = most;
    return DOM_OK;
}

/* ---- Windows ---- */

/*
 * Finds how far the gap can go towards `end`, and how the row ends just beyond; then goes on to see whether
 * the row falls again farther out.
 */
static dom_real window_edge(struct trial *t, dom_real end, enum dom_row_end *beyond, bool *others)
{
    dom_real gap = t->domino[t->k].gap, edge = end, good = gap;
    bool open = true;
    for (int i = 1; i <= STEPS && !*others && t->status == DOM_OK; i++) {
        dom_real x = gap_step(gap, end, i);
        bool falls = falls_with(x, t);
        if (open && !falls) {
            *beyond = t->ends;
            edge = gap_edge(t, good, x);
            open = false;
        }
        *others = falls && !open;
        good = falls ? x : good;
    }
    /* Rounding to few digits may not take the edge past the gap itself. */
    return end < gap ? fmin(edge, gap) : fmax(edge, gap);
}

/* Finds the window around the gap of a row that falls. */
static void window_around(struct trial *t, struct dom_window *w)
{
    bool below = false, above = false;
    w->above = DOM_ROW_MISSES;
    w->low = window_edge(t, 0, &w->below, &below);
    w->high = window_edge(t, t->domino[t->k - 1].height, &w->above, &above);
    w->others = below || above;
}

/* Finds the nearest window beside the gap of a row that does not fall. */
static void window_beside(struct trial *t, struct dom_window *w)
{
    struct dom_mend closer, wider;
    bool in = mend_towards(t, 0, &closer), out = mend_towards(t, t->domino[t->k - 1].height, &wider);
    if (!in && !out)
        return;
    const struct dom_mend *m = !in || (out && by_change(&wider, &closer) < 0) ? &wider : &closer;
    w->low = fmin(m->to, m->until);
    w->high = fmax(m->to, m->until);
    w->others = in && out;
}

enum dom_status dom_row_windows(const struct dom_row *row, const struct dom_compute *compute,
                                dom_progress *progress, void *context, struct dom_window *windows)
{
    struct trial t = trial_of(row, compute);
    bool falls = trial_falls(&t);
    size_t last = falls ? row->count : t.verdict.domino < row->count ? t.verdict.domino + 1 : row->count;
    if (t.status != DOM_OK || row->count < 2)
        return t.status;
    t.row.domino = t.domino = malloc(row->count * sizeof *t.domino);
    if (!t.domino)
        return DOM_NO_MEMORY;
    memcpy(t.domino, row->domino, row->count * sizeof *t.domino);
    for (t.k = 1; t.k < row->count && t.status == DOM_OK; t.k++) {
        struct dom_window w = {.domino = t.k + 1,
                               .gap = row->domino[t.k].gap,
                               .low = DOM_NAN,
                               .high = DOM_NAN,
                               .below = DOM_ROW_FALLS,
                               .above = DOM_ROW_FALLS};
        if (falls)
            window_around(&t, &w);
        else if (t.k < last) /* what is farther away does not matter to where the row ends */
            window_beside(&t, &w);
        windows[t.k - 1] = w;
        if (progress)
            progress(t.k, row->count - 1, context);
    }
    free(t.domino);
    return t.status;
}

/* ---- A push ---- */

#define PUSH_TOL ((dom_real)1e-4)

static bool falls_pushed(dom_real push, void *context)
{
    struct trial *t = context;
    t->row.push = push;
    return trial_falls(t);
}

/* Returns the push that turns the first domino over its edge: m g (sqrt(h^2 + d^2) - h) / 2 = I omega^2 /
 * 2. */
static dom_real push_over_edge(const struct dom_row *row)
{
    dom_real h = row->domino[0].height, d = row->domino[0].thickness, reach = sqrt(h * h + d * d);
    return sqrt(3 * row->g * d * d / ((reach + h) * reach * reach));
}

enum dom_status dom_row_push(const struct dom_row *row, const struct dom_compute *compute, dom_real strongest,
                             dom_real *push)
{
    struct trial t = trial_of(row, compute);
    if (!(strongest > 0 && (double)strongest < HUGE_VAL))
        return DOM_BAD_PUSH;
    bool falls = trial_falls(&t);
    dom_real found = falls ? row->push : DOM_NAN;
    if (t.status == DOM_OK && !falls) {
        dom_real bad = isnan(row->push) ? 0 : row->push, good = fmax(push_over_edge(row), bad) / 2;
        do {
            good = fmin(2 * good, strongest);
            falls = falls_pushed(good, &t);
            bad = falls ? bad : good;
        } while (!falls && good < strongest && t.status == DOM_OK);
        if (falls && bad < good) {
            good = edge_find(falls_pushed, &t, good, bad, 0, PUSH_TOL);
            /* Rounds up, so that the push is still enough. */
            dom_real digit = digit_of(good, 3), rounded = ceil(good / digit) * digit;
            found = falls_pushed(rounded, &t) ? rounded : good;
        }
    }
    if (t.status == DOM_OK)
        *push = found;
    return t.status;
}

/* ---- The growth ---- */

/* The growth is raised by this factor. Bisection alone is not enough: above the first growth at which a row
 * does not fall there may be others at which it falls. */
#define GROWTH_STEP ((dom_real)1.02)

static bool falls_grown(dom_real r, void *context)
{
    struct trial *t = context;
    if (t->status == DOM_OK)
        t->make(r, t->domino, t->row.count, t->context);
    return trial_falls(t);
}

enum dom_status dom_row_rmax(const struct dom_row *row, const struct dom_compute *compute, dom_real highest,
                             dom_row_make *make, void *context, struct dom_row_growth *growth)
{
    if (row->count == 0)
        return DOM_BAD_COUNT;
    if (!(highest >= 1 && (double)highest < HUGE_VAL))
        return DOM_BAD_R;
    struct trial t = trial_of(row, compute);
    t.make = make;
    t.context = context;
    t.row.domino = t.domino = malloc(row->count * sizeof *t.domino);
    if (!t.domino)
        return DOM_NO_MEMORY;
    dom_real good = 1, bad = 1;
    bool falls = falls_grown(1, &t);
    struct dom_row_growth found = {.r_max = falls ? highest : DOM_NAN, .ends = DOM_ROW_FALLS};
    while (falls && good < highest) {
        bad = fmin(good * GROWTH_STEP, highest);
        falls = falls_grown(bad, &t);
        good = falls ? bad : good;
    }
    if (bad > good)
        found.r_max = edge_find(falls_grown, &t, good, bad, 0, t.compute.tol);
    if (!falls)
        found.ends = t.ends;
    free(t.domino);
    if (t.status == DOM_OK)
        *growth = found;
    return t.status;
}
