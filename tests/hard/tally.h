/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The outcome of many comparisons: the largest error of each quantity, and its place. */
#ifndef HARD_TALLY_H
#define HARD_TALLY_H

#include "library.h"

/* Errors of fewer units are not distinguished: the scale costs five more references. */
enum { TALLY_UNITS = 2, TALLY_BINS = 2048 };

struct sample {
    struct ref_input input;
    size_t link;
    double tol, got, want;
    double excess; /* error over the allowed error, or in units */
};

struct tally {
    long checked;
    struct sample units; /* the largest error in units of the scale, see reference.h */
    struct sample tol;   /* the largest error over what the tolerance allows */
    struct sample bound; /* the largest error over the library's own bound of it */
    long without_bound;  /* answers that have a value but no bound */
    long bounds;
    long bin[TALLY_BINS];  /* of log2(bound / error), 16 to an octave */
    long wrong;            /* values or statuses that contradict the reference outright */
    struct sample mistake; /* the first of these */
    char what[80];
};

/* An answer, and the right value: from the reference, or (ref NULL) as given here. */
struct comparison {
    struct ref *ref;
    double want, error, scale;
    const struct ref_input *input;
    enum ref_quantity quantity;
    domq_real got, bound;
    double tol, unit;
    bool sharp; /* tol is the smallest of the precision: units count */
};

void tally_compare(struct tally *tally, const struct comparison *c);
void tally_mistake(struct tally *tally, const struct comparison *c, const char *what);
void tally_merge(struct tally *into, const struct tally *from);
/* Returns the median of bound over error; NaN if there are none. */
double tally_median(const struct tally *tally);
/* Prints a sample in a form that can be repeated. */
void tally_print(const char *label, enum ref_quantity quantity, const struct sample *sample);

#endif
