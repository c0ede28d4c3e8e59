/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DOM_BARRIER_H
#define DOM_BARRIER_H

#include "dynamics/choose.h"
#include "numerics/numerics.h"

/*
 * The barrier over the tilts [0, end] and its place theta_m; and the tilts between which H is smooth, edge[0]
 * = 0, ..., edge[edges - 1] = end. If a domino detaches, its tilt is between them.
 */
struct barrier {
    real theta_m, height;
    real half; /* tan(theta_m / 2) */
    real edge[CHAIN_EDGES];
    int edges;
};

/* The tolerance of a tilt for which the height has the tolerance of the sums. The error of the height is of
 * the third order in the step to the top. */
#define TOP_TOL(geometry) (cbrt((geometry)->tol) / 4)

/* Finds the barrier. tol is the relative tolerance of theta_m; TOP_TOL is enough if only the height is
 * needed. */
KERNEL enum dom_status barrier_search(const struct geometry *geometry, real end, real tol,
                                      struct barrier *barrier);

/*
 * Find a single top by Newton's method. barrier_near guesses its tilt, and the guess is good if b has the top
 * of a similar train. `at` has the sums at that tilt (chain_second_derivative), or is NULL. barrier_follow
 * returns false if there is no top. Only barrier_tops finds whether the top is the highest.
 */
KERNEL struct tilt barrier_near(const struct geometry *geometry, const struct barrier *b);
KERNEL bool barrier_follow(const struct geometry *geometry, const struct sums *at, struct barrier *b);

/* Searches [0, theta_c] for tops higher than that of b, and stores the highest in b. */
KERNEL enum dom_status barrier_tops(const struct geometry *geometry, struct barrier *b);

/* Returns true if H surely has only one top. */
KERNEL bool barrier_single(const struct geometry *geometry);

/* Returns an upper bound of the barrier of a train of any length, for r >= 1. */
KERNEL real barrier_most(const struct geometry *geometry);

/* Finds the barrier over [lo, hi], where H is smooth, relative to H at lo, the tilt `from`. */
KERNEL enum dom_status barrier_piece(const struct geometry *geometry, struct tilt from, real lo, real hi,
                                     struct barrier *barrier);

/* Finds the barrier over the tilts from the first edge of `whole` to `end`, with the edges of `whole` in
 * between. */
KERNEL enum dom_status barrier_up_to(const struct geometry *geometry, struct tilt from,
                                     const struct barrier *whole, real end, struct barrier *barrier);

/*
 * Finds the launch of an endless train and its barrier over [0, end], and error bounds of the launch unless
 * `error` is NULL. If kinetic energy and barrier are nearly equal, their difference has fewer digits. Both
 * are then computed with a finer tolerance, if the arithmetic allows it, and geometry->tol is set to that
 * tolerance.
 */
KERNEL enum dom_status barrier_balance(struct geometry *geometry, enum dom_fuel fuel, real end,
                                       struct launch *launch, struct launch *error, struct barrier *barrier);

/*
 * Returns whether a train goes on (26; c8), as DOM_OK, DOM_STOPS or DOM_NO_FUEL, from the results of
 * barrier_balance over the whole cycle. Every answer about a train uses this verdict.
 */
KERNEL enum dom_status barrier_verdict(const struct launch *launch, const struct barrier *barrier);

/* Returns the tolerance that two terms of size `whole` need so that their difference `left` has the tolerance
 * tol. */
KERNEL real balance_tol(real tol, real left, real whole);

/*
 * Returns the width of the peak of slowness at a top inside a cycle: near the top the energy that is left is
 * (width^2 + (theta - theta_m)^2) |H2| / 2. Returns NaN if the top is at an end of the cycle, or unknown.
 * `from` is as for barrier_piece.
 */
KERNEL real barrier_width(const struct geometry *geometry, struct tilt from, const struct barrier *b,
                          real margin);

/* Finds bounds of the errors of theta_m and height. */
KERNEL enum dom_status barrier_error(const struct geometry *geometry, const struct barrier *barrier,
                                     struct barrier *error);

#endif
