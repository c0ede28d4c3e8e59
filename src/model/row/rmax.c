/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The largest growth of a finite row. */
#include "numerics/api.h"
#include "numerics/edge.h"
#include <stdlib.h>

/* The growth rises by this factor.  Bisection alone will not do: above the first growth at which a row does
 * not fall there may be others at which it does. */
#define GROWTH_STEP ((dom_real)1.02)

struct trial {
    struct dom_row row;
    struct dom_compute compute;
    struct dom_domino *domino;
    dom_row_make *make;
    void *context;
    enum dom_status status; /* once it is not DOM_OK no row is run any more */
    enum dom_row_end ends;  /* of the last row that did not fall */
};

static bool falls_at(dom_real r, void *context)
{
    struct trial *t = context;
    struct dom_verdict verdict = {.end = DOM_ROW_STOPS};
    if (t->status != DOM_OK)
        return false;
    t->make(r, t->domino, t->row.count, t->context);
    t->status = dom_row_run(&t->row, &t->compute, false, NULL, NULL, &verdict);
    if (verdict.end != DOM_ROW_FALLS)
        t->ends = verdict.end;
    return verdict.end == DOM_ROW_FALLS;
}

enum dom_status dom_row_rmax(const struct dom_row *row, const struct dom_compute *compute, dom_real highest,
                             dom_row_make *make, void *context, struct dom_row_growth *growth)
{
    if (row->count == 0)
        return DOM_BAD_COUNT;
    if (!(highest >= 1 && (double)highest < HUGE_VAL))
        return DOM_BAD_R;
    struct trial t = {.row = *row,
                      .compute = compute ? *compute : dom_compute_default(),
                      .make = make,
                      .context = context,
                      .status = DOM_OK};
    t.row.domino = t.domino = malloc(row->count * sizeof *t.domino);
    t.row.floor = false;
    if (!t.domino)
        return DOM_NO_MEMORY;
    dom_real good = 1, bad = 1;
    bool falls = falls_at(1, &t);
    struct dom_row_growth found = {.r_max = falls ? highest : DOM_NAN, .ends = DOM_ROW_FALLS};
    while (falls && good < highest) {
        bad = good * GROWTH_STEP < highest ? good * GROWTH_STEP : highest;
        falls = falls_at(bad, &t);
        good = falls ? bad : good;
    }
    if (bad > good)
        found.r_max = edge_find(falls_at, &t, good, bad, 0, t.compute.tol);
    if (!falls)
        found.ends = t.ends;
    free(t.domino);
    if (t.status == DOM_OK)
        *growth = found;
    return t.status;
}
