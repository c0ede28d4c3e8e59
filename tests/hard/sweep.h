/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Compares the library with the reference at random points of the whole parameter space, which are dense near
 * its edges. */
#ifndef HARD_SWEEP_H
#define HARD_SWEEP_H

#include "tally.h"
#include <stdint.h>

/*
 * Returns the share of the points to check: the value of the environment variable SWEEP_SIZE, or 1 if the
 * variable is not set. Ends the program if the value is not in (0, 1].
 */
double sweep_size(void);

struct sweep {
    enum precision precision;
    uint64_t seed;
    int points;
    /*
     * On average, the barrier is checked at one of `barriers` points. `durations` and the others work alike.
     */
    int barriers, durations, growths, pairs;
};

/*
 * Fills one tally for each quantity. Returns the number of points, or -1 if a worker failed. The points and
 * the outcome do not depend on the number of processors.
 */
long sweep_run(const struct sweep *sweep, struct tally tally[REF_COUNT]);

/* Compares some quantities of one train at the smallest tolerance. The list `check` ends with REF_COUNT. */
void sweep_check(const struct ref_input *input, enum precision precision, const enum ref_quantity *check,
                 struct tally tally[REF_COUNT]);

#endif
