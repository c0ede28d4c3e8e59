/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The chain of followers at one tilt of the head. A pass follows it to its end, geometry->n dominoes
 * (19; c1), or until its tail, which a geometric series bounds, no longer matters at the tolerance.
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
 * Finds the tilt of the head at which a domino detaches, and the number of that domino unless `domino` is
 * NULL. *leaves is false if no domino detaches during the cycle. At most one does: the train at theta_c is
 * the train at 0, shifted by one domino.
 */
KERNEL enum dom_status chain_leave(const struct geometry *geometry, bool *leaves, struct tilt *head,
                                   size_t *domino);

/*
 * Finds the tilts between which a train moves smoothly: edge[0] = 0, the tilt before `end` at which a domino
 * detaches, if there is one, and `end`. *edges gets their number. *moving, unless it is NULL, gets the number
 * of dominoes that move from edge[0] to edge[1], which is one more than after edge[1], or CHAIN_ENDLESS if no
 * domino detaches.
 */
enum { CHAIN_EDGES = 3 };
KERNEL enum dom_status chain_edges(const struct geometry *geometry, real end, real edge[CHAIN_EDGES],
                                   int *edges, size_t *moving);

/* Returns the status of a search: that of the model if its function has failed, otherwise that of the solver.
 */
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
