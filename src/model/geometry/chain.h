/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The followers of the head at one tilt: the sums over all dominoes (link.h) in their order. The train is
 * followed to its end, geometry->n dominoes (19; c1), or until its tail, bounded by a geometric series, no
 * longer matters at the tolerance.
 */
#ifndef DOM_CHAIN_H
#define DOM_CHAIN_H

#include "geometry/law.h"
#include "numerics/numerics.h"

/* Finds J, H1 and H(theta) - H(0) at theta in [0, theta_c], and bounds of their errors unless error is
 * NULL. */
KERNEL enum dom_status chain_energy_at(const struct geometry *geometry, real theta, struct sums *sums,
                                       struct sums *error);

/* Finds J, H1, H2 and H(head) - H(from). */
KERNEL enum dom_status chain_second_derivative(const struct geometry *geometry, struct tilt from,
                                               struct tilt head, struct sums *sums);

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
static inline enum dom_status model_status(enum dom_status self, enum num_status solver)
{
    static const enum dom_status of[] = {
        [NUM_OK] = DOM_OK,
        [NUM_NOT_BRACKETED] = DOM_NOT_CONVERGED,
        [NUM_NOT_FINITE] = DOM_NOT_FINITE,
        [NUM_NOT_CONVERGED] = DOM_NOT_CONVERGED,
        [NUM_NO_MEMORY] = DOM_NO_MEMORY,
    };
    return self != DOM_OK ? self : of[solver];
}

#endif
