/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Tells which counts of fallen rows are unlikely, given the probability that a single row falls. */
#ifndef DOM_INTERVAL_H
#define DOM_INTERVAL_H

#include "numerics/api.h"

/*
 * Each of `rows` rows falls with the probability `share`. If `at_least` is true, returns the smallest k with
 * P(at least k rows fall) < 2.5 %. Otherwise returns the largest k with P(at most k rows fall) < 2.5 %, or
 * -1.
 */
double unlikely_count(double share, double rows, bool at_least);

#endif
