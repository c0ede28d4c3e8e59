/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * How a train moves: the law of motion, as a table of functions.  energy_balance.c and friction.c each have
 * one; README.md in this folder says how to add an effect.
 */
#ifndef DOM_DYNAMICS_H
#define DOM_DYNAMICS_H

#include "geometry/chain.h"

/*
 * The collision (c4): the struck domino, upright, and the chain that hits it move on as one.  With the
 * inertia ratio T = r^-(q+1) J(theta_c), J the inertia of the chain (with friction S_1 A in its place), the
 * angular momentum that all the contacts pass on is kept:
 *
 *     (1 + T) omega(0) = T omega_1(theta_c).
 */
/* Returns omega(0) / omega_1(theta_c), what a collision keeps of the angular velocity. */
KERNEL real collision_velocity_ratio(real inertia_ratio)
{
    return inertia_ratio / (1 + inertia_ratio);
}

/* How a cycle begins, in units of the head. */
struct launch {
    real fuel;           /* P, the one in use */
    real J0;             /* J(0) */
    real inertia_ratio;  /* T of the collision */
    real velocity_ratio; /* omega(0) / omega_1(theta_c) */
    real omegasq;        /* tau^2 omega(0)^2 */
    real kinetic;        /* J(0) tau^2 omega(0)^2 */
    real arrives;        /* kinetic energy at theta_c, of a train that gets there */
};

/* What a motion begins with, at the tilt `from` of the head. */
struct start {
    struct tilt from;
    real J;             /* inertia of all that move (c2) */
    real omegasq;       /* tau^2 omega^2 */
    real kinetic;       /* J omegasq */
    real kinetic_error; /* bound of its error */
};

/* A contact between a domino and its follower (table 1). */
struct arms {
    real ratio; /* a / b: the share of a torque on the follower that the contact passes on to the leader */
    real b;     /* r times the arm on the follower */
};

struct dynamics {
    const struct dom_effect *text; /* name, equations, source */
    /*
     * True where the energy H of position decides: the barrier is the maximum of H, found by Newton's method,
     * error bounds are known, and bounds between samples lead the searches for limits.  Where it is false,
     * error bounds are NaN and searches use samples alone.
     */
    bool conservative;

    /* Optional: takes memory for the law, and gives it back.  DOM_NO_MEMORY where there is none. */
    enum dom_status (*begin)(struct geometry *geometry);
    void (*end)(struct geometry *geometry);

    /* Optional: solves the motion over a whole cycle, unless it is solved already. */
    enum dom_status (*solve)(const struct geometry *geometry);
    /*
     * Optional: solves the motion over [lo, *hi] alone, where J is the inertia at lo.  DOM_LOCKS: no motion
     * comes farther than *hi, which becomes that tilt.
     */
    enum dom_status (*solve_piece)(const struct geometry *geometry, real J, real lo, real *hi);
    /*
     * Optional: finds where to look for the end of a motion that is used up before *hi; *hi becomes a tilt
     * soon after it.  edge: the piece of the motion that start is in.
     */
    enum dom_status (*spent)(const struct geometry *geometry, const struct start *start, const real edge[2],
                             real *hi);
    /* Optional: where the motion locks, finds whether it is braked there, rather than driven. */
    enum dom_status (*braked)(const struct geometry *geometry, struct tilt head, bool *braked);

    /* The cycle of a train that repeats itself (c6); unless error is NULL, with bounds. */
    enum dom_status (*collide)(const struct geometry *geometry, enum dom_fuel fuel, struct launch *launch,
                               struct launch *error);
    /*
     * Inertia ratio of a collision: `hitting` leans at `at`, where its inertia is J, and hits the upright
     * domino of `next`.  DOM_UNDERFLOW, DOM_LOCKS: the ratio is not positive.
     */
    enum dom_status (*inertia_ratio)(const struct geometry *next, const struct geometry *hitting,
                                     struct tilt at, real J, real *inertia_ratio);

    /* Slope of the required energy at a tilt, dH/dtheta or what is in its place; rough: its sign alone. */
    enum dom_status (*slope)(const struct geometry *geometry, struct tilt head, bool rough, real *slope);
    /* Kinetic energy that it takes at the tilt `from` to come to the tilt 2 atan p. */
    enum dom_status (*required_energy)(const struct geometry *geometry, struct tilt from, real p,
                                       real *energy);
    /* tau^2 omega^2 at a tilt; unless error is NULL, with its bound. */
    enum dom_status (*speed)(const struct geometry *geometry, const struct start *start, real theta,
                             real *omegasq, real *error);
    /* 1 / (tau^2 omega^2) at the tilt `by` before `end`, where the motion is used up; NaN where there is
     * none. */
    enum dom_status (*before_rest)(const struct geometry *geometry, real end, real by, real *slowness);
    /* tau^2 times the acceleration of the head where tau^2 omega^2 is w; unless NULL, *n gets the number of
     * dominoes that matter. */
    enum dom_status (*acceleration)(const struct geometry *geometry, struct tilt head, real w,
                                    real *acceleration, size_t *n);
    /* d omegasq / d omegasq at the launch, at a tilt where the inertia is J_at; gain: the same at the start.
     */
    real (*gain)(const struct geometry *geometry, const struct start *start, real gain, real theta,
                 real J_at);
    /* Optional: the contact of a domino with its follower; without it the paper's, which has no friction. */
    struct arms (*arms)(const struct link *link);
};

KERNEL inline struct arms dynamics_arms(const struct dynamics *dynamics, const struct link *link)
{
    return dynamics->arms ? dynamics->arms(link) : (struct arms){.ratio = link->step, .b = link->contact.Y};
}

#endif
