/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "search/edge.h"
#include "numerics/decimal.h"

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
