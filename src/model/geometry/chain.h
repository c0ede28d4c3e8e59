/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The train behind the head at one tilt: the sums over its dominoes (link.h) in their order.
 * It is followed to its end, geometry->n dominoes (c1), or until its tail, bounded by a geometric series, no
 * longer matters at the tolerance.
 */
#ifndef DOM_CHAIN_H
#define DOM_CHAIN_H

#include "geometry/sums.h"
#include "numerics/numerics.h"

/* The sign of H1 alone, right to rounding, from as few dominoes as show it. */
KERNEL enum dom_status chain_sign(const struct geometry *geometry, struct tilt head, real *H1);

/* J and H1. */
KERNEL enum dom_status chain_sum(const struct geometry *geometry, struct tilt head, struct sums *sums);

/* J, H1 and dH; and, where error is not NULL, bounds of their errors (bound.h). */
KERNEL enum dom_status chain_energy_change(const struct geometry *geometry, struct tilt head,
                                           struct sums *sums, struct sums *error);

/* chain_energy_change at theta in [0, theta_c]. */
KERNEL enum dom_status chain_energy_at(const struct geometry *geometry, real theta, struct sums *sums,
                                       struct sums *error);

/* chain_energy_change at theta_c, of an endless train: with every follower where its leader was, one chain
 * serves. */
KERNEL enum dom_status chain_fall(const struct geometry *geometry, struct sums *sums, struct sums *error);

/* The same with H(theta) - H(from), of a train that nobody leaves in between, if from is not upright. */
KERNEL enum dom_status chain_energy_change_from(const struct geometry *geometry, struct tilt from,
                                                struct tilt head, struct sums *sums);

/* The same where the head is `by` farther than `from`, which may be less than what tells the two tilts apart.
 */
KERNEL enum dom_status chain_energy_change_by(const struct geometry *geometry, struct tilt from,
                                              struct tilt head, real by, struct sums *sums);

/* With H2 as well. */
KERNEL enum dom_status chain_second_derivative_from(const struct geometry *geometry, struct tilt from,
                                                    struct tilt head, struct sums *sums);

/*
 * chain_second_derivative_from upright and chain_fall in one pass, where square roots of one chain are taken
 * while those of another wait: of an endless train from which no domino detaches.
 */
KERNEL enum dom_status chain_both(const struct geometry *geometry, struct tilt head, struct sums *sums,
                                  struct sums *fall);

/*
 * The tilt of the head at which one of the dominoes falls off; false where none does within
 * the cycle.  domino, unless NULL, gets its number.  One at most does: the train at theta_c is the train at
 * 0, shifted by one.
 */
KERNEL enum dom_status chain_leave(const struct geometry *geometry, bool *leaves, struct tilt *head,
                                   size_t *domino);

/*
 * The tilts between which a train moves smoothly: edge[0] = 0, where a domino falls off before end, if one
 * does, and end; returns how many in *edges.
 */
enum { CHAIN_EDGES = 3 };
KERNEL enum dom_status chain_edges(const struct geometry *geometry, real end, real edge[CHAIN_EDGES],
                                   int *edges);

/* What a search ends with: the model's own status, if its function failed, else the solver's. */
static inline enum dom_status model_status(enum dom_status own, enum num_status solver)
{
    static const enum dom_status of[] = {
        [NUM_OK] = DOM_OK,
        [NUM_NOT_BRACKETED] = DOM_NOT_CONVERGED,
        [NUM_NOT_FINITE] = DOM_NOT_FINITE,
        [NUM_NOT_CONVERGED] = DOM_NOT_CONVERGED,
        [NUM_NO_MEMORY] = DOM_NO_MEMORY,
    };
    return own != DOM_OK ? own : of[solver];
}

#endif
