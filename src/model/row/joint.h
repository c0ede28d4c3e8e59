/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Checks the dominoes of a row, and describes each joint (contact between neighbours) as if it were in a
 * train. */
#ifndef DOM_JOINT_H
#define DOM_JOINT_H

#include "dynamics/choose.h"

/*
 * A head still reaches the next domino if the gap exceeds the height of the head by this fraction. In a row
 * made from a train with r = 1/s, the gap equals the height except for rounding errors. These come from r,
 * two powers, four products and the kernel's precision.
 */
#define REACH_ROUNDED (4 * REAL_EPSILON)

/* One domino, in SI units. */
struct block {
    real height, d, mass, tau; /* d = thickness / height */
    /* moment of inertia relative to a solid block of the same size and mass */
    real inertia_factor;
    real unit; /* unit of energy, m g h / 2 */
};

KERNEL struct block block_of(const struct row_request *row, size_t k);

/* row_check checks a whole row, and row_domino_check only domino k. If a domino is bad, row_check sets *wrong
 * to the number of the first bad one, counted from 1. */
KERNEL enum dom_status row_check(const struct row_request *row, size_t *wrong);
KERNEL enum dom_status row_domino_check(const struct row_request *row, size_t k);

/* row_make allocates memory, and fills in the geometry of the first `count` dominoes. Call
 * dynamics_end(&row[0]) afterwards, even if row_make fails. row_geometry fills in only row[k], for which it
 * uses row[k - 1]. */
KERNEL enum dom_status row_make(const struct row_request *request, size_t count, struct geometry *row);
KERNEL enum dom_status row_geometry(const struct row_request *request, size_t k, struct geometry *row);

/* Updates the geometry of a row after changes of gaps. All dominoes must be plumb and have sharp edges. */
KERNEL void row_gaps(const struct row_request *request, struct geometry *row);

/*
 * Finds the contact of dominoes k and k + 1, one of which leans. Also finds the tilt of domino k there.
 * Returns false if the edge of domino k misses the back face, or if the dominoes touch at the start.
 */
KERNEL bool lean_touch(const struct row_request *row, size_t k, struct contact *contact, struct tilt *tilt);

#endif
