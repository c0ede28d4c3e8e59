/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The limits beyond which a number of fallen rows would be unlikely, given the probability that a single row
 * falls. */
#ifndef DOM_INTERVAL_H
#define DOM_INTERVAL_H

#include "numerics/api.h"

/*
 * If `at_least` is true, returns the smallest count such that this many rows or more fall with a probability
 * below 2.5 %, where `share` is the true probability that a single row falls. Otherwise returns the largest
 * count such that this many or fewer fall with a probability below 2.5 %, or -1 if there is none.
 */
double unlikely(double share, double rows, bool at_least);

#endif
