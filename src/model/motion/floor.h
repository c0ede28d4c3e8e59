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

/* A chain on its way over [lo, hi], where nobody falls off. */
struct floor_path {
    const struct geometry *geometry;
    real lo, hi;
    enum dom_status (*kinematics)(real theta, struct tilt *head, struct kinematics *kinematics,
                                  void *context);
    void *context;
};

/* Raises what is in need to what this path needs; a smooth maximum is right to a millionth. */
KERNEL enum dom_status floor_over(const struct floor_path *path, struct required_friction *required_friction);

#endif
