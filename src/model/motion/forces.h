/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The forces in a moving chain.  From the tail upwards, what each follower gets from gravity and does not
 * need for its own acceleration is what its contact passes on; what a domino then still lacks, its hinge
 * gives.
 */
#ifndef DOM_FORCES_H
#define DOM_FORCES_H

#include "motion/motion.h"

/* How a chain moves: tau^2 omega^2 and tau^2 times the acceleration of its head; g.n dominoes at most. */
struct kinematics {
    real omegasq, acceleration;
    size_t n; /* dominoes that matter */
    /* Of a collision, at theta = 0: tau omega of the head behind it, and what is lost of it by followers. */
    bool hit;
    real omega, omega_lost;
    bool floor;        /* are the forces of the floor asked for? */
    struct room *room; /* for the list of dominoes, to be used again; or NULL */
};

/* Where forces are wanted to a few digits alone, half as many dominoes of a long train serve. */
#define FORCES_TOL ((real)1e-6)

/* Forces in m g of the head, impulses in m g tau of it; x forward, z up. */
struct hinge_load {
    const struct link *link;
    real size;                 /* height over that of the head */
    bool leaned;               /* on by a follower, with: */
    real force, impulse;       /* normal to its back face */
    real x, z;                 /* from the floor, at the hinge */
    real impulse_x, impulse_z; /* the same in the collision */
};

/* Visits at most `shown` dominoes from the head down; false ends it. */
typedef bool hinge_load_visit(const struct hinge_load *hinge_load, void *context);
KERNEL enum dom_status forces_walk(const struct geometry *geometry, struct tilt head,
                                   const struct kinematics *kinematics, size_t shown, hinge_load_visit *visit,
                                   void *context);

/* How a chain moves at a tilt of its head. */
KERNEL enum dom_status segment_kinematics(const struct segment *segment, real theta, struct tilt *head,
                                          struct kinematics *kinematics);

/* The part of a cycle between edge i - 1 and edge i of its barrier, just inside: forces jump where a domino
 * detaches.  False where the cycle does not come as far. */
KERNEL bool motion_part(const struct motion *motion, int i, real *lo, real *hi);

/* Lowers *least to the smallest contact force at a few tilts up to `to`, in weights of the dominoes that it
 * is on. */
KERNEL enum dom_status segment_contact(struct segment *segment, real to, real *least);

/* |x| / z of the floor's force: the friction that a hinge needs; infinite where the domino is lifted. */
KERNEL real forces_needed(real x, real z);

/*
 * What the floor must hold: no hinge slips as long as |R_x| / R_z stays below the floor's friction, R being
 * the force at the hinge, through the motion and, with impulses, in the collision.
 */
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
