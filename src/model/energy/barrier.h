/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DOM_BARRIER_H
#define DOM_BARRIER_H

#include "dynamics/choose.h"
#include "numerics/numerics.h"

/*
 * theta_m and the barrier over the tilts [0, end] of a train of at most n dominoes, and the tilts
 * between which H is smooth: edge[0] = 0, ..., edge[edges - 1] = end, with the falling off of a domino
 * between them, if any.
 */
struct barrier {
    real theta_m, height;
    real half; /* tan(theta_m / 2) */
    real edge[CHAIN_EDGES];
    int edges;
};

/* Of a tilt: the height there, to the third order of a step to the top, has the tolerance of the sums. */
#define TOP_TOL(geometry) (cbrt((geometry)->tol) / 4)

/* To the relative tolerance tol of theta_m; TOP_TOL where only the height is wanted. */
KERNEL enum dom_status barrier_search(const struct geometry *geometry, real end, real tol,
                                      struct barrier *barrier);

/*
 * One top alone, by Newton's method from barrier_near on: a guess, and where b has the top of a neighbouring
 * train a good one.  at: the sums there (chain_second_derivative_from), or NULL.  False where it comes to no
 * top; whether it is the highest barrier_tops knows.
 */
KERNEL struct tilt barrier_near(const struct geometry *geometry, const struct barrier *b);
KERNEL bool barrier_follow(const struct geometry *geometry, const struct sums *at, struct barrier *b);

/* Looks for higher tops than that of b, over [0, theta_c], and if there are, puts the highest in its place.
 */
KERNEL enum dom_status barrier_tops(const struct geometry *geometry, struct barrier *b);

/* Has H one top for sure? */
KERNEL bool barrier_single(const struct geometry *geometry);

/* No barrier of an endless train is higher, nor of one that ends, where r >= 1. */
KERNEL real barrier_most(const struct geometry *geometry);

/* The same over [lo, hi], where H is smooth, and relative to H at lo, the tilt `from`. */
KERNEL enum dom_status barrier_piece(const struct geometry *geometry, struct tilt from, real lo, real hi,
                                     struct barrier *barrier);

/* The same over the tilts from the first edge of `whole` to `end`, with the edges of whole between. */
KERNEL enum dom_status barrier_up_to(const struct geometry *geometry, struct tilt from,
                                     const struct barrier *whole, real end, struct barrier *barrier);

/*
 * Launch of an endless train and its barrier over [0, end]; unless NULL, error gets the bounds of the
 * launch.  Where the two nearly balance their difference is not known as well as they are: then both come
 * at a tolerance at which it is, if the arithmetic can give it, and geometry->tol is that one.
 */
KERNEL enum dom_status barrier_balance(struct geometry *geometry, enum dom_fuel fuel, real end,
                                       struct launch *launch, struct launch *error, struct barrier *barrier);

/*
 * Returns whether a train goes on (c8): DOM_OK, DOM_STOPS, or DOM_NO_FUEL.  From what barrier_balance found
 * over the whole cycle; every answer about a train takes its verdict from here.
 */
KERNEL enum dom_status barrier_verdict(const struct launch *launch, const struct barrier *barrier);

/* The tolerance at which what is left of a whole is known as well as tol says. */
KERNEL real balance_tol(real tol, real left, real whole);

/*
 * Near a top inside a cycle the energy left is (width^2 + (theta - theta_m)^2) |H2| / 2; NaN where the top is
 * at an end, or unknown.  from: as for barrier_piece.
 */
KERNEL real barrier_width(const struct geometry *geometry, struct tilt from, const struct barrier *b,
                          real margin);

/* Bounds of the errors of theta_m and height. */
KERNEL enum dom_status barrier_error(const struct geometry *geometry, const struct barrier *barrier,
                                     struct barrier *error);

#endif
