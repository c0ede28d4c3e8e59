/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Proofs that hold for all tilts of a cycle and for all growths in an interval. */
#ifndef DOM_PROOF_COVER_H
#define DOM_PROOF_COVER_H

#pragma GCC visibility push(default) /* precision/shared.awk */
#include "domino_proof.h"
#pragma GCC visibility pop
#include "proof/model/energy.h"
#include <signal.h>

enum outcome {
    OUTCOME_PROVED,  /* the train keeps falling for all growths in the interval */
    OUTCOME_REFUTED, /* the train stops at the upper end of the interval */
    OUTCOME_OPEN,    /* the proof failed; it may succeed for a narrower interval of growths */
    OUTCOME_LIMIT,   /* the proof would need too many dominoes or boxes */
    OUTCOME_INTERRUPTED
};

/* A proof in progress. */
struct proof {
    struct shape shape;
    /* the train for the whole interval of growths, and for the upper end of the interval */
    struct upright box, point;
    struct link *links;   /* memory for the links of `box` and `point` */
    size_t boxes, chains; /* how many boxes have been tried, and how many chains have been computed */
    size_t boxes_most;
    const volatile sig_atomic_t *interrupt;
};

/* Returns false if memory is exhausted. */
bool proof_begin(struct proof *proof, const struct shape *shape);
void proof_end(struct proof *proof);

/* Returns true after an interrupt. Call this often: one pass along a long train takes a few milliseconds. */
bool proof_interrupted(const struct proof *proof);

/* Tries to prove that the train keeps falling for all growths from r_low to r_high, by showing that K > D at
 * every tilt of the cycle. */
enum outcome proof_strip(struct proof *proof, double r_low, double r_high);

/*
 * Tries to prove that the train keeps falling for all growths from *done to r_high. The proof works upwards
 * in strips, which are intervals of growths. After each proved strip, *done is raised to the end of that
 * strip. If the outcome for a strip is OUTCOME_OPEN and the strip is wider than `finest`, the strip is halved
 * and tried again. Any other failure ends the proof and sets *stop to the upper end of the failed strip.
 */
enum outcome proof_range(struct proof *proof, double *done, double r_high, double finest, double *stop);

/*
 * Tries to prove that the train stops for all growths from r_low to r_high. The train stops if it has no
 * fuel, or if its kinetic energy is too small to reach a tilt theta of the cycle. The caller chooses theta
 * and passes `top` = 2 sin(theta/2). If theta exceeds theta_c, theta_c is used instead. Returns false if the
 * proof fails.
 */
bool proof_stops(struct proof *proof, double r_low, double r_high, double top);

/* Tries to prove that D < `level` for all tilts of the cycle, and for all growths from r_low to r_high. */
enum outcome proof_below(struct proof *proof, double r_low, double r_high, double level);

/*
 * Returns an estimate of the margin K - B, where B is the height of the barrier. Sets *top to an estimate of
 * 2 sin(theta/2), where theta is the tilt at the top of the barrier. These estimates prove nothing; they only
 * tell which proof to try. Returns NaN if the train cannot be computed, or after an interrupt.
 */
double proof_guess(struct proof *proof, double r, double *top);

/* Tries to enclose the smallest growth at which the train stops, as dom_prove_rmax says. If the proof remains
 * incomplete (DOM_PROVED_PARTLY), the result is the reason. */
enum outcome limit_prove(struct proof *proof, double tol, struct dom_proof *found);

#endif
