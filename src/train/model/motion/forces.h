/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The forces in a moving chain, computed from the tail to the head. Part of the torque on a follower
 * accelerates the follower. The rest of the torque acts on its leader, through their contact. When the
 * contact forces are known, Newton's law gives the force of the floor on each domino.
 */
#ifndef DOM_FORCES_H
#define DOM_FORCES_H

#include "motion/motion.h"

/* The motion of a chain, given by the motion of its head: `omegasq` is tau^2 omega^2, and `acceleration` is
 * tau^2 times the angular acceleration. */
struct kinematics {
    real omegasq, acceleration;
    size_t n; /* number of dominoes that contribute to the sums */
    /*
     * True at the start of a motion that begins with a collision. `omega` is then tau times the angular
     * velocity of the head after the collision. `omega_lost` describes what the followers lose: in the
     * collision, the angular velocity of follower i decreases by theta_i' * `omega_lost` / tau.
     */
    bool hit;
    real omega, omega_lost;
    bool floor;        /* true if the forces of the floor are needed */
    struct room *room; /* memory for the list of dominoes, reused by later calls; may be NULL */
};

/* This tolerance gives a few digits of a force. */
#define FORCES_TOL ((real)1e-6)

/* The forces on one domino, in units of m g of the head, and the impulses, in units of m g tau of the head. x
 * points forward and z up. */
struct hinge_load {
    const struct link *link;
    real size;                 /* height relative to the head's */
    bool leaned;               /* true if a follower leans on this domino */
    real force, impulse;       /* force and impulse of the follower, normal to the back face */
    real x, z;                 /* force of the floor at the hinge */
    real impulse_x, impulse_z; /* impulse of the floor during the collision */
};

/*
 * Finds the forces on at most `shown` dominoes and visits these dominoes, beginning with the head. The
 * visitor returns false to end the walk.
 */
typedef bool hinge_load_visit(const struct hinge_load *hinge_load, void *context);
KERNEL enum dom_status forces_walk(const struct geometry *geometry, struct tilt head,
                                   const struct kinematics *kinematics, size_t shown, hinge_load_visit *visit,
                                   void *context);

/* Finds the motion of a chain at a tilt of its head. Leaves kinematics->floor unchanged. */
KERNEL enum dom_status segment_kinematics(const struct segment *segment, real theta, struct tilt *head,
                                          struct kinematics *kinematics);

/* The edges of the barrier divide a cycle into parts. Finds the part between the edges i - 1 and i. Forces
 * jump at the edges, so *lo and *hi are set just inside. Returns false if the cycle ends before this part. */
KERNEL bool motion_part(const struct motion *motion, int i, real *lo, real *hi);

/* Finds the contact forces at a few tilts from lo to `to` and divides each force by the weight of the domino
 * that it pushes. If the smallest of these ratios is below *least, stores it there. If segment->end.pushes is
 * true, no ratio is negative, so callers that only need the sign do not call this function. */
KERNEL enum dom_status segment_contact(struct segment *segment, real to, real *least);

/* Returns the friction coefficient |x| / z that a hinge needs if (x, z) is the force of the floor on it. If
 * the floor would have to pull (z <= 0), the friction coefficient is infinite. */
KERNEL real friction_needed(real x, real z);

/*
 * The friction coefficient that the floor needs so that no hinge slips. It is the largest ratio |R_x| / R_z
 * over all hinges. During the motion, R is the force of the floor at a hinge. In the collision, R is the
 * impulse of this force.
 */
struct required_friction {
    real motion, theta; /* largest ratio during the motion, and the tilt of the head at which it occurs */
    size_t domino;      /* domino with the largest ratio during the motion; 0 is the head */
    real hit;           /* largest ratio |R_x| / R_z in the collision */
    size_t hit_domino;
    size_t shown; /* the number of dominoes at which the last walk looked */
};

/* Finds the friction needed at the tilts in [lo, hi]. If this is more than the friction in *required, updates
 * *required. No domino may detach inside this interval. If the friction is smooth around its maximum, the
 * relative error is about a millionth. */
KERNEL enum dom_status floor_over(const struct segment *segment, real lo, real hi,
                                  struct required_friction *required);

#endif
