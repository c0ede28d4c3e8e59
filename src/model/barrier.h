/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DOM_BARRIER_H
#define DOM_BARRIER_H

#include "collision.h"
#include "numerics/numerics.h"

/*
 * theta_m and the barrier over the tilts [0, end] of a train of at most n dominoes, and the tilts
 * between which H is smooth: edge[0] = 0, ..., edge[edges - 1] = end, with the falling off of a domino
 * between them, if any.
 */
struct barrier {
    real theta_m, height;
    real edge[CHAIN_EDGES];
    int edges;
};

KERNEL enum dom_status barrier_search(const struct lean *lean, real end, struct barrier *barrier);

/* The same over [lo, hi], where H is smooth, and relative to H at lo, the tilt `from`. */
KERNEL enum dom_status barrier_piece(const struct lean *lean, struct tilt from, real lo, real hi,
                                     struct barrier *barrier);

/*
 * Launch of an endless train and its barrier over [0, end]; unless NULL, error gets the bounds of the
 * launch.  Where the two nearly balance their difference is not known as well as they are: then both come
 * at a tolerance at which it is, if the arithmetic can give it, and lean->tol is that one.
 */
KERNEL enum dom_status barrier_balance(struct lean *lean, enum dom_fuel fuel, real end, struct launch *launch,
                                       struct launch *error, struct barrier *barrier);

/* The tolerance at which what is left of a whole is known as well as tol says. */
KERNEL real balance_tol(real tol, real left, real whole);

/* Bounds of the errors of theta_m and height. */
KERNEL enum dom_status barrier_error(const struct lean *lean, const struct barrier *barrier,
                                     struct barrier *error);

#endif
