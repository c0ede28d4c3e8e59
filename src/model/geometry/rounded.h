/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Dominoes whose edges are rounded with the radius rho, over the height. The foot rolls on the floor without
 * slipping, and the round upper edge of a follower slides down the flat back of its leader; the lower edge at
 * the back stays sharp. With l = 1 - 2 rho the potential energy of a domino is
 *
 *     h(theta) = 2 rho + l cos theta + (d - 2 rho) sin theta,
 *
 * on a floor that slopes by alpha with theta + alpha for theta, and less 2 rho theta sin alpha,
 * since the foot rolls down. The inertia is that about the line of contact with the floor. With rho_1 and l_1
 * of the follower, over the height of the leader, and delta = theta_1 - theta, the contact obeys
 *
 *     l_1 sin delta + rho_1 delta cos theta = L cos theta - d
 *                                             + (rho - rho_1) (1 - cos theta - sin theta + theta cos theta).
 *
 * The loops have their own passes (rolling.c), so that sharp edges cost no test in a loop.
 */
#ifndef DOM_ROUNDED_H
#define DOM_ROUNDED_H

#include "geometry/sums.h"

/* The contact of a domino with its follower, as in geometry_contact, with two more derivatives. */
struct rolling {
    struct contact contact;
    real turn;  /* theta_1 - theta */
    real b;     /* arm of the contact force on the follower */
    real curve; /* d2 theta_1 / d theta2 */
};

/* A domino of the chain, with its tilt also as an angle. */
struct roller {
    struct link link;
    struct rolling rolling;
    real theta, second_derivative;
};

/* Rounds the edges: radius rho, over the height. Needs geometry->d and gravity. DOM_NO_ROUND: rho is above
 * d/2. */
KERNEL enum dom_status rounded_edges(struct geometry *geometry, real rho);

/* Finds the joint of a domino in a row with its follower, and where it hits the next one, `gap` before it,
 * over its height. */
KERNEL void rounded_joint(struct geometry *geometry, const struct geometry *follower);
KERNEL struct tilt rounded_hit(const struct geometry *geometry, real gap);

/* Returns h(0) - h(theta) of one domino. */
KERNEL real rounded_fall(const struct geometry *geometry, struct tilt t);

KERNEL struct roller roller_head(const struct geometry *geometry, struct tilt head);
KERNEL void roller_next(struct roller *k);
/* Returns one domino half way between two tilts. */
KERNEL struct roller roller_between(const struct roller *a, const struct roller *b);

/* Follow a chain outside of the loops, with edges of either kind. With sharp edges only
 * `link` has values. */
KERNEL struct roller roller_begin(const struct geometry *geometry, struct tilt head);
KERNEL void roller_follow(struct roller *k);
/* Makes the contact of a domino that rounding has detached. */
KERNEL void roller_touch(struct roller *k);

/* Return the arms of the contact of a domino with its follower, with friction, times r: contact_arm_a and
 * contact_arm_b for edges of either kind. */
KERNEL real link_arm_a(const struct link *k);
KERNEL real link_arm_b(const struct link *k);

/* Counts a pass. */
KERNEL void rounded_count(const struct geometry *geometry);

/* The passes of chain.h. */
KERNEL enum dom_status rolling_sum(const struct geometry *geometry, struct tilt head, bool sign,
                                   struct sums *sums);
KERNEL enum dom_status rolling_change(const struct geometry *geometry, struct tilt from, struct tilt head,
                                      real by, struct sums *sums);
/* Finds the same sums as rolling_change, and whether all contacts surely push (chain_pushes). */
KERNEL enum dom_status rolling_closed(const struct geometry *geometry, struct tilt from, struct tilt head,
                                      real by, struct sums *sums);
/* Finds J, H1 and half of dJ/dtheta. */
KERNEL enum dom_status rolling_rates(const struct geometry *geometry, struct tilt head, struct sums *sums,
                                     real *half_J1);

#endif
