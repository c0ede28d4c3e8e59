/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random points over the whole parameter space, dense towards its edges, against the reference. */
#ifndef HARD_SWEEP_H
#define HARD_SWEEP_H

#include "tally.h"
#include <stdint.h>

/*
 * Returns the part of the points to check, from SWEEP_SIZE in the environment, in (0, 1]; 1 without that
 * variable. Ends the program if its value is not such a number.
 */
double sweep_size(void);

struct sweep {
    enum dom_precision precision;
    uint64_t seed;
    int points;
    /* One point in this many also has: */
    int barriers, durations, growths, pairs;
};

/*
 * Fills one tally for each quantity. Returns the number of points, or -1 if a worker failed. Neither the
 * points nor the outcome depend on the number of processors.
 */
long sweep_run(const struct sweep *sweep, struct tally tally[REF_COUNT]);

#endif
