/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Checks in many bits whether a growth is a limit, that is, whether its margin is 0. */
#ifndef HARD_GROWTH_H
#define HARD_GROWTH_H

#include "reference.h"

/*
 * Returns the difference between r and the growth at which the margin is 0, to first order, and finds the
 * scale of this error. Returns NaN if there is no margin.
 */
double growth_error(const struct ref_input *input, bool pair, int digits2, domq_real r, double *scale);

/* Returns the distance from r to the growth at which the margin is 0, for a margin that is too curved for
 * growth_error. Tries the brackets r +- delta, r +- 4 delta, r +- 16 delta and so on, and then bisects. */
double growth_distance(const struct ref_input *input, bool pair, int digits2, domq_real r, double delta);

/* Returns the margin divided by K + B, or NaN if there is no fuel. */
double growth_margin(const struct ref_input *input, bool pair, int digits2, domq_real r);

#endif
