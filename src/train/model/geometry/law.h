/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The law of contact: how two dominoes touch, and how a chain moves. There is a table of functions for sharp
 * edges (sharp.c) and one for rounded edges (rounded.c). geometry->law points to the table that applies, so
 * that other code works with both kinds of edges.
 */
#ifndef DOM_LAW_H
#define DOM_LAW_H

#include "geometry/sums.h"

/* The turn from a domino to its follower: theta_1 - theta, as an angle and as a tilt. */
struct turn {
    real angle;
    struct tilt tilt;
};

/* The current domino of a walk down a chain. */
struct walk {
    struct link link;
    real second_derivative; /* theta_i'' */
    real curve;             /* d2 theta_1 / d theta2 */
    /* Only with rounded edges: */
    struct turn turn;
    real b;     /* lever arm of the contact force on the follower */
    real theta; /* the tilt of the domino as an angle */
};

/* The lever arms of a contact (table 1), multiplied by r of the leader. */
struct arms {
    real a, b;    /* arms of the force on the leader and on the follower */
    real b_plain; /* b without friction */
    real ratio;   /* a / b: the part of a torque that the follower passes on to its leader */
};

/* The kinds of passes that compare two tilts of the head. Each pass computes J, H1 and dH. */
enum pass {
    PASS_PLAIN,
    PASS_SECOND_DERIVATIVE, /* also H2 */
    PASS_PUSHES,            /* also tries to prove that all contacts push */
};

struct contact_law {
    /* True if edges are rounded, so that dominoes roll. If false, a formula gives the follower's tilt. */
    bool rolls;
    /* The maximum number of dominoes that a search may visit. In double, this takes about a second. */
    size_t work_most;

    /* ---- Preparing a train or a row ---- */

    /* Finds the tilts of a train, such as theta_c and theta_inf, for its s and r. Returns DOM_OUT_OF_REACH if
     * r s is too large. */
    enum dom_status (*set)(struct geometry *geometry);
    /* Prepares the contact of a domino in a row. NULL if joint_shape (row/joint.c) is enough. */
    void (*joint)(struct geometry *geometry, const struct geometry *follower);
    /* Returns the tilt at which a head hits the next domino. `gap` is in units of the head's height. */
    struct tilt (*hit)(const struct geometry *geometry, real gap);

    /* ---- One domino ---- */

    /* Returns the leader's tilt for a given tilt (>= theta_c) of its follower. */
    struct tilt (*leader)(const struct geometry *geometry, struct tilt follower);
    /* Returns h(0) - h(theta_f), the paper's fuel (25; c7). */
    real (*paper_fuel)(const struct geometry *geometry);
    /* Returns tau_1^2 omega_1c^2. Here omega_1c is the angular velocity that domino 1 has at theta_c after it
     * has tipped over by itself, so theta_c must be at least theta_u. With sharp edges, the result is
     * h(theta_u) - h(theta_c), by equation (9; b5). */
    real (*tipped_omegasq)(const struct geometry *geometry);

    /* Finds the coefficients p[1] to p[order] of a power series for tan((theta_1 - theta) / 2): the sum of
     * p[k] z^k. The variable z is far_variable (far.h). */
    void (*turns)(const struct geometry *geometry, int order, real *p);

    /* ---- A walk down a chain, domino by domino ---- */

    struct walk (*begin)(const struct geometry *geometry, struct tilt head);
    void (*next)(struct walk *walk);
    /* Finds the contact with the follower, even if the follower counts as detached. */
    void (*touch)(struct walk *walk);
    struct arms (*arms)(const struct link *link);
};

static const struct contact_law sharp_edges, rounded_edges;

/*
 * These two functions set up the geometry of a train, except for the law of motion, which dynamics_make sets
 * up. geometry_read computes everything that does not depend on the separation and the growth. geometry_set
 * then checks the separation and the growth, and sets what depends on them. geometry_set may be called again
 * with other values.
 */
KERNEL struct geometry geometry_read(const struct request *train);
KERNEL enum dom_status geometry_set(struct geometry *geometry, real s, real r);

/* Sets gravity and gives the dominoes sharp edges. geometry->d must be set. */
KERNEL void geometry_gravity(struct geometry *geometry, real along, real down);

/* Gives the dominoes rounded edges. rho is the radius of the edges divided by the height. Before the call,
 * gravity, geometry->d and geometry->inertia_factor must be set. If rho > d/2, returns DOM_NO_ROUND. */
KERNEL enum dom_status rounded_make(struct geometry *geometry, real rho);

/* The function `arms` of sharp edges. */
KERNEL struct arms sharp_arms(const struct link *link);

/* ---- Passes down a chain ---- */

/* Finds J and H1. */
KERNEL enum dom_status chain_sum(const struct geometry *geometry, struct tilt head, struct sums *sums);

/* Finds H1. If `sign` is true, only its sign is reliable, and the pass ends early. */
KERNEL enum dom_status chain_slope(const struct geometry *geometry, struct tilt head, bool sign, real *H1);

/*
 * Finds J, H1 and H(head) - H(from), and also what `pass` selects (see enum pass; the constants cannot be
 * combined).
 * - t is the tangent of half the angle between the tilts `from` and `head`. The caller passes t, because
 *   computing t here from two close tilts would be inaccurate.
 * - If the tilt `from` is not upright, no domino may detach between the two tilts.
 */
KERNEL enum dom_status chain_change_by(const struct geometry *geometry, struct tilt from, struct tilt head,
                                       real t, enum pass pass, struct sums *sums);

/* Finds J at theta_c, and H(theta_c) - H(0), for a train. */
KERNEL enum dom_status chain_fuel(const struct geometry *geometry, struct sums *sums);

/* Finds the equation of motion. Without friction, A is J, B is half of dJ/dtheta, and C is -H1/2. */
KERNEL enum dom_status chain_equation(const struct geometry *geometry, struct tilt head,
                                      struct equation_of_motion *equation);

/*
 * Part of a proof that no contact of a chain opens while the head moves. Tests one contact while its leader
 * moves from b to a. If every contact of the chain passes its test, all of them stay closed during the
 * motion. If only some contacts pass, nothing is proved about any of them.
 */
KERNEL bool contact_pushes(const struct walk *a, const struct walk *b);

#endif
