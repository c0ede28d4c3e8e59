/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What came of many comparisons: the worst of each quantity, and where it was. */
#ifndef HARD_TALLY_H
#define HARD_TALLY_H

#include "library.h"

/* Errors of fewer units are not told apart: finding the scale costs five more references. */
enum { TALLY_UNITS = 2, TALLY_BINS = 2048 };

struct sample {
    struct ref_input input;
    size_t link;
    double tol, got, want;
    double excess; /* error over what was allowed, or in units */
};

struct tally {
    long checked;
    struct sample units; /* the largest error in units of the scale, see reference.h */
    struct sample tol;   /* the largest error over what the tolerance allows */
    struct sample bound; /* the largest error over the library's own bound of it */
    long without_bound;  /* the library gave a value, but no bound */
    long bounds;
    long bin[TALLY_BINS];  /* of log2(bound / error), 16 to an octave */
    long wrong;            /* values or statuses that contradict the reference outright */
    struct sample mistake; /* the first of them */
    char what[80];
};

/* An answer, and what it should have been: as the reference says, or (ref NULL) as given here. */
struct comparison {
    struct ref *ref;
    double want, error, scale;
    const struct ref_input *input;
    enum ref_quantity quantity;
    domq_real got, bound;
    double tol, unit;
    bool sharp; /* tol is the precision's floor: units count */
};

void tally_compare(struct tally *tally, const struct comparison *c);
void tally_mistake(struct tally *tally, const struct comparison *c, const char *what);
void tally_merge(struct tally *into, const struct tally *from);
/* Half of the bounds are closer than this to the errors; NaN if there are none. */
double tally_median(const struct tally *tally);
/* A sample such that one can repeat it. */
void tally_print(const char *label, enum ref_quantity quantity, const struct sample *sample);

#endif
