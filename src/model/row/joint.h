/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The dominoes of a row: their checks, and the joints between them as the geometry of a chain. */
#ifndef DOM_JOINT_H
#define DOM_JOINT_H

#include "dynamics/choose.h"

/* A gap counts as reached if it is wider than the head is tall by at most this fraction, which allows for
 * rounding errors. In a row of a train with r = 1/s, these are the errors of r, of two powers, of four
 * products, and of both sizes when they are rounded to the precision. Each of these errors is half a unit or
 * one unit in the last place. */
#define REACH_ROUNDED (4 * REAL_EPSILON)

/* One domino, in SI units. */
struct block {
    real height, d, mass, tau; /* d = thickness / height */
    real box;                  /* moment of inertia divided by that of a solid block */
    real unit;                 /* m g h / 2 */
};

KERNEL struct block block_of(const struct row_request *row, size_t k);

/* row_check checks a whole row, and row_domino_check checks domino k alone. If a row has bad dominoes, *wrong
 * receives the number of the first bad domino, counted from 1. */
KERNEL enum dom_status row_check(const struct row_request *row, size_t *wrong);
KERNEL enum dom_status row_domino_check(const struct row_request *row, size_t k);

/* row_make makes the geometry of the first `count` dominoes of a row. It also allocates the memory of the law
 * of motion; free it with dynamics_end of row[0], even after a failure. row_geometry makes the geometry of
 * domino k alone, and needs the geometry of domino k - 1. */
KERNEL enum dom_status row_make(const struct row_request *request, size_t count, struct geometry *row);
KERNEL enum dom_status row_geometry(const struct row_request *request, size_t k, struct geometry *row);

/* Updates the geometry of a row in which only gaps have changed, and all dominoes are plumb and have sharp
 * edges. */
KERNEL void row_gaps(const struct row_request *request, struct geometry *row);

/* Finds the contact of domino k with domino k + 1, which may lean, and the tilt of domino k at that contact.
 * Returns false if the contact is not that of an upper edge with the back face of the other domino, or if the
 * two dominoes touch before domino k moves. */
KERNEL bool lean_touch(const struct row_request *row, size_t k, struct contact *contact, struct tilt *tilt);

#endif
