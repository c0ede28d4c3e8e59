/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Finds an edge: a value on whose one side all dominoes of a row fall, and on whose other side some do not.
 */
#pragma once

#include "numerics/api.h"
#include <math.h>

/* ---- Rounding to decimals, so that results are short enough to type ---- */

/* Returns the place value of one digit of `value`. If places = 0, this is the first significant digit. If
 * places = 1, it is the next digit, and so on. For example, digit_of(250, 1) is 10. */
static inline double digit_of(double value, int places)
{
    return pow(10, floor(log10(value)) - (double)places);
}

/* Returns units * step, where `units` is a whole number. If the step is a decimal such as 0.003, the product
 * is the double nearest to the exact product, so it can be written with few digits. */
static inline double multiple_of(double units, double step)
{
    double scale = 1;
    while (fabs(round(step * scale) - step * scale) > 1e-12 * step * scale && scale < 1e22)
        scale *= 10;
    return units * round(step * scale) / scale;
}

/* ---- The search ---- */

/* Tests a value. If a number is known that is positive where the test is true, negative where it is false,
 * and that changes smoothly near the edge, the test may write it to *spare. */
typedef bool edge_test(double x, double *spare, void *context);

/*
 * Searches for the edge between two values. At the value `good`, the test is true, and at the value `bad`, it
 * is false. The search moves these two values closer and closer together, until their distance is at most
 * `tol` times the larger of their sizes. If `digit` > 0, it tries only multiples of `digit`, and stops when
 * none lies between the two values. Returns the last value of `good`, and sets *bad to the last value of
 * `bad`.
 */
double edge_find(edge_test *test, void *context, double good, double *bad, double digit, double tol);

/* Runs a row, unless *status is not DOM_OK. Returns true if all dominoes fall. Sets verdict->spare to the
 * spare energy, as a fraction of the barrier (margin / barrier): of the weakest domino if the row falls, of
 * the domino at which it stops if it stops for lack of energy, and NaN if the fall ends in another way. */
bool row_has_spare(const struct dom_row *row, const struct dom_compute *compute, struct dom_verdict *verdict,
                   enum dom_status *status);
