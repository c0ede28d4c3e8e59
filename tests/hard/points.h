/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random trains over the whole parameter space, dense towards its edges. */
#ifndef HARD_POINTS_H
#define HARD_POINTS_H

#include "reference.h"
#include <stdint.h>

domq_real point_rounded(domq_real x, enum dom_precision precision);

/*
 * Returns a random train: 1 - r s down to 1e-15 and r s = 1, r - 1 down to 1e-12 and r = 1, d from 1e-8 to 3,
 * s from 1e-6 to 1, q 3, 4 and from 0.3 to 10; most are trains of a few hundred dominoes, some of thousands.
 * The tilt is 0.
 */
struct ref_input point_random(uint64_t *seed, enum dom_precision precision);

/* Returns a tilt: 0, theta_c, close to either, or between. */
domq_real point_tilt(uint64_t *seed, domq_real theta_c, enum dom_precision precision);

/* Returns true if growths up to the reach are within the precision, and (but for a pair) quickly found from r
 * = 1 on. */
bool point_can_grow(const struct ref_input *input, bool pair, enum dom_precision precision);

#endif
