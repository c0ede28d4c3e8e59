/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "search/search.h"
#include "numerics/real.h"

/* ---- An edge ---- */

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

/* ---- A row ---- */

static bool spare_seen(const struct dom_fall *fall, void *context)
{
    *(double *)context = fall->margin / fall->barrier;
    return true;
}

bool row_has_spare(const struct dom_row *row, const struct dom_compute *compute, struct dom_verdict *verdict,
                   enum dom_status *status)
{
    double last = DOM_NAN;
    *verdict = (struct dom_verdict){.end = DOM_ROW_STOPS, .spare = DOM_NAN};
    if (*status == DOM_OK)
        *status = dom_row_run(row, compute, false, spare_seen, &last, verdict);
    if (*status != DOM_OK || verdict->end != DOM_ROW_FALLS)
        verdict->spare = verdict->end == DOM_ROW_STOPS ? last : DOM_NAN;
    return *status == DOM_OK && verdict->end == DOM_ROW_FALLS;
}

/* ---- The weakest push ---- */

#define PUSH_TOL 1e-5

/* The first push that is tried, as a fraction of sqrt(g / h). The next ones are twice as strong: a push that
 * is too weak for domino 1 costs next to nothing. */
#define PUSH_FIRST 1e-3

struct pushed {
    struct dom_row row;
    struct dom_compute compute;
    enum dom_status status;
};

/* An edge_test. */
static bool falls_pushed(double push, double *spare, void *context)
{
    struct pushed *p = context;
    struct dom_verdict verdict;
    p->row.push = push;
    const bool falls = row_has_spare(&p->row, &p->compute, &verdict, &p->status);
    *spare = verdict.spare;
    return falls;
}

enum dom_status dom_row_weakest_push(const struct dom_row *row, const struct dom_compute *compute,
                                     double strongest, double *push)
{
    struct pushed p = {*row, compute_or_default(compute), DOM_OK};
    double found = DOM_NAN, spare;
    if (!(strongest > 0 && strongest < HUGE_VAL))
        return DOM_BAD_PUSH;
    bool falls = falls_pushed(row->push, &spare, &p);
    if (falls)
        found = row->push;
    else if (p.status == DOM_OK) {
        double bad = isnan(row->push) ? 0 : row->push,
               good = fmax(PUSH_FIRST * sqrt(row->g / row->domino[0].height), bad);
        do {
            good = fmin(2 * good, strongest);
            falls = falls_pushed(good, &spare, &p);
            bad = falls ? bad : good;
        } while (!falls && good < strongest && p.status == DOM_OK);
        if (falls && bad < good) {
            good = edge_find(falls_pushed, &p, good, &bad, 0, PUSH_TOL);
            /* round up, so that the push is still strong enough */
            const double digit = digit_of(good, 3), rounded = multiple_of(ceil(good / digit), digit);
            found = falls_pushed(rounded, &spare, &p) ? rounded : good;
        }
    }
    if (p.status == DOM_OK)
        *push = found;
    return p.status;
}
