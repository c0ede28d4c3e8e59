/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The dominoes of a row: their checks, and the joints between them as the geometry of a chain. */
#ifndef DOM_JOINT_H
#define DOM_JOINT_H

#include "dynamics/choose.h"

/* One domino, in SI units. */
struct block {
    real height, d, mass, tau; /* d = thickness / height */
    real box;                  /* moment of inertia over that of a solid block */
    real unit;                 /* m g h / 2 */
};

KERNEL struct block block_of(const struct row_request *row, size_t k);

/* Check a row with all its dominoes, and domino k alone. *wrong gets the number of the first bad domino. */
KERNEL enum dom_status row_check(const struct row_request *row, size_t *wrong);
KERNEL enum dom_status row_domino_check(const struct row_request *row, size_t k);

/* Make the geometry of the first `count` dominoes of a row, and of domino k alone after that of domino k - 1.
 * row_make also allocates the memory of the law of motion, which dynamics_end of row[0] frees, also after a
 * failure. */
KERNEL enum dom_status row_make(const struct row_request *request, size_t count, struct geometry *row);
KERNEL enum dom_status row_geometry(const struct row_request *request, size_t k, struct geometry *row);

/* Updates the geometry of a row in which only gaps have changed. The dominoes are plumb and have sharp edges.
 */
KERNEL void row_gaps(const struct row_request *request, struct geometry *row);

/* Finds where domino k touches domino k + 1, which may lean. Returns false if the contact is not that of an
 * edge on the back face, or if the two touch before domino k moves. */
KERNEL bool lean_touch(const struct row_request *row, size_t k, struct contact *contact, struct tilt *tilt);

#endif
