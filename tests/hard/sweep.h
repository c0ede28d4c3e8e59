/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Compares the library with the reference: in cases in which naive code is wrong, and at random points of the
 * whole parameter space, which are dense near its edges. */
#ifndef HARD_SWEEP_H
#define HARD_SWEEP_H

#include "reference.h"
#include <stdint.h>

/* ---- The results of the library, named as in the reference (library.c) ---- */

struct answers {
    enum dom_status status[REF_COUNT]; /* status of the function that computes the value */
    domq_real value[REF_COUNT];        /* NaN if there is no value */
    domq_real best_s_uncertainty;      /* how far REF_BEST_S may be off, as the library says */
    bool detaches;
    enum dom_end ends; /* what limits the last growth that was found */
    enum dom_status why;
    size_t link, links; /* number of the link, and how many links were visited */
};

struct setup library_train(const struct ref_input *input, enum precision precision);

/* Returns the unit roundoff of the precision. */
double library_unit(enum precision precision);

void library_nothing(struct answers *answers);
/* Calls the function that computes this quantity and stores all quantities of its result. */
void library_ask(const struct setup *setup, domq_real tilt, enum ref_quantity quantity,
                 struct answers *answers);
/* Finds the LINK_... quantities of a domino. */
void library_link(const struct setup *setup, domq_real tilt, size_t link, struct answers *answers);

/* ---- The outcome of many comparisons: the largest error of each quantity, and the input at which it occurs
 * (tally.c) ---- */

/* Errors of fewer than TALLY_UNITS units are not compared with each other, since their scale would take five
 * more references. */
enum { TALLY_UNITS = 2 };

struct sample {
    struct ref_input input;
    size_t link;
    double tol, got, want;
    double excess; /* the error divided by the allowed error, or the error in units */
};

struct tally {
    long checked;
    struct sample units;   /* the largest error in units (reference.h) */
    struct sample tol;     /* the largest error divided by what the tolerance allows */
    long wrong;            /* number of values or statuses that contradict the reference */
    struct sample mistake; /* the first value or status that contradicts the reference */
    char what[80];
};

/* A result of the library, and the right value, which comes from `ref` or, if `ref` is NULL, is `want`. */
struct comparison {
    struct ref *ref;
    double want, error, scale;
    const struct ref_input *input;
    enum ref_quantity quantity;
    domq_real got;
    double tol, unit;
    bool sharp; /* true if tol is the smallest tolerance of the precision, so that units are compared */
};

void tally_compare(struct tally *tally, const struct comparison *c);
void tally_mistake(struct tally *tally, const struct comparison *c, const char *what);
void tally_merge(struct tally *into, const struct tally *from);
/* Prints a sample as a command with which it can be repeated. */
void tally_print(const char *label, enum ref_quantity quantity, const struct sample *sample);

/* ---- Random trains and hard cases ---- */

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
