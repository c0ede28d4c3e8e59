/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Checks the dominoes of a row. Describes each joint, that is, the contact of two neighbours, as if these
 * were dominoes of a train. */
#ifndef DOM_JOINT_H
#define DOM_JOINT_H

#include "effects/effects.h"

/*
 * Allows for rounding errors in a gap. A head counts as reaching the next domino even if the gap exceeds the
 * reach of the head by up to this fraction. With sharp edges, the reach is the height. Example: in a row that
 * is made from a train with r = 1/s, each gap equals the height of the domino before it, but only up to the
 * rounding errors of r, of the heights and of the gap.
 */
#define REACH_ROUNDED (4 * REAL_EPSILON)

/* One domino, in SI units. */
struct block {
    real height, d, mass, tau; /* d = thickness / height */
    /* moment of inertia, divided by that of a solid block of the same size and mass */
    real inertia_factor;
    real unit; /* unit of energy, m g h / 2 */
};

KERNEL struct block block_of(const struct row_request *row, size_t k);

/* row_check checks the settings and all dominoes of a row. If a domino is bad, sets *wrong to the number of
 * the first bad domino, counted from 1. row_domino_check checks only domino k, counted from 0. */
KERNEL enum dom_status row_check(const struct row_request *row, size_t *wrong);
KERNEL enum dom_status row_domino_check(const struct row_request *row, size_t k);

/* A row that has been checked, with the memory that its runs need. */
struct row {
    struct row_request request;
    struct block *block; /* what the run needs of the dominoes */
    /* geometry[k] describes domino k, both as a head and as the follower of domino k + 1 */
    struct geometry *geometry;
    /* number of elements of `geometry` that are filled in so far; a run fills in more when it needs them */
    size_t made;
};

/* row_begin checks a row and prepares its runs. Call row_free afterwards, even after an error. If a domino is
 * bad, sets *wrong to its number. */
KERNEL enum dom_status row_begin(const struct row_request *request, struct row *row, size_t *wrong);
KERNEL void row_free(struct row *row);

/* Checks the row again after row->request has changed, and fills in its geometry. If the row ends with many
 * equal dominoes, leaves out all of them except the first. */
KERNEL enum dom_status row_read(struct row *row, size_t *wrong);

/* Fills in row[k], from row[k - 1] and from the law of motion in row[0]. */
KERNEL enum dom_status row_geometry(const struct row_request *request, size_t k, struct geometry *row);

/* Returns true if domino k has the same sizes, mass, gap and lean as the domino before it. */
KERNEL bool row_repeats(const struct row_request *row, size_t k);

/* Returns true if the first domino starts at a tilt that takes the place of its lean. */
KERNEL bool row_releases(const struct row_request *row);

/* Returns true if the first domino would be inside the second one when it is released. It starts at the tilt
 * `lean` instead. */
KERNEL bool row_overlaps(const struct row_request *row, real lean);

/* Returns the lean of domino k, which is 0 for a first domino that is released. */
KERNEL real row_lean(const struct row_request *row, size_t k);

/*
 * Finds where domino k touches domino k + 1, if one of the two leans at the start. Sets *contact to their
 * contact, and *tilt to the tilt of domino k at that moment. Returns false if the edge of domino k misses the
 * back face of domino k + 1, or if the two dominoes already touch at the start.
 */
KERNEL bool lean_touch(const struct row_request *row, size_t k, struct contact *contact, struct tilt *tilt);

#endif
