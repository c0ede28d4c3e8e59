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

/* What is asked of a train: all at its tilt, its barrier and its stop as well, its duration as well; and the
 * limits of growth. */
enum { TILT = 1, TOP = 3, TIME = 7, GROWTH = 8, PAIR = 16 };

/* Asks a train at the smallest tolerance, and compares all answers. */
void sweep_check(const struct ref_input *input, enum precision precision, int asks,
                 struct tally tally[REF_COUNT]);

/* ---- Cases in which naive code is wrong ---- */

/* Stands for the tilt f theta_c, where theta_c comes from the library. */
#define PART_OF_C(f) (-(f))

struct hard_case {
    const char *name;
    double s, r, d, q, tilt;
    int asks;
    bool paper;
    double units; /* allowed error of the library in units (reference.h); 0 means 16 */
};

extern const struct hard_case hard_cases[];
extern const int hard_cases_number;

/* ---- Random trains over the whole parameter space, dense towards its edges ---- */

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
