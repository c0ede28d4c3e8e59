/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The law of motion of a train, as a table of functions. README.md in this folder explains how to add an
 * effect.
 */
#ifndef DOM_DYNAMICS_H
#define DOM_DYNAMICS_H

#include "geometry/chain.h"

/*
 * The collision (22; c4), derived as in (59; e8). The struck domino is upright. It moves on together with the
 * chain that hits it. The collision conserves the angular momentum that the contacts transmit:
 *
 *     (1 + T) omega(0) = T omega_1(theta_c).
 *
 * Here omega_1(theta_c) is the angular velocity of the hitting domino before the collision, and omega(0) is
 * the angular velocity of the struck domino afterwards. With sharp edges, the inertia ratio T is
 * r^-(q+1) J(theta_c), where J is the inertia of the hitting chain. With friction, the product S_1 A takes
 * the place of J.
 */
/* Returns omega(0) / omega_1(theta_c), the fraction of the angular velocity that remains after a
 * collision. */
KERNEL real collision_velocity_ratio(real inertia_ratio)
{
    return inertia_ratio / (1 + inertia_ratio);
}

/* The state in which a cycle begins, in units of the head. */
struct launch {
    real fuel;           /* P, the energy released in a cycle, by the chosen fuel formula */
    real J0;             /* J(0) */
    real inertia_ratio;  /* the inertia ratio T of the collision */
    real velocity_ratio; /* omega(0) / omega_1(theta_c) */
    real omegasq;        /* tau^2 omega(0)^2 */
    real kinetic;        /* J(0) tau^2 omega(0)^2 */
    real kinetic_at_hit; /* kinetic energy at theta_c, if the train gets that far */
};

/* The state in which a motion begins, with the head at the tilt `from`. */
struct start {
    struct tilt from;
    real J;       /* inertia of all moving dominoes (20; c2) */
    real omegasq; /* tau^2 omega^2 */
    real kinetic; /* J omegasq */
};

/* A law of motion. A function whose comment begins with "Optional" may be NULL. */
struct dynamics {
    /* True if the motion conserves energy. The barrier is then the maximum of the potential energy H. */
    bool conservative;

    /* Optional. `begin` and `end` allocate and free the memory of this law. `begin` returns DOM_OK or
     * DOM_NO_MEMORY. */
    enum dom_status (*begin)(struct geometry *geometry);
    void (*end)(struct geometry *geometry);

    /* Optional. Solves the equation of motion over a whole cycle, unless an earlier call has already done
     * so. */
    enum dom_status (*solve)(const struct geometry *geometry);
    /* Optional. Solves the equation of motion over [lo, *hi]. J is the inertia at lo. If friction locks the
     * motion inside this interval, lowers *hi to the tilt at which it locks and returns DOM_LOCKS. */
    enum dom_status (*solve_piece)(const struct geometry *geometry, real J, real lo, real *hi);
    /* Optional. If the motion stops before *hi, lowers *hi to a tilt shortly after the stop. The motion
     * starts in a smooth piece, which extends from edge[0] to edge[1]. */
    enum dom_status (*spent)(const struct geometry *geometry, const struct start *start, const real edge[2],
                             real *hi);
    /* Optional if friction cannot lock a motion. Called only if friction locks the motion at the tilt `head`.
     * Sets *braked to true if the motion slows down just before this tilt, and to false if it speeds up. */
    enum dom_status (*braked)(const struct geometry *geometry, struct tilt head, bool *braked);

    /* Finds the launch of a train in which each cycle repeats the cycle before, scaled by r (24; c6). */
    enum dom_status (*collide)(const struct geometry *geometry, enum dom_fuel fuel, struct launch *launch);
    /*
     * Finds the inertia ratio of the collision in which the head of the chain `hitting` hits the domino
     * described by `next`. In this collision, the head has the tilt `at`, and the chain has the inertia J.
     * Returns DOM_UNDERFLOW or DOM_LOCKS if the ratio is not positive.
     */
    enum dom_status (*inertia_ratio)(const struct geometry *next, const struct geometry *hitting,
                                     struct tilt at, real J, real *inertia_ratio);

    /* Finds dH/dtheta at a tilt of the head. If `rough` is true, only the sign of *slope is reliable. With
     * friction, *slope is a different number, which has the sign of the derivative of the required energy. */
    enum dom_status (*slope)(const struct geometry *geometry, struct tilt head, bool rough, real *slope);
    /* Finds the smallest kinetic energy at the tilt `from` that takes the head to the tilt 2 atan p. */
    enum dom_status (*required_energy)(const struct geometry *geometry, struct tilt from, real p,
                                       real *energy);
    /* Optional. Returns an estimate of the error of required energies. The error may be large compared with a
     * small barrier. */
    real (*required_energy_error)(const struct geometry *geometry);
    /* Finds tau^2 omega^2 at a tilt. */
    enum dom_status (*speed)(const struct geometry *geometry, const struct start *start, real theta,
                             real *omegasq);
    /* Finds 1 / (tau^2 omega^2) at the tilt `end - by` of a motion whose energy is used up at `end`. If `by`
     * is negative, the motion starts at rest at `end`. *slowness is NaN if there is no energy at
     * `end - by`. */
    enum dom_status (*near_rest)(const struct geometry *geometry, real end, real by, real *slowness);
    /* Finds tau^2 times the angular acceleration of the head. `w` is tau^2 omega^2 at the tilt `head`. Unless
     * n is NULL, sets *n to the number of dominoes that contribute. */
    enum dom_status (*acceleration)(const struct geometry *geometry, struct tilt head, real w,
                                    real *acceleration, size_t *n);
    /*
     * Returns how strongly the speed at theta depends on the speed at the launch: the derivative of omegasq
     * at theta with respect to omegasq at the launch. `gain` is this derivative at start->from, the tilt at
     * which the motion begins. This is the tilt of the launch or, if a domino has detached since then, the
     * tilt at which it detached. J_at is the inertia at theta.
     */
    real (*gain)(const struct geometry *geometry, const struct start *start, real gain, real theta,
                 real J_at);
};

#endif
