/* SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "effects/effects.h"
#include "numerics/numerics.h"

/*
 * The barrier over [0, end], and its tilt theta_m. The tilts edge[0] = 0, ..., edge[edges - 1] = end divide
 * this interval into pieces in which H is smooth. In a cycle, domino number `domino` detaches when the head
 * has the tilt `leave`, which is NaN if none detaches.
 */
struct barrier {
    real theta_m, height;
    real half; /* tan(theta_m / 2) */
    real edge[CHAIN_EDGES];
    int edges;
    real leave;
    size_t domino;
};

/*
 * Relative tolerance for the tilt of a top (a local maximum of H) if only its height is needed. The error of
 * the height is of third order in the last Newton step, so the cube root of the tolerance is enough.
 * TOP_TOL_ROUGH is for heights that are not part of a result.
 */
#define TOP_TOL(geometry)       (cbrt((geometry)->tol) / 4)
#define TOP_TOL_ROUGH(geometry) (4 * cbrt((geometry)->tol))

/* Finds the barrier over [0, theta_c]. If `known` is true, *b already holds a top of H, and only higher ones
 * are searched. tol is the relative tolerance of theta_m. If only the height is needed, TOP_TOL is enough. */
KERNEL enum dom_status barrier_search(const struct geometry *geometry, bool known, real tol,
                                      struct barrier *b);

/* Finds one top by Newton's method, starting at the top in *b, and stores it in *b. Does not look for other
 * tops, so a higher top may exist. `tol` is the relative tolerance of the tilt. Returns false if it finds no
 * top. */
KERNEL bool barrier_follow(const struct geometry *geometry, real tol, struct barrier *b);

/* Returns true only if it is proved that H has a single top. */
KERNEL bool barrier_single(const struct geometry *geometry);

/* Returns an upper bound on the barrier. The bound holds for trains of any length, if r >= 1. */
KERNEL real barrier_most(const struct geometry *geometry);

/* Finds the barrier from b->edge[0] to the tilt `end`. *b has the edges of the whole motion, and those beyond
 * `end` are dropped. Heights are relative to H at `from`. */
KERNEL enum dom_status barrier_up_to(const struct geometry *geometry, struct tilt from, real end,
                                     struct barrier *b);
