/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The law of motion of a train, as a table of functions. energy_balance.c and friction.c each have such a
 * table. README.md in this folder says how to add an effect.
 */
#ifndef DOM_DYNAMICS_H
#define DOM_DYNAMICS_H

#include "geometry/chain.h"

/*
 * The collision (22; c4), derived as (59; e8): the struck domino, which is upright, and the chain that hits
 * it move on together. T = r^-(q+1) J(theta_c) is the inertia ratio, where J is the inertia of the chain;
 * with friction S_1 A replaces J. The collision conserves the angular momentum that all contacts pass on:
 *
 *     (1 + T) omega(0) = T omega_1(theta_c).
 */
/* Returns omega(0) / omega_1(theta_c), the share of the angular velocity that is left after a collision. */
KERNEL real collision_velocity_ratio(real inertia_ratio)
{
    return inertia_ratio / (1 + inertia_ratio);
}

/* The beginning of a cycle, in units of the head. */
struct launch {
    real fuel;           /* P, the fuel that the train uses */
    real J0;             /* J(0) */
    real inertia_ratio;  /* T of the collision */
    real velocity_ratio; /* omega(0) / omega_1(theta_c) */
    real omegasq;        /* tau^2 omega(0)^2 */
    real kinetic;        /* J(0) tau^2 omega(0)^2 */
    real arrives;        /* kinetic energy at theta_c, of a train that reaches theta_c */
};

/* The beginning of a motion, at the tilt `from` of the head. */
struct start {
    struct tilt from;
    real J;             /* inertia of all moving dominoes (20; c2) */
    real omegasq;       /* tau^2 omega^2 */
    real kinetic;       /* J omegasq */
    real kinetic_error; /* bound of the error of `kinetic` */
};

struct dynamics {
    /* True if the energy H of position decides: then the barrier is the maximum of H, found by Newton's
     * method. */
    bool conservative;

    /* Optional: allocate and free the memory of the law. May return DOM_NO_MEMORY. */
    enum dom_status (*begin)(struct geometry *geometry);
    void (*end)(struct geometry *geometry);

    /* Optional: solves the motion over a whole cycle, unless an earlier call has solved it. */
    enum dom_status (*solve)(const struct geometry *geometry);
    /*
     * Optional: solves the motion over [lo, *hi] alone, where J is the inertia at lo. Returns DOM_LOCKS if no
     * motion gets beyond a tilt, which is then written to *hi.
     */
    enum dom_status (*solve_piece)(const struct geometry *geometry, real J, real lo, real *hi);
    /*
     * Optional: narrows the search for the end of a motion that uses up its energy before *hi, and sets *hi
     * to a tilt soon after that end. `edge` has the ends of the piece of the motion that contains `start`.
     */
    enum dom_status (*spent)(const struct geometry *geometry, const struct start *start, const real edge[2],
                             real *hi);
    /* Optional: finds whether a motion that locks is braked there (true) or driven (false). */
    enum dom_status (*braked)(const struct geometry *geometry, struct tilt head, bool *braked);

    /* Finds the cycle of a train that repeats itself (24; c6), with bounds unless error is NULL. */
    enum dom_status (*collide)(const struct geometry *geometry, enum dom_fuel fuel, struct launch *launch,
                               struct launch *error);
    /*
     * Finds the inertia ratio of a collision in which `hitting`, with its head at `at` and the inertia J,
     * hits the upright domino of `next`. Returns DOM_UNDERFLOW or DOM_LOCKS if the ratio is not positive.
     */
    enum dom_status (*inertia_ratio)(const struct geometry *next, const struct geometry *hitting,
                                     struct tilt at, real J, real *inertia_ratio);

    /* Finds the derivative of the required energy at a tilt, which is dH/dtheta without friction. If `rough`,
     * only its sign is right. */
    enum dom_status (*slope)(const struct geometry *geometry, struct tilt head, bool rough, real *slope);
    /* Finds the kinetic energy at the tilt `from` that is just enough to reach the tilt 2 atan p. */
    enum dom_status (*required_energy)(const struct geometry *geometry, struct tilt from, real p,
                                       real *energy);
    /* Optional: returns an estimate of the errors of required energies. They may be large compared with a
     * small barrier, which is the difference of larger energies. */
    real (*unsure)(const struct geometry *geometry);
    /* Finds tau^2 omega^2 at a tilt, with its bound unless error is NULL. */
    enum dom_status (*speed)(const struct geometry *geometry, const struct start *start, real theta,
                             real *omegasq, real *error);
    /* Finds 1 / (tau^2 omega^2) at the tilt end - by, where `end` is the tilt at which the energy is used up.
     * Writes NaN if there is no such value. */
    enum dom_status (*before_rest)(const struct geometry *geometry, real end, real by, real *slowness);
    /* Finds tau^2 times the acceleration of the head where tau^2 omega^2 is w. *n, unless n is NULL, gets the
     * number of dominoes that matter. */
    enum dom_status (*acceleration)(const struct geometry *geometry, struct tilt head, real w,
                                    real *acceleration, size_t *n);
    /* Returns d omegasq / d omegasq(launch) at a tilt with the inertia J_at. `gain` is this derivative at the
     * start. */
    real (*gain)(const struct geometry *geometry, const struct start *start, real gain, real theta,
                 real J_at);
};

/* Returns true if error bounds are known, and bounds between samples guide the searches for limits. If not,
 * error bounds are NaN and searches use samples alone. */
KERNEL inline bool dynamics_bounded(const struct geometry *geometry)
{
    return geometry->dynamics->conservative && geometry->law->closed_form;
}

#endif
