/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The dominoes of a row and the joints between them: checked, and as the geometry of a chain. */
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

/* Checks the row and each domino; *wrong gets the number of a domino that is wrong. row_domino_check checks
 * one. */
KERNEL enum dom_status row_check(const struct row_request *row, size_t *wrong);
KERNEL enum dom_status row_domino_check(const struct row_request *row, size_t k);

/* Makes the geometry of the first `count` dominoes of a row, or of domino k alone, when that of domino k - 1
 * is made. row_make also takes the memory of the law, which dynamics_end of row[0] gives back, also after a
 * failure. */
KERNEL enum dom_status row_make(const struct row_request *request, size_t count, struct geometry *row);
KERNEL enum dom_status row_geometry(const struct row_request *request, size_t k, struct geometry *row);

/* Changes the geometry of a row whose gaps alone have changed, of plumb dominoes with sharp edges. */
KERNEL void row_gaps(const struct row_request *request, struct geometry *row);

/* Finds where domino k touches domino k + 1, which may lean. Returns false if the contact is not that of an
 * edge on the back face, or if they touch before domino k moves. */
KERNEL bool lean_touch(const struct row_request *row, size_t k, struct contact *contact, struct tilt *tilt);

#endif
