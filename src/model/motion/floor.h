/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * What the floor must hold: no hinge slips as long as |R_x| / R_z stays below the floor's friction, R being
 * the force at the hinge, through the motion and, with impulses, in the collision.
 */
#ifndef DOM_FLOOR_H
#define DOM_FLOOR_H

#include "motion/forces.h"

struct required_friction {
    real motion, theta; /* the most in motion, and the tilt of the head there */
    size_t domino;      /* whose hinge: behind the head */
    real hit;           /* the most in the collision */
    size_t hit_domino;
};

/* Raises *required to what the floor must supply over [lo, hi], where no domino detaches; a smooth maximum is
 * right to a millionth. */
KERNEL enum dom_status floor_over(const struct segment *segment, real lo, real hi,
                                  struct required_friction *required);

#endif
