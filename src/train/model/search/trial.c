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

/*
 * Neither num_root nor a solver of GSL can be used here, because some tests yield no number, and because the
 * result must be a point that was tested.
 *
 * In general, this is a bisection. If the spare energies at both ends are known, and one is positive and the
 * other negative, every second step uses the secant method instead.
 */
double edge_find(trial_test *test, struct trial *t, double good, double *bad, double digit, double tol)
{
    double of_good = DOM_NAN, of_bad = DOM_NAN, near;
    for (bool halve = true; fabs(good - *bad) > (near = fmax(digit, tol * good)); halve = !halve) {
        const double low = fmin(good, *bad), high = fmax(good, *bad);
        double x = (good + *bad) / 2;
        if (!halve && of_good > 0 && of_bad < 0) {
            x = good + (*bad - good) * (of_good / (of_good - of_bad));
            /* Shift x a little towards the farther end. Without this shift, only the nearer end would
             * approach the edge. */
            x += (fabs(x - good) < fabs(*bad - x)) == (*bad > good) ? near / 2 : -near / 2;
        }
        if (digit > 0)
            x = multiple_of(round(x / digit), digit);
        if (!(x > low && x < high))
            x = digit > 0 ? multiple_of(round((good + *bad) / 2 / digit), digit) : (good + *bad) / 2;
        if (!(x > low && x < high))
            break;
        const bool falls = test(x, t);
        *(falls ? &good : bad) = x;
        *(falls ? &of_good : &of_bad) = t->spare;
    }
    return good;
}
