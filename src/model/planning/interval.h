/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The interval of a probability, from counts of rows. */
#ifndef DOM_INTERVAL_H
#define DOM_INTERVAL_H

#include "numerics/api.h"

/*
 * Returns the first count that chance hardly explains if the share is the true probability: that so many rows
 * or more fall, or so many or fewer, has a probability below 2.5 %.
 */
double unlikely(double share, double rows, bool at_least);

#endif
