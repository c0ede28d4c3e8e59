/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Finds an edge: a value on whose one side all dominoes of a row fall, and on whose other side some do not.
 */
#pragma once

#include "numerics/api.h"

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
