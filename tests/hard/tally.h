/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The outcome of many comparisons: the largest error of each quantity, and the input at which it occurs. */
#ifndef HARD_TALLY_H
#define HARD_TALLY_H

#include "library.h"

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

#endif
