/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The followers of the head at one tilt: the sums over all dominoes (link.h) in their order. The train is
 * followed to its end, geometry->n dominoes (19; c1), or until its tail, bounded by a geometric series, no
 * longer matters at the tolerance.
 */
#ifndef DOM_CHAIN_H
#define DOM_CHAIN_H

#include "geometry/sums.h"
#include "numerics/numerics.h"

/* Finds the sign of H1 alone, right to rounding, from as few dominoes as the sign needs. */
KERNEL enum dom_status chain_sign(const struct geometry *geometry, struct tilt head, real *H1);

/* Finds J and H1. */
KERNEL enum dom_status chain_sum(const struct geometry *geometry, struct tilt head, struct sums *sums);

/* Finds J, H1 and dH, and bounds of their errors (bound.h) unless error is NULL. With rounded edges no bounds
 * are known: error is not written. */
KERNEL enum dom_status chain_energy_change(const struct geometry *geometry, struct tilt head,
                                           struct sums *sums, struct sums *error);

/* Calls chain_energy_change at theta in [0, theta_c]. */
KERNEL enum dom_status chain_energy_at(const struct geometry *geometry, real theta, struct sums *sums,
                                       struct sums *error);

/* Calls chain_energy_change at theta_c, of an endless train: every follower is where its leader was (32; A7),
 * so one chain is enough. */
KERNEL enum dom_status chain_fall(const struct geometry *geometry, struct sums *sums, struct sums *error);

/* Finds J, H1 and H(theta) - H(from). If `from` is not upright, no domino may detach between the two
 * tilts. */
KERNEL enum dom_status chain_energy_change_from(const struct geometry *geometry, struct tilt from,
                                                struct tilt head, struct sums *sums);

/* Finds the same sums, and whether all contacts surely push at all tilts from `from` to `head`, at every
 * speed. */
KERNEL enum dom_status chain_pushes(const struct geometry *geometry, struct tilt from, struct tilt head,
                                    struct sums *sums);

/* Returns true if one contact surely does its part to keep all contacts closed while its leader moves from b
 * to a. */
KERNEL bool contact_pushes(const struct link *a, const struct link *b);

/* Finds the same sums where the head is `by` farther than `from`; `by` may be too small to change the
 * tilt. */
KERNEL enum dom_status chain_energy_change_by(const struct geometry *geometry, struct tilt from,
                                              struct tilt head, real by, struct sums *sums);

/* Finds the sums of chain_energy_change_from, and H2. */
KERNEL enum dom_status chain_second_derivative_from(const struct geometry *geometry, struct tilt from,
                                                    struct tilt head, struct sums *sums);

/*
 * Finds chain_second_derivative_from (from upright) and chain_fall in one pass, for an endless train from
 * which no domino detaches. The processor computes square roots of one chain while those of the other wait.
 */
KERNEL enum dom_status chain_both(const struct geometry *geometry, struct tilt head, struct sums *sums,
                                  struct sums *fall);

/*
 * Finds the tilt of the head at which a domino detaches; *leaves is false if none does within the cycle.
 * *domino, unless NULL, gets its number. At most one domino detaches: the train at theta_c is the train at 0,
 * shifted by one.
 */
KERNEL enum dom_status chain_leave(const struct geometry *geometry, bool *leaves, struct tilt *head,
                                   size_t *domino);

/*
 * Finds the tilts between which a train moves smoothly: edge[0] = 0, the tilt before `end` at which a domino
 * detaches, if there is one, and `end`. *edges gets their number. *moving, unless NULL, gets the number of
 * dominoes that move from edge[0] to edge[1], one more than after it; CHAIN_ENDLESS if none detaches.
 */
enum { CHAIN_EDGES = 3 };
KERNEL enum dom_status chain_edges(const struct geometry *geometry, real end, real edge[CHAIN_EDGES],
                                   int *edges, size_t *moving);

/* Returns the status of a search: the model's own, if its function failed, or else the solver's. */
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
