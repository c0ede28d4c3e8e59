/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random points over the whole parameter space, dense towards its edges, against the reference. */
#ifndef HARD_SWEEP_H
#define HARD_SWEEP_H

#include "tally.h"
#include <stdint.h>

/*
 * Returns the part of the points to look at, for those in a hurry: SWEEP_SIZE in the environment, in (0, 1];
 * 1 without it.  Ends the program where it is no such number.
 */
double sweep_size(void);

struct sweep {
    enum dom_precision precision;
    uint64_t seed;
    int points;
    /* One point in so many also has: */
    int barriers, durations, growths, pairs;
};

/*
 * Fills one tally a quantity; returns the number of points that were looked at, or -1 if a worker broke
 * down.  Neither the points nor the outcome depend on the number of processors.
 */
long sweep_run(const struct sweep *sweep, struct tally tally[REF_COUNT]);

#endif
