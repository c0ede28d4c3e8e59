/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Finds changes that make all dominoes of a row fall: another gap or a stronger push. Also finds the growths
 * at which all dominoes fall. */
#include "planning/trial.h"

/* ---- Gaps ---- */

/* In addition to the gap at which the fall ends, this many gaps closer to the start of the row are tried.
 * Gaps that are even closer to the start hardly matter. */
enum { BACK = DOM_MENDS - 1 };

/* Searches from the current gap towards `end` for the first gap at which all dominoes fall. */
static bool mend_towards(struct trial *t, dom_real end, struct dom_mend *mend)
{
    *mend = (struct dom_mend){.domino = t->k + 1, .gap = t->domino[t->k].gap};
    return value_towards(t, end, &mend->to, &mend->until);
}

/* A domino cannot reach across a gap that is wider than its height. If the gap is that wide, tries the widest
 * gap within reach, which equals the height of the domino before the gap. If the row falls with that gap,
 * also finds the narrowest gap down to which the row still falls, and returns true. Otherwise returns
 * false. */
static bool mend_in_reach(struct trial *t, struct dom_mend *mend)
{
    dom_real reach = t->domino[t->k - 1].height;
    *mend = (struct dom_mend){.domino = t->k + 1, .gap = t->domino[t->k].gap, .to = reach};
    bool found = mend->gap > reach && falls_with(reach, t);
    if (found)
        mend->until = value_until(t, reach, 0, reach, 1);
    return found && t->status == DOM_OK;
}

static int by_change(const void *a, const void *b)
{
    const struct dom_mend *x = a, *y = b;
    dom_real dx = fabs(x->to - x->gap), dy = fabs(y->to - y->gap);
    return dx < dy ? -1 : dx > dy;
}

/* Finds the smallest change to the gap before domino t->k that makes all dominoes fall. */
static bool gap_mend(struct trial *t, struct dom_mend *mend)
{
    struct dom_mend wider;
    if (mend_in_reach(t, mend))
        return true;
    bool in = mend_towards(t, 0, mend), out = mend_towards(t, t->domino[t->k - 1].height, &wider);
    if (!in || (out && by_change(&wider, mend) < 0))
        *mend = wider;
    return in || out;
}

/* Searches for single gaps whose change makes the row fall. Tries the gap after the domino at which the fall
 * ends, and up to BACK earlier gaps. If the gap after this domino is too wide to reach across, no earlier gap
 * is tried. Returns the number of changes found. */
static size_t gaps_search(struct trial *t, const struct dom_verdict *v, dom_progress *progress, void *context,
                          struct dom_mend *mends)
{
    size_t found = 0, last = v->domino < t->row.count ? v->domino : t->row.count - 1, first = 1;
    if (v->end == DOM_ROW_MISSES)
        first = last;
    else if (last > BACK)
        first = last - BACK;
    for (t->k = first; t->k <= last && t->status == DOM_OK; t->k++) {
        found += gap_mend(t, &mends[found]);
        if (progress)
            progress(t->k - first + 1, last - first + 1, context);
    }
    if (found > 1)
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
    bool falls = trial_begin(&t);
    const struct dom_verdict verdict = t.verdict;
    if (t.status == DOM_OK && !falls && row->count > 1)
        most = gaps_search(&t, &verdict, progress, context, found);
    trial_end(&t);
    if (t.status != DOM_OK)
        return t.status;
    memcpy(mends, found, most * sizeof *mends);
    *count = most;
    return DOM_OK;
}

/* ---- A push ---- */

#define PUSH_TOL ((dom_real)1e-5)

static bool falls_pushed(dom_real push, void *context)
{
    struct trial *t = context;
    t->row.push = push;
    return trial_falls(t);
}

/*
 * Returns the angular velocity omega that is just enough to tip the first domino over its edge, if the domino
 * is a solid block with sharp edges that stands upright on a level floor. The kinetic energy must lift the
 * centre of mass to its highest point above the edge:
 *
 *     I omega^2 / 2 = m g (sqrt(h^2 + d^2) - h) / 2.
 *
 * Here I is the moment of inertia about the edge, m is the mass, h is the height, and d is the thickness.
 */
static dom_real push_over_edge(const struct dom_row *row)
{
    dom_real h = row->domino[0].height, d = row->domino[0].thickness, reach = sqrt(h * h + d * d);
    return sqrt(3 * row->g * d * d / ((reach + h) * reach * reach));
}

enum dom_status dom_row_weakest_push(const struct dom_row *row, const struct dom_compute *compute,
                                     dom_real strongest, dom_real *push)
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
            /* round up, so that the push is still strong enough */
            dom_real digit = digit_of(good, 3), rounded = ceil(good / digit) * digit;
            found = falls_pushed(rounded, &t) ? rounded : good;
        }
    }
    if (t.status == DOM_OK)
        *push = found;
    return t.status;
}

/* ---- The growth ---- */

/* Each step of the search multiplies the growth by GROWTH_STEP. Because an engine is slow, the search for the
 * first growth at which the row falls in an engine multiplies the growth by GROWTH_STEP_OF_ENGINE instead. */
#define GROWTH_STEP           ((dom_real)1.02)
#define GROWTH_STEP_OF_ENGINE ((dom_real)1.1)

static bool falls_grown(dom_real r, void *context)
{
    struct trial *t = context;
    if (t->status == DOM_OK)
        t->make(r, t->domino, t->row.count, t->context);
    return trial_falls(t);
}

/*
 * Raises the growth *r step by step. If the row falls at the first growth (`falls` is true), the search ends
 * when the row no longer falls. If `falls` is false, the search ends when the row falls. Sets *before to the
 * growth one step before the last. Returns false if nothing changes up to `highest`. Bisection is not used,
 * because it could miss the first change.
 */
static bool growth_change(struct trial *t, bool falls, dom_real highest, dom_real *before, dom_real *r)
{
    const dom_real step = t->row.engine && !falls ? GROWTH_STEP_OF_ENGINE : GROWTH_STEP;
    while (*r < highest && t->status == DOM_OK) {
        *before = *r;
        *r = fmin(*r * step, highest);
        if (falls_grown(*r, t) != falls)
            return true;
    }
    return false;
}

/* Finds r_min and r_max. The growth r_min is the smallest growth, from 1 upwards, at which the row falls. The
 * row falls at all growths from r_min to r_max. If it does not fall at r = 1, r_min is larger than 1. For
 * example, the gaps at r = 1 can be too narrow for the first domino to tip over. */
static void growths_find(struct trial *t, dom_real highest, struct dom_row_growth *growth)
{
    dom_real before = 1, r = 1;
    bool falls = falls_grown(1, t);
    *growth = (struct dom_row_growth){DOM_NAN, DOM_NAN, t->ends};
    if (!falls && !growth_change(t, false, highest, &before, &r))
        return;
    growth->r_min = falls ? 1 : edge_find(falls_grown, t, r, before, 0, t->compute.tol);
    bool ends = growth_change(t, true, highest, &before, &r);
    growth->r_max = ends ? edge_find(falls_grown, t, before, r, 0, t->compute.tol) : highest;
    growth->ends = ends ? t->ends : DOM_ROW_FALLS;
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
    struct dom_row_growth found;
    growths_find(&t, highest, &found);
    free(t.domino);
    if (t.status == DOM_OK)
        *growth = found;
    return t.status;
}
