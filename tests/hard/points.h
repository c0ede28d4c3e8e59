/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random trains over the whole parameter space, dense towards its edges. */
#ifndef HARD_POINTS_H
#define HARD_POINTS_H

#include "reference.h"
#include <stdint.h>

domq_real point_rounded(domq_real x, enum precision precision);

/*
 * Returns a random train with the tilt 0. 1 - r s is 0 or at least 1e-15, r - 1 is 0 or at least 1e-12, d is
 * between 1e-8 and 3, s is between 1e-6 and 1, and q is 3, 4 or any number between 0.3 and 10. In most trains
 * a few hundred dominoes matter, in some trains thousands.
 */
struct ref_input point_random(uint64_t *seed, enum precision precision);

/* Returns a tilt: 0, theta_c, a tilt close to one of these two, or a tilt between them. */
domq_real point_tilt(uint64_t *seed, domq_real theta_c, enum precision precision);

/* Returns true if growths up to the reach are within the range of the precision and, unless `pair` is set,
 * can be searched quickly from r = 1 on. */
bool point_can_grow(const struct ref_input *input, bool pair, enum precision precision);

#endif
