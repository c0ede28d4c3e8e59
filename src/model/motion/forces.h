/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The forces in a moving chain, from the tail up to the head. A follower passes on to its leader the part of
 * its torque that its own acceleration does not need. The hinge of a domino supplies the force that the
 * contacts do not supply.
 */
#ifndef DOM_FORCES_H
#define DOM_FORCES_H

#include "motion/motion.h"

/* The motion of a chain: tau^2 omega^2, and tau^2 times the acceleration of its head. */
struct kinematics {
    real omegasq, acceleration;
    size_t n; /* number of dominoes that matter */
    /* For a collision, which is at the lean of the head: tau omega of the head after the collision, and the
     * share of it that followers lose. */
    bool hit;
    real omega, omega_lost;
    bool floor;        /* find the forces of the floor */
    struct room *room; /* for the list of dominoes, which later calls use again; may be NULL */
};

/* A tolerance that gives forces to a few digits. In a long train it needs half as many dominoes. */
#define FORCES_TOL ((real)1e-6)

/* The forces on one domino, in m g of the head, and the impulses on it, in m g tau of the head. x points
 * forward, z up. */
struct hinge_load {
    const struct link *link;
    real size;                 /* height over that of the head */
    bool leaned;               /* a follower leans on this domino */
    real force, impulse;       /* of that follower, normal to the back face */
    real x, z;                 /* force of the floor at the hinge */
    real impulse_x, impulse_z; /* impulse of the floor at the hinge in the collision */
};

/* Visits at most `shown` dominoes from the head down. A visitor returns false to end the walk. */
typedef bool hinge_load_visit(const struct hinge_load *hinge_load, void *context);
KERNEL enum dom_status forces_walk(const struct geometry *geometry, struct tilt head,
                                   const struct kinematics *kinematics, size_t shown, hinge_load_visit *visit,
                                   void *context);

/* Finds the motion of a chain at a tilt of its head. */
KERNEL enum dom_status segment_kinematics(const struct segment *segment, real theta, struct tilt *head,
                                          struct kinematics *kinematics);

/* Finds the part of a cycle between edge i - 1 and edge i of its barrier. Its ends are just inside of the
 * edges, since forces jump where a domino detaches. Returns false if the cycle does not reach that part. */
KERNEL bool motion_part(const struct motion *motion, int i, real *lo, real *hi);

/* Lowers *least to the smallest contact force at a few tilts up to `to`, over the weight of the domino that
 * the force pushes. Does nothing if segment->end shows that all contacts push. */
KERNEL enum dom_status segment_contact(struct segment *segment, real to, real *least);

/* Returns |x| / z of the force of the floor, the friction that a hinge needs. It is infinite if the domino is
 * lifted. */
KERNEL real forces_needed(real x, real z);

/*
 * The friction that the floor needs: no hinge slips as long as |R_x| / R_z is below the floor's friction,
 * with the force R at the hinge in the motion and the impulse in the collision.
 */
struct required_friction {
    real motion, theta; /* the largest value in motion, and the tilt of the head there */
    size_t domino;      /* number of the domino of that hinge, 0 = head */
    real hit;           /* the largest value in the collision */
    size_t hit_domino;
};

/* Raises *required to what the floor needs over [lo, hi], where no domino detaches. A smooth maximum has a
 * relative error of a millionth. */
KERNEL enum dom_status floor_over(const struct segment *segment, real lo, real hi,
                                  struct required_friction *required);

#endif
