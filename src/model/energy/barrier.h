/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DOM_BARRIER_H
#define DOM_BARRIER_H

#include "dynamics/choose.h"
#include "numerics/numerics.h"

/*
 * The barrier over the tilts [0, end], and its tilt theta_m. H is smooth between the tilts edge[0] = 0, ...,
 * edge[edges - 1] = end. If a domino detaches, the tilt of the head at that moment is the edge between the
 * first and the last one.
 */
struct barrier {
    real theta_m, height;
    real half; /* tan(theta_m / 2) */
    real edge[CHAIN_EDGES];
    int edges;
};

/* A top is a local maximum of H. This is the relative tolerance for the tilt of a top if only the height of
 * the top must have the tolerance of the sums. The error of the height is of third order in the last step to
 * the top. */
#define TOP_TOL(geometry) (cbrt((geometry)->tol) / 4)

/* Finds the barrier. tol is the relative tolerance of theta_m; TOP_TOL is enough if only the height is
 * needed. */
KERNEL enum dom_status barrier_search(const struct geometry *geometry, real end, real tol,
                                      struct barrier *barrier);

/*
 * These two functions find a single top by Newton's method. barrier_near returns the tilt at which
 * barrier_follow starts. This tilt is a good estimate of the top if b holds the top of a similar train. `at`
 * holds the sums at that tilt (PASS_SECOND_DERIVATIVE), or is NULL. barrier_follow returns false if it finds
 * no top. Only barrier_tops checks whether the top is the highest one.
 */
KERNEL struct tilt barrier_near(const struct geometry *geometry, const struct barrier *b);
KERNEL bool barrier_follow(const struct geometry *geometry, const struct sums *at, struct barrier *b);

/* Searches [0, theta_c] for tops higher than that of b, and stores the highest in b. */
KERNEL enum dom_status barrier_tops(const struct geometry *geometry, struct barrier *b);

/* Returns true only if H is proved to have a single top. */
KERNEL bool barrier_single(const struct geometry *geometry);

/* Returns an upper bound on the barrier, which holds for trains of any length with r >= 1. */
KERNEL real barrier_most(const struct geometry *geometry);

/* Finds the barrier over [lo, hi], where H must be smooth. Heights are relative to H at lo, and `from` is lo
 * as a struct tilt. */
KERNEL enum dom_status barrier_piece(const struct geometry *geometry, struct tilt from, real lo, real hi,
                                     struct barrier *barrier);

/* Finds the barrier over the tilts from the first edge of `whole` to `end`. The edges of `whole` inside this
 * range are edges of the result, too. Heights are relative to H at `from`. */
KERNEL enum dom_status barrier_up_to(const struct geometry *geometry, struct tilt from,
                                     const struct barrier *whole, real end, struct barrier *barrier);

/*
 * Finds the launch of an endless train and its barrier over [0, end], and error bounds on the launch unless
 * `error` is NULL. If the kinetic energy and the barrier are nearly equal, digits cancel in their difference.
 * Both energies are then computed again with a finer tolerance, if the arithmetic allows one, and
 * geometry->tol is set to that tolerance.
 */
KERNEL enum dom_status barrier_balance(struct geometry *geometry, enum dom_fuel fuel, real end,
                                       struct launch *launch, struct launch *error, struct barrier *barrier);

/*
 * Returns DOM_OK if a train keeps falling (26; c8), and otherwise DOM_STOPS or DOM_NO_FUEL, from the results
 * of barrier_balance over the whole cycle. Every result about a train uses this verdict.
 */
KERNEL enum dom_status barrier_verdict(const struct launch *launch, const struct barrier *barrier);

/* Returns the tolerance with which two terms of the size `whole` must be computed so that their difference,
 * of the size `left`, has the tolerance tol. */
KERNEL real balance_tol(real tol, real left, real whole);

/*
 * Returns the width of the peak of 1/omega at a top inside a cycle. Near the top, the remaining kinetic
 * energy is (width^2 + (theta - theta_m)^2) |H2| / 2. Returns NaN if the top is at an end of the cycle, or if
 * H2 is unknown. `from` is as for barrier_piece.
 */
KERNEL real barrier_width(const struct geometry *geometry, struct tilt from, const struct barrier *b,
                          real margin);

/* Finds error bounds on theta_m and height. They are NaN if no bounds are known for this train. */
KERNEL enum dom_status barrier_error(const struct geometry *geometry, const struct barrier *barrier,
                                     struct barrier *error);

#endif
