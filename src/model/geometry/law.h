/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The law of contact: how two dominoes touch, and how a chain of dominoes moves. There are two tables of
 * functions, one for sharp edges (sharp.c) and one for rounded edges (rounded.c). geometry->law points to the
 * table for a train or a row. This pointer is set once, when the geometry is prepared, and no other code
 * checks which kind of edges the dominoes have.
 */
#ifndef DOM_LAW_H
#define DOM_LAW_H

#include "geometry/sums.h"

/* The turn from a domino to its follower: the angle theta_1 - theta, and its sine and cosine. */
struct turn {
    real angle;
    struct tilt tilt;
};

/* The current domino of a walk down a chain, which starts at the head. With sharp edges only `link` is
 * set. */
struct walk {
    struct link link;
    struct turn turn;
    real b;                 /* lever arm of the contact force on the follower */
    real curve;             /* d2 theta_1 / d theta2 */
    real theta;             /* the tilt of the domino as an angle */
    real second_derivative; /* theta_i'' */
};

/* The lever arms of a contact (table 1), including friction, multiplied by r of the leader. */
struct arms {
    real a, b;  /* arms of the contact force on the leader and on the follower */
    real ratio; /* a / b, the part of a torque on the follower that the contact passes on to the leader */
};

/* One domino of a moving chain. forces.c computes the forces from an array of all dominoes of the chain. */
struct moving {
    struct link link;
    real second_derivative; /* theta_i'' */
    real size;              /* the height of the domino relative to that of the head */
    struct arms arms;       /* arms of the contact with the follower, if a follower leans on this domino */
    real force, impulse;    /* force and impulse of the contact with the follower, set by forces.c */
};

/* What a pass down the chain computes besides J, H1 and dH. */
enum pass {
    PASS_PLAIN = 0,
    PASS_ERROR = 1, /* bounds on the errors */
    /* the head is at theta_c, and each domino has the tilt that its follower had at the start of the cycle */
    PASS_SHIFT = 2,
    PASS_SECOND_DERIVATIVE = 4, /* H2 */
    PASS_PUSHES = 8,            /* tries to prove that all contacts push */
};

struct contact_law {
    /* True if a formula gives the follower's tilt from its leader's tilt, without iteration. Error bounds,
     * the bounds for strips of growths and the shortcuts for random rows exist only in this case. */
    bool closed_form;
    /* One search may visit at most this many dominoes in all its passes. This takes about a second in double
     * precision. */
    size_t work_most;

    /* ---- Preparing a train or a row ---- */

    /* Finds the characteristic tilts of a train, such as theta_c and theta_inf, for its separation and
     * growth. Returns DOM_OUT_OF_REACH if r s is too large. */
    enum dom_status (*set)(struct geometry *geometry);
    /* Prepares the contact of a domino in a row with its follower. NULL if the contact needs no preparation
     * beyond joint_shape in row/joint.c. */
    void (*joint)(struct geometry *geometry, const struct geometry *follower);
    /* Returns the tilt at which a head hits the next domino. `gap` is the gap between these two dominoes,
     * relative to the height of the head. */
    struct tilt (*hit)(const struct geometry *geometry, real gap);

    /* ---- One domino ---- */

    /* The inverse of theta_1: returns the leader's tilt for a given tilt of its follower, which must be >=
     * theta_c. */
    struct tilt (*leader)(const struct geometry *geometry, struct tilt follower);
    /* Returns h(0) - h(theta_f), the paper's fuel: the closed form of (25; c7). */
    real (*paper_fuel)(const struct geometry *geometry);
    /* Returns r s, where r is the smallest growth at which domino 1 tips over before it hits the next domino
     * (5; b0). */
    real (*tips_at)(const struct geometry *geometry);
    /* Returns tau_1^2 omega_1c^2 = h(theta_u) - h(theta_c) (9; b5) without cancellation, or 0 if domino 1 has
     * not tipped over. */
    real (*push)(const struct geometry *geometry);

    /* Finds the coefficients p[1], p[2], ... p[order] of tan((theta_1 - theta) / 2) as a power series in the
     * variable z of far.h. */
    void (*turns)(const struct geometry *geometry, int order, real *p);

    /* ---- A walk down a chain, domino by domino ---- */

    struct walk (*begin)(const struct geometry *geometry, struct tilt head);
    void (*next)(struct walk *walk);
    /* Finds the contact of a domino with its follower if the follower counts as detached only because of
     * rounding errors. */
    void (*touch)(struct walk *walk);
    struct arms (*arms)(const struct link *link);
    /* Tests the contact of one domino with its follower while the domino moves from b to a. If every contact
     * of a chain passes the test, all contacts stay closed. */
    bool (*pushes)(const struct walk *a, const struct walk *b);
    /* Fills `list` with the dominoes up to the end of the chain, but at most `room` of them, and returns
     * their number. */
    size_t (*list)(const struct geometry *geometry, struct tilt head, struct moving *list, size_t room);

    /* ---- Passes down a chain ---- */

    /* Finds a number that has the sign of H1, unless rounding errors hide the sign. The pass ends as soon as
     * the sign is certain. */
    enum dom_status (*sign)(const struct geometry *geometry, struct tilt head, real *H1);
    /* Finds J and H1. */
    enum dom_status (*sum)(const struct geometry *geometry, struct tilt head, struct sums *sums);
    /*
     * Finds J, H1 and H(head) - H(from), and the additional results that `pass` selects. Finds error bounds
     * (bound.h) unless error is NULL. t must be the tangent of half the angle from `from` to `head`. It is a
     * separate argument because the two tilts may be so close that they round to the same numbers. If `from`
     * is not upright, no domino may detach between the two tilts, and error must be NULL. PASS_SHIFT saves
     * half of the work for an endless train that moves from upright to theta_c.
     */
    enum dom_status (*change)(const struct geometry *geometry, struct tilt from, struct tilt head, real t,
                              enum pass pass, struct sums *sums, struct sums *error);
    /* Finds the sums at `head`, including H2, and the sums at theta_c, for an endless train from which no
     * domino detaches. NULL if this would be no faster than two calls of `change`. */
    enum dom_status (*both)(const struct geometry *geometry, struct tilt head, struct sums *sums,
                            struct sums *at_c);
    /* Finds J, H1 and half of dJ/dtheta. If `every` is true, every domino is visited, and no series replaces
     * the far tail. */
    enum dom_status (*rates)(const struct geometry *geometry, struct tilt head, bool every, struct sums *sums,
                             real *half_J1);
    /* Finds the equation of motion with friction. */
    enum dom_status (*equation)(const struct geometry *geometry, struct tilt head,
                                struct equation_of_motion *equation);
};

static const struct contact_law sharp_edges, rounded_edges;

/*
 * These two functions set up the geometry of a train. geometry_read computes everything that does not depend
 * on the separation and the growth. geometry_set then checks and sets the separation and the growth, and may
 * be called again with other values. dynamics_make calls both functions, and sets the law of motion.
 */
KERNEL struct geometry geometry_read(const struct request *train);
KERNEL enum dom_status geometry_set(struct geometry *geometry, real s, real r);

/* Sets gravity, and thus the potential energy of a domino with sharp edges. geometry->d must already be
 * set. */
KERNEL void geometry_gravity(struct geometry *geometry, real along, real down);

/* Gives the dominoes rounded edges of radius rho, relative to the height. geometry->d and gravity must
 * already be set. Returns DOM_NO_ROUND if the radius is above d/2. Only geometry_gravity and rounded_make set
 * geometry->law. */
KERNEL enum dom_status rounded_make(struct geometry *geometry, real rho);

/* Members of `sharp_edges` that are not defined in sharp.c. */
KERNEL enum dom_status sharp_change(const struct geometry *geometry, struct tilt from, struct tilt head,
                                    real t, enum pass pass, struct sums *sums, struct sums *error);
KERNEL enum dom_status sharp_both(const struct geometry *geometry, struct tilt head, struct sums *sums,
                                  struct sums *at_c);
KERNEL enum dom_status sharp_equation(const struct geometry *geometry, struct tilt head,
                                      struct equation_of_motion *equation);

/* Finds geometry->far_friction for an endless train with sharp edges from which no domino detaches. */
KERNEL void far_friction_make(struct geometry *geometry);

/* The test `pushes` of struct contact_law for sharp edges. sharp_change.c explains it. */
KERNEL bool contact_pushes(const struct link *a, const struct link *b);

#endif
