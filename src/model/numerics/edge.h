/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The edge of what is true on one side and false on the other, in the widest arithmetic. */
#ifndef NUM_EDGE_H
#define NUM_EDGE_H

#include "numerics/api.h"

typedef bool edge_test(dom_real x, void *context);

/*
 * Returns the last x found with which the test is true, going from `good`, where it is, towards `bad`, where
 * it is not: halves the distance until it is at most absolute + relative * x, or no number is between.
 *
 * Bisection, and neither num_root nor a solver of GSL: a test has no values to interpolate through, the
 * answer must be a point that was tested, and GSL knows double alone.
 */
dom_real edge_find(edge_test *test, void *context, dom_real good, dom_real bad, dom_real absolute,
                   dom_real relative);

#endif
