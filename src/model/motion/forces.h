/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The forces in a moving chain, computed from the tail up to the head: a follower passes on to its leader the
 * part of its torque that does not accelerate the follower. The force of the floor at each hinge supplies
 * whatever the contacts and gravity do not.
 */
#ifndef DOM_FORCES_H
#define DOM_FORCES_H

#include "motion/motion.h"

/* The motion of a chain: tau^2 omega^2 and tau^2 times the angular acceleration of its head. */
struct kinematics {
    real omegasq, acceleration;
    size_t n; /* number of dominoes that contribute to the sums */
    /*
     * If `hit` is true, the motion begins with a collision at this moment. `omega` is then tau times the
     * angular velocity of the head just after the collision. The collision reduces tau times the angular
     * velocity of follower i by theta_i' omega_lost.
     */
    bool hit;
    real omega, omega_lost;
    bool floor;        /* true if the forces of the floor are needed */
    struct room *room; /* memory for the list of dominoes, reused by later calls; may be NULL */
};

/* A tolerance that is fine enough for a few digits of a force. In a long train, this tolerance halves the
 * number of dominoes that are visited. */
#define FORCES_TOL ((real)1e-6)

/* The forces on one domino, in units of m g of the head, and the impulses on it, in units of m g tau of the
 * head. x points forward and z up. */
struct hinge_load {
    const struct link *link;
    real size;                 /* height relative to that of the head */
    bool leaned;               /* true if a follower leans on this domino */
    real force, impulse;       /* exerted by the follower, normal to the back face */
    real x, z;                 /* force of the floor at the hinge */
    real impulse_x, impulse_z; /* impulse of the floor at the hinge in the collision */
};

/* Finds the forces on at most `shown` dominoes and visits these dominoes from the head down. The visitor
 * returns false to end the walk. Returns DOM_NO_MEMORY if the list of dominoes cannot be allocated. */
typedef bool hinge_load_visit(const struct hinge_load *hinge_load, void *context);
KERNEL enum dom_status forces_walk(const struct geometry *geometry, struct tilt head,
                                   const struct kinematics *kinematics, size_t shown, hinge_load_visit *visit,
                                   void *context);

/* Finds the motion of a chain at a tilt of its head. */
KERNEL enum dom_status segment_kinematics(const struct segment *segment, real theta, struct tilt *head,
                                          struct kinematics *kinematics);

/*
 * Finds the part of a cycle between edge i - 1 and edge i of its barrier. The ends *lo and *hi are just
 * inside these edges, since forces jump where a domino detaches. Returns false if the cycle does not reach
 * that part.
 */
KERNEL bool motion_part(const struct motion *motion, int i, real *lo, real *hi);

/*
 * Finds the smallest contact force at a few tilts up to `to`, divided by the weight of the domino that the
 * force pushes. Lowers *least to that value if *least is larger. Does nothing if segment->end.pushes already
 * shows that every contact pushes.
 */
KERNEL enum dom_status segment_contact(struct segment *segment, real to, real *least);

/* Returns |x| / z for the force (x, z) of the floor, which is the friction coefficient that a hinge needs.
 * The coefficient is infinite if the force would have to pull the domino down. */
KERNEL real forces_needed(real x, real z);

/*
 * The friction coefficient that the floor needs so that no hinge slips: the largest |R_x| / R_z, where R is
 * the force at a hinge during the motion, or the impulse at a hinge in the collision.
 */
struct required_friction {
    real motion, theta; /* the largest ratio during the motion, and the tilt of the head at that time */
    size_t domino;      /* the domino whose foot needs the coefficient `motion`, 0 for the head */
    real hit;           /* the largest ratio in the collision */
    size_t hit_domino;
};

/* Raises *required to the friction needed over [lo, hi], an interval in which no domino detaches. The
 * relative error of a smooth maximum is about a millionth. */
KERNEL enum dom_status floor_over(const struct segment *segment, real lo, real hi,
                                  struct required_friction *required);

#endif
