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

/* The current domino of a walk down a chain. With sharp edges only `link` is set. */
struct walk {
    struct link link;
    struct turn turn;
    real b;                 /* lever arm of the contact force on the follower */
    real curve;             /* d2 theta_1 / d theta2 */
    real theta;             /* the tilt of the domino as an angle */
    real second_derivative; /* theta_i'' */
};

/* The lever arms of a contact (table 1) with friction, multiplied by r of the leader. */
struct arms {
    real a, b;  /* arms of the force on the leader and on the follower */
    real ratio; /* a / b: the part of a torque that the follower passes on to its leader */
};

/* One domino of a moving chain, for forces.c. */
struct moving {
    struct link link;
    real second_derivative; /* theta_i'' */
    real size;              /* height / height of the head */
    struct arms arms;       /* arms of the contact with the follower, if there is one */
    real force, impulse;    /* force and impulse of this contact, set by forces.c */
};

/* The kinds of passes down the chain. Each pass computes J, H1 and dH. */
enum pass {
    PASS_PLAIN = 0,
    /* For a head that falls from upright to theta_c. At the start, each follower has the tilt that its leader
     * will have at the end. So the chain at the start is the chain at the end, shifted by one domino, and
     * only one of the two must be computed. */
    PASS_SHIFT = 2,
    PASS_SECOND_DERIVATIVE = 4, /* also H2 */
    PASS_PUSHES = 8,            /* also tries to prove that all contacts push */
};

struct contact_law {
    /* True if a formula gives the follower's tilt directly, so that no iteration is needed. Shortcuts
     * for random rows exist only for such a law. */
    bool closed_form;
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
    /* Returns r s for the smallest growth at which domino 1 tips over by itself before it hits the next
     * domino (5; b0). */
    real (*tips_at)(const struct geometry *geometry);
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
    /* Finds the contact with a follower that counts as detached only because of rounding. */
    void (*touch)(struct walk *walk);
    struct arms (*arms)(const struct link *link);
    /* Part of a proof that no contact of a chain opens while the head moves. Tests one contact while its
     * leader moves from b to a. If every contact of the chain passes its test, all of them stay closed during
     * the motion. If only some contacts pass, nothing is proved about any of them. */
    bool (*pushes)(const struct walk *a, const struct walk *b);
    /* Lists the dominoes up to the end of the chain, but at most `room`. Returns their number. */
    size_t (*list)(const struct geometry *geometry, struct tilt head, struct moving *list, size_t room);

    /* ---- Passes down a chain ---- */

    /* Finds J and H1. */
    enum dom_status (*sum)(const struct geometry *geometry, struct tilt head, struct sums *sums);
    /*
     * Finds J, H1 and H(head) - H(from), and also what `pass` selects (see enum pass; the constants cannot be
     * combined).
     * - t is the tangent of half the angle between the tilts `from` and `head`. The caller passes t, because
     *   computing t here from two close tilts would be inaccurate.
     * - If the tilt `from` is not upright, no domino may detach between the two tilts.
     * - PASS_SHIFT may be used for an endless train that falls from upright to theta_c. It halves the work.
     */
    enum dom_status (*change)(const struct geometry *geometry, struct tilt from, struct tilt head, real t,
                              enum pass pass, struct sums *sums);
    /* Finds the sums at `head` (including H2) and the sums at theta_c, both in one pass. This is faster than
     * two calls of `change`. The train must be endless, and no domino may detach. */
    enum dom_status (*both)(const struct geometry *geometry, struct tilt head, struct sums *sums,
                            struct sums *at_c);
    /* Finds J, H1 and half of dJ/dtheta. With sharp edges, the far series usually replaces the dominoes of
     * the far tail. If `every` is true, or if the edges are rounded, the pass visits these dominoes, too. */
    enum dom_status (*rates)(const struct geometry *geometry, struct tilt head, bool every, struct sums *sums,
                             real *half_J1);
    enum dom_status (*equation)(const struct geometry *geometry, struct tilt head,
                                struct equation_of_motion *equation);
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

/* Members of `sharp_edges` that are not defined in sharp.c. */
KERNEL enum dom_status sharp_sum(const struct geometry *geometry, struct tilt head, struct sums *sums);
KERNEL enum dom_status sharp_rates(const struct geometry *geometry, struct tilt head, bool every,
                                   struct sums *sums, real *half_J1);
KERNEL enum dom_status sharp_change(const struct geometry *geometry, struct tilt from, struct tilt head,
                                    real t, enum pass pass, struct sums *sums);
KERNEL enum dom_status sharp_both(const struct geometry *geometry, struct tilt head, struct sums *sums,
                                  struct sums *at_c);
KERNEL enum dom_status sharp_equation(const struct geometry *geometry, struct tilt head,
                                      struct equation_of_motion *equation);

/* Finds geometry->far_friction for an endless train with sharp edges in which no domino detaches. */
KERNEL void far_friction_make(struct geometry *geometry);

/* The test `pushes` for sharp edges, explained in pushes.c. */
KERNEL bool contact_pushes(const struct link *a, const struct link *b);

#endif
