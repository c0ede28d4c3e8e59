/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Proofs for all tilts of a cycle, and for all growths of an interval. */
#ifndef DOM_PROOF_COVER_H
#define DOM_PROOF_COVER_H

#include "proof/energy.h"
#include <signal.h>

enum outcome {
    OUTCOME_PROVED,  /* the train keeps falling for all growths of the interval */
    OUTCOME_REFUTED, /* the train stops at the upper end of the interval */
    OUTCOME_OPEN,    /* neither could be shown on so wide an interval */
    OUTCOME_LIMIT,   /* the proof would need more dominoes or boxes than are allowed */
    OUTCOME_INTERRUPTED
};

/* A proof in progress. */
struct proof {
    struct shape shape;
    /* the train on the interval of growths, and at the upper end of the interval */
    struct upright box, point;
    struct link *links;   /* memory for the links of both trains */
    size_t boxes, chains; /* the work that the proof has taken so far */
    size_t boxes_most;
    const volatile sig_atomic_t *interrupt;
};

/* proof_begin allocates the memory of a proof, and returns false if memory is exhausted. proof_end frees the
 * memory. */
bool proof_begin(struct proof *proof, const struct shape *shape);
void proof_end(struct proof *proof);

/* Returns true after an interrupt. Every stage then ends soon, since a pass down a long train takes a few
 * milliseconds. */
bool proof_interrupted(const struct proof *proof);

/* Proves that the train keeps falling for every growth from r_low to r_high: K > D for every tilt of the
 * cycle. */
enum outcome proof_strip(struct proof *proof, double r_low, double r_high);

/* Proves that the train keeps falling for all growths from *done to r_high, upwards in strips that are no
 * narrower than `finest`. *done moves up with the proof. Unless the whole interval is proved, *stop is set to
 * the upper end of the strip that failed. */
enum outcome proof_range(struct proof *proof, double *done, double r_high, double finest, double *stop);

/* Proves that the train stops at every growth from r_low to r_high, because at the tilt 2 sin(theta/2) = top
 * its kinetic energy is less than the energy that it needs to reach this tilt. Returns false if that could
 * not be shown. */
bool proof_stops(struct proof *proof, double r_low, double r_high, double top);

/* Proves that D < level for all tilts at all growths of the interval. */
enum outcome proof_below(struct proof *proof, double r_low, double r_high, double level);

/* Returns an estimate of the margin K - B, and sets *top to an estimate of the tilt 2 sin(theta/2) at the
 * top of the barrier. An estimate proves nothing. Returns NaN if numbers are out of range, or after an
 * interrupt. */
double proof_guess(struct proof *proof, double r, double *top);

#endif
