/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "search/trial.h"

struct trial trial_of(const struct dom_row *row, const struct dom_compute *compute)
{
    struct trial t = {.row = *row, .compute = compute_or_default(compute), .status = DOM_OK};
    t.row.floor = false;
    return t;
}

static bool trial_judged(struct trial *t)
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

bool trial_begin(struct trial *t)
{
    t->verdict.end = DOM_ROW_STOPS;
    if (t->row.engine)
        (void)trial_falls(t); /* an engine cannot start in the middle of a row */
    else                      /* stores states from which runs of changed rows can start */
        t->status = row_study_begin(&t->row, &t->compute, &t->study, &t->verdict);
    if (t->status == DOM_OK) {
        t->domino = malloc(t->row.count * sizeof *t->domino);
        if (t->domino)
            memcpy(t->domino, t->row.domino, t->row.count * sizeof *t->domino);
        else
            t->status = DOM_NO_MEMORY;
        t->row.domino = t->domino;
    }
    return trial_judged(t);
}

bool trial_again(struct trial *t, size_t first, size_t last)
{
    t->verdict.end = DOM_ROW_STOPS;
    if (t->status == DOM_OK)
        t->status = row_study(t->study, &t->row, first, last, &t->verdict);
    return trial_judged(t);
}

void trial_end(struct trial *t)
{
    row_study_end(t->study);
    free(t->domino);
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
