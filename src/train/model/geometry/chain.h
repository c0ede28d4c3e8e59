/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The chain of followers at one tilt of the head. A pass visits the dominoes from the head down and computes
 * sums over them, such as the energy H of equation (19; c1). The pass ends after geometry->n dominoes. It
 * ends earlier at a domino whose follower has detached, or if a geometric series shows that the remaining
 * terms are negligible at the tolerance.
 */
#ifndef DOM_CHAIN_H
#define DOM_CHAIN_H

#include "geometry/law.h"
#include "numerics/numerics.h"

/* Does the same as chain_change_by, but computes t from the two tilts of the head. */
KERNEL enum dom_status chain_change(const struct geometry *geometry, struct tilt from, struct tilt head,
                                    enum pass pass, struct sums *sums);

/* Finds J, H1 and H(theta) - H(0) at theta in [0, theta_c]. */
KERNEL enum dom_status chain_energy_at(const struct geometry *geometry, real theta, struct sums *sums);

/*
 * Finds the tilt of the head at which a domino detaches. At most one domino detaches while the head moves
 * from 0 to theta_c, since the train at theta_c is the train at 0 shifted by one domino. If no domino
 * detaches, or only one that contributes less than the rounding errors, *leaves is false. Unless `domino` is
 * NULL, *domino receives the number of the domino that detaches.
 */
KERNEL enum dom_status chain_leave(const struct geometry *geometry, bool *leaves, struct tilt *head,
                                   size_t *domino);

/*
 * Divides the motion up to the tilt `end` into pieces in which the sums are smooth functions of the tilt. The
 * array `edge` receives the tilts of the head at which the pieces begin and end:
 * - edge[0] is 0. If the head only just reaches the next domino, edge[0] is slightly above 0.
 * - If a domino detaches before `end`, the tilt at that moment is the next edge. From this edge on, the
 *   detached domino no longer moves.
 * - The last edge is `end`.
 *
 * *edges receives the number of edges. Unless `moving` is NULL, *moving receives the number of dominoes that
 * move in the first piece. If no domino detaches, this number is CHAIN_ENDLESS.
 */
enum { CHAIN_EDGES = 3 };
KERNEL enum dom_status chain_edges(const struct geometry *geometry, real end, real edge[CHAIN_EDGES],
                                   int *edges, size_t *moving);

/* Combines the status of a solver with the status of the function that it evaluated. An error of the function
 * takes precedence, because it tells why the solver failed. */
static inline enum dom_status model_status(enum dom_status function, enum num_status solver)
{
    static const enum dom_status of[] = {
        [NUM_OK] = DOM_OK,
        [NUM_NOT_BRACKETED] = DOM_NOT_CONVERGED,
        [NUM_NOT_FINITE] = DOM_NOT_FINITE,
        [NUM_NOT_CONVERGED] = DOM_NOT_CONVERGED,
        [NUM_NO_MEMORY] = DOM_NO_MEMORY,
    };
    return function != DOM_OK ? function : of[solver];
}

#endif
