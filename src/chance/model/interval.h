/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Tells which counts of fallen rows are unlikely, given the probability that a single row falls. */
#ifndef DOM_INTERVAL_H
#define DOM_INTERVAL_H

#include "numerics/api.h"

/*
 * Each of `rows` rows falls with the probability `share`. This function finds a count of fallen rows that is
 * so large, or so small, that it is unlikely.
 * - If `at_least` is true, returns the smallest k for which P(at least k rows fall) < 2.5 %.
 * - If `at_least` is false, returns the largest k for which P(at most k rows fall) < 2.5 %. If there is none,
 *   returns -1.
 */
double unlikely_count(double share, double rows, bool at_least);

#endif
