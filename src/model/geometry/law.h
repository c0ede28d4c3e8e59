/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * How two dominoes touch, and what follows from that along a chain: one table of functions for sharp edges
 * (sharp.c) and one for rounded edges (rounded.c). geometry->law is the table of a train or a row. It is set
 * once, where the geometry is prepared, and no other code asks which kind of edges the dominoes have.
 */
#ifndef DOM_LAW_H
#define DOM_LAW_H

#include "geometry/sums.h"

/* The contact of a domino with its follower, as in geometry_contact, with two more derivatives. */
struct rolling {
    struct contact contact;
    real turn;  /* theta_1 - theta */
    real b;     /* lever arm of the contact force on the follower */
    real curve; /* d2 theta_1 / d theta2 */
};

/* A domino of a chain that is followed from the head down. With sharp edges only `link` is set. */
struct walk {
    struct link link;
    struct rolling rolling;
    real theta;             /* the tilt as an angle */
    real second_derivative; /* theta_i'' */
};

/* The lever arms of a contact (table 1), with friction and times r of the leader. */
struct arms {
    real a, b;  /* of the contact force on the leader, and on the follower */
    real ratio; /* a / b, the part of a torque on the follower that the contact passes on to the leader */
};

/* One domino of a chain that is listed as a whole, to find the forces in it. */
struct moving {
    struct link link;
    real second_derivative; /* theta_i'' */
    real size;              /* the height of the domino over that of the head */
    struct arms arms;       /* of the contact with its follower, if one leans on it */
    real force, impulse;    /* of that contact: forces.c finds them */
};

/* What a pass down the chain computes besides J, H1 and dH. */
enum pass {
    PASS_PLAIN = 0,
    PASS_ERROR = 1,             /* bounds of the errors */
    PASS_SHIFT = 2,             /* the head is at theta_c, where every follower is where its leader was */
    PASS_SECOND_DERIVATIVE = 4, /* H2 */
    PASS_PUSHES = 8,            /* whether all contacts surely push */
};

struct contact_law {
    /* True if the tilt of a follower is a closed form of the tilt of its leader. Error bounds, the series of
     * the far tail, bounds for strips of growths and the shortcuts of random rows are derived from it. */
    bool closed_form;
    size_t work_most; /* the most dominoes in all passes of one search, which take a second in double */

    /* ---- Preparing a train or a row ---- */

    /* Finds the tilts of a train for its separation and growth. DOM_OUT_OF_REACH: r s is too large. */
    enum dom_status (*set)(struct geometry *geometry);
    /* Finds the joint of a domino in a row with its follower. NULL: joint_shape has found all of it. */
    void (*joint)(struct geometry *geometry, const struct geometry *follower);
    /* Returns the tilt at which a head hits the next domino, `gap` before it, over the height of the head. */
    struct tilt (*hit)(const struct geometry *geometry, real gap);

    /* ---- One domino ---- */

    /* Returns the leader's tilt for a follower's tilt >= theta_c: the inverse of theta_1. */
    struct tilt (*leader)(const struct geometry *geometry, struct tilt follower);
    /* Returns h(0) - h(theta_f), the paper's fuel: the closed form of (25; c7). */
    real (*paper_fuel)(const struct geometry *geometry);
    /* Returns r s at the smallest growth at which domino 1 has tipped over when it hits (5; b0). */
    real (*tips_at)(const struct geometry *geometry);
    /* Returns tau_1^2 omega_1c^2 = h(theta_u) - h(theta_c) (9; b5), without cancellation. Returns 0 if
     * domino 1 has not tipped over. */
    real (*push)(const struct geometry *geometry);

    /* ---- A chain, domino by domino, outside of the passes ---- */

    struct walk (*begin)(const struct geometry *geometry, struct tilt head);
    void (*next)(struct walk *walk);
    /* Finds the contact of a domino that rounding has detached. */
    void (*touch)(struct walk *walk);
    struct arms (*arms)(const struct link *link);
    /* Lists the dominoes up to the end of the chain, or as far as there is room; returns their number. */
    size_t (*list)(const struct geometry *geometry, struct tilt head, struct moving *list, size_t room);

    /* ---- Passes down a chain ---- */

    /* Finds the sign of H1 alone, right to rounding, from as few dominoes as the sign needs. */
    enum dom_status (*sign)(const struct geometry *geometry, struct tilt head, real *H1);
    /* Finds J and H1. */
    enum dom_status (*sum)(const struct geometry *geometry, struct tilt head, struct sums *sums);
    /* Finds J, H1 and dH, with bounds of their errors (bound.h) unless error is NULL. PASS_SHIFT saves half
     * of the work for an endless train whose head is at theta_c. */
    enum dom_status (*change)(const struct geometry *geometry, struct tilt head, enum pass pass,
                              struct sums *sums, struct sums *error);
    /* Finds J, H1, H(head) - H(from), and what the pass asks for. If `from` is not upright, no domino may
     * detach between the two tilts. */
    enum dom_status (*change_from)(const struct geometry *geometry, struct tilt from, struct tilt head,
                                   enum pass pass, struct sums *sums);
    /* Finds the same sums where the head is `by` farther than `from`; `by` may be too small to change the
     * tilt. */
    enum dom_status (*change_by)(const struct geometry *geometry, struct tilt from, struct tilt head, real by,
                                 struct sums *sums);
    /* Finds the sums at `head` with H2, and those at theta_c, for an endless train from which no domino
     * detaches. */
    enum dom_status (*both)(const struct geometry *geometry, struct tilt head, struct sums *sums,
                            struct sums *at_c);
    /* Finds J, H1 and half of dJ/dtheta. If every domino counts, no series replaces the far tail. */
    enum dom_status (*rates)(const struct geometry *geometry, struct tilt head, bool every, struct sums *sums,
                             real *half_J1);
    /* Finds the equation of motion with friction; and its C alone, to the relative tolerance tol. */
    enum dom_status (*equation)(const struct geometry *geometry, struct tilt head,
                                struct equation_of_motion *equation);
    enum dom_status (*drive)(const struct geometry *geometry, struct tilt head, real tol, real *drive);
};

static const struct contact_law sharp_edges, rounded_edges;

/*
 * Make the geometry of a train in two steps: first all but separation and growth, then separation and growth,
 * as often as needed, with a check. dynamics_make does both, and adds the law of motion.
 */
KERNEL struct geometry geometry_read(const struct request *train);
KERNEL enum dom_status geometry_set(struct geometry *geometry, real s, real r);

/* Sets gravity, and with it the energy of position of a domino with sharp edges. Needs geometry->d. */
KERNEL void geometry_gravity(struct geometry *geometry, real along, real down);

/* Rounds the edges with a radius over the height. Needs geometry->d and gravity. DOM_NO_ROUND: the radius is
 * above d/2. geometry_gravity and rounded_make alone set geometry->law. */
KERNEL enum dom_status rounded_make(struct geometry *geometry, real rho);

/* The passes of the two laws that have files of their own (sharp_change.c, sharp_friction.c, rolling.c,
 * rolling_friction.c). */
KERNEL enum dom_status sharp_change(const struct geometry *geometry, struct tilt head, enum pass pass,
                                    struct sums *sums, struct sums *error);
KERNEL enum dom_status sharp_change_from(const struct geometry *geometry, struct tilt from, struct tilt head,
                                         enum pass pass, struct sums *sums);
KERNEL enum dom_status sharp_change_by(const struct geometry *geometry, struct tilt from, struct tilt head,
                                       real by, struct sums *sums);
KERNEL enum dom_status sharp_both(const struct geometry *geometry, struct tilt head, struct sums *sums,
                                  struct sums *at_c);
KERNEL enum dom_status sharp_equation(const struct geometry *geometry, struct tilt head,
                                      struct equation_of_motion *equation);
KERNEL enum dom_status sharp_drive(const struct geometry *geometry, struct tilt head, real tol, real *drive);

/* Finds geometry->far_friction for an endless train with sharp edges from which no domino detaches. */
KERNEL void far_friction_make(struct geometry *geometry);

/* Returns true if one contact of sharp edges surely does its part to keep all contacts closed while its
 * leader moves from b to a. */
KERNEL bool contact_pushes(const struct link *a, const struct link *b);

#endif
