/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Finds the growths at which all dominoes of a row fall. */
#pragma GCC visibility push(default) /* precision/shared.awk */
#include "domino_study.h"
#pragma GCC visibility pop
#include "search/trial.h"

/* Each step of the search multiplies the growth by GROWTH_STEP. Because an engine is slow, the search for the
 * first growth at which the row falls in an engine multiplies the growth by GROWTH_STEP_OF_ENGINE instead. */
#define GROWTH_STEP           1.02
#define GROWTH_STEP_OF_ENGINE 1.1

/* A search for growths. */
struct grown {
    struct trial trial; /* the first member, so that its address is that of the search */
    dom_row_make *make;
    void *context;
};

static bool falls_grown(struct trial *t, double r)
{
    const struct grown *g = (const struct grown *)t;
    if (t->status == DOM_OK)
        g->make(r, t->domino, t->row.count, g->context);
    return trial_falls(t);
}

/*
 * Raises the growth *r step by step. If the row falls at the first growth (`falls` is true), the search ends
 * when the row no longer falls. If `falls` is false, the search ends when the row falls. Sets *before to the
 * growth one step before the last. Returns false if nothing changes up to `highest`. Bisection is not used,
 * because it could miss the first change.
 */
static bool growth_change(struct trial *t, bool falls, double highest, double *before, double *r)
{
    const double step = t->row.engine && !falls ? GROWTH_STEP_OF_ENGINE : GROWTH_STEP;
    while (*r < highest && t->status == DOM_OK) {
        *before = *r;
        *r = fmin(*r * step, highest);
        if (falls_grown(t, *r) != falls)
            return true;
    }
    return false;
}

/* Finds r_min and r_max. The growth r_min is the smallest growth, from 1 upwards, at which the row falls. The
 * row falls at all growths from r_min to r_max. If it does not fall at r = 1, r_min is larger than 1. For
 * example, the gaps at r = 1 can be too narrow for the first domino to tip over. */
static void growths_find(struct trial *t, double highest, struct dom_row_growth *growth)
{
    double before = 1, r = 1;
    bool falls = falls_grown(t, 1);
    *growth = (struct dom_row_growth){DOM_NAN, DOM_NAN, t->ends};
    if (!falls && !growth_change(t, false, highest, &before, &r))
        return;
    growth->r_min = falls ? 1 : trial_edge(t, falls_grown, r, &before, 0, t->compute.tol);
    bool ends = growth_change(t, true, highest, &before, &r);
    growth->r_max = ends ? trial_edge(t, falls_grown, before, &r, 0, t->compute.tol) : highest;
    growth->ends = ends ? t->ends : DOM_ROW_FALLS;
}

enum dom_status dom_row_rmax(const struct dom_row *row, const struct dom_compute *compute, double highest,
                             dom_row_make *make, void *context, struct dom_row_growth *growth)
{
    if (row->count == 0)
        return DOM_BAD_COUNT;
    if (!(highest >= 1 && highest < HUGE_VAL))
        return DOM_BAD_R;
    struct grown g = {trial_of(row, compute), make, context};
    struct trial *t = &g.trial;
    t->row.domino = t->domino = malloc(row->count * sizeof *t->domino);
    if (!t->domino)
        return DOM_NO_MEMORY;
    struct dom_row_growth found;
    growths_find(t, highest, &found);
    free(t->domino);
    if (t->status == DOM_OK)
        *growth = found;
    return t->status;
}
