/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "search/trial.h"

struct trial trial_of(const struct dom_row *row, const struct dom_compute *compute)
{
    struct trial t = {.row = *row, .compute = compute_or_default(compute), .status = DOM_OK};
    t.row.floor = false;
    return t;
}

bool trial_judged(struct trial *t)
{
    const bool falls = t->status == DOM_OK && t->verdict.end == DOM_ROW_FALLS;
    if (t->verdict.end != DOM_ROW_FALLS)
        t->ends = t->verdict.end;
    t->spare = falls || t->verdict.end == DOM_ROW_STOPS ? t->verdict.spare : DOM_NAN;
    return falls;
}

static bool spare_seen(const struct dom_fall *fall, void *context)
{
    *(double *)context = fall->margin / fall->barrier;
    return true;
}

bool trial_falls(struct trial *t)
{
    double last = DOM_NAN;
    t->verdict.end = DOM_ROW_STOPS;
    if (t->status == DOM_OK)
        t->status = dom_row_run(&t->row, &t->compute, false, spare_seen, &last, &t->verdict);
    if (t->status == DOM_OK && t->verdict.end == DOM_ROW_STOPS)
        t->verdict.spare = last;
    return trial_judged(t);
}

/* A trial_test and its trial. */
struct tested {
    struct trial *trial;
    trial_test *test;
};

static bool trial_tested(double x, double *spare, void *context)
{
    const struct tested *tested = context;
    const bool falls = tested->test(tested->trial, x);
    *spare = tested->trial->spare;
    return falls;
}

double trial_edge(struct trial *t, trial_test *test, double good, double *bad, double digit, double tol)
{
    return edge_find(trial_tested, &(struct tested){t, test}, good, bad, digit, tol);
}
