/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "search/trial.h"

/* Returns the multiple of `digit` that is nearest to x, or x itself if `digit` is 0. */
static double on_digit(double x, double digit)
{
    return digit > 0 ? multiple_of(round(x / digit), digit) : x;
}

/*
 * Neither num_root nor a solver of GSL can be used here, because some tests yield no number, and because the
 * result must be a value that was tested.
 *
 * In general, this is a bisection. If the numbers `spare` at both ends are known, and one is positive and the
 * other negative, every second step uses the secant method instead.
 */
double edge_find(edge_test *test, void *context, double good, double *bad, double digit, double tol)
{
    double of_good = NAN, of_bad = NAN, near;
    for (bool halve = true;; halve = !halve) {
        near = fmax(digit, tol * fmax(fabs(good), fabs(*bad)));
        if (fabs(good - *bad) <= near)
            return good;
        const double low = fmin(good, *bad), high = fmax(good, *bad);
        double x = (good + *bad) / 2, spare = NAN;
        if (!halve && of_good > 0 && of_bad < 0) {
            x = good + (*bad - good) * (of_good / (of_good - of_bad));
            /* Shift x a little towards the farther end. Without this shift, only the nearer end would
             * approach the edge. */
            x += (fabs(x - good) < fabs(*bad - x)) == (*bad > good) ? near / 2 : -near / 2;
        }
        x = on_digit(x, digit);
        if (!(x > low && x < high))
            x = on_digit((good + *bad) / 2, digit);
        if (!(x > low && x < high))
            return good;
        const bool falls = test(x, &spare, context);
        *(falls ? &good : bad) = x;
        *(falls ? &of_good : &of_bad) = spare;
    }
}

struct trial trial_of(const struct dom_row *row, const struct dom_compute *compute)
{
    struct trial t = {.row = *row, .compute = compute_or_default(compute), .status = DOM_OK};
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
