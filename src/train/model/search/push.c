/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Finds the weakest push and the growths at which all dominoes of a row fall. */
#include "search/trial.h"

/* ---- A push ---- */

#define PUSH_TOL 1e-5

static bool falls_pushed(struct trial *t, double push)
{
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
static double push_over_edge(const struct dom_row *row)
{
    double h = row->domino[0].height, d = row->domino[0].thickness, reach = sqrt(h * h + d * d);
    return sqrt(3 * row->g * d * d / ((reach + h) * reach * reach));
}

enum dom_status dom_row_weakest_push(const struct dom_row *row, const struct dom_compute *compute,
                                     double strongest, double *push)
{
    struct trial t = trial_of(row, compute);
    if (!(strongest > 0 && strongest < HUGE_VAL))
        return DOM_BAD_PUSH;
    bool falls = trial_falls(&t);
    double found = falls ? row->push : DOM_NAN;
    if (t.status == DOM_OK && !falls) {
        double bad = isnan(row->push) ? 0 : row->push, good = fmax(push_over_edge(row), bad) / 2;
        do {
            good = fmin(2 * good, strongest);
            falls = falls_pushed(&t, good);
            bad = falls ? bad : good;
        } while (!falls && good < strongest && t.status == DOM_OK);
        if (falls && bad < good) {
            good = trial_edge(&t, falls_pushed, good, &bad, 0, PUSH_TOL);
            /* round up, so that the push is still strong enough */
            const double digit = digit_of(good, 3), rounded = multiple_of(ceil(good / digit), digit);
            found = falls_pushed(&t, rounded) ? rounded : good;
        }
    }
    if (t.status == DOM_OK)
        *push = found;
    return t.status;
}

/* ---- The growth ---- */

/* Each step of the search multiplies the growth by GROWTH_STEP. Because an engine is slow, the search for the
 * first growth at which the row falls in an engine multiplies the growth by GROWTH_STEP_OF_ENGINE instead. */
#define GROWTH_STEP           1.02
#define GROWTH_STEP_OF_ENGINE 1.1

static bool falls_grown(struct trial *t, double r)
{
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
