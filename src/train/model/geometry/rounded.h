/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Dominoes with edges of radius rho. Lengths are divided by the height of the domino. The foot rolls on the
 * floor without slipping. The round upper edge of a follower slides down the flat back of its leader. The
 * lower edge at the back stays sharp.
 *
 * With l = 1 - 2 rho, the potential energy of a domino is
 *
 *     h(theta) = 2 rho + l cos theta + (d - 2 rho) sin theta.
 *
 * If the floor slopes by alpha, theta + alpha replaces theta in this formula. The foot also rolls down the
 * slope. For this reason, 2 rho theta sin alpha is subtracted.
 *
 * In the contact equation, rho_1 and l_1 are rho and l of the follower, divided by the height of the leader.
 * With delta = theta_1 - theta, the equation is
 *
 *     l_1 sin delta + rho_1 delta cos theta = L cos theta - d
 *                                             + (rho - rho_1) (1 - cos theta - sin theta + theta cos theta).
 *
 * The passes down a chain are in pass.c.
 */
#ifndef DOM_ROUNDED_H
#define DOM_ROUNDED_H

#include "geometry/law.h"

/* Returns h(0) - h(theta) for one domino. */
KERNEL real rounded_fall(const struct geometry *geometry, struct tilt t);

KERNEL struct walk rounded_begin(const struct geometry *geometry, struct tilt head);
KERNEL void rounded_next(struct walk *walk);

/*
 * rounded_next consists of three parts:
 * - rounded_factors updates theta_i', theta_i'' and the weights.
 * - rounded_step moves on to the follower, and finds the turn to the next follower. If only tilts are needed,
 *   this part is enough.
 * - rounded_levers finds the lever arms and the derivatives of the new contact.
 *
 * If two chains are walked down side by side, call each part for both chains before you call the next part.
 * The processor can then work on both turns at once.
 */
KERNEL void rounded_factors(struct walk *walk);
KERNEL void rounded_step(struct walk *walk);
KERNEL void rounded_levers(struct walk *walk);
KERNEL struct arms rounded_arms(const struct link *link);

/* Counts one more pass in geometry->work, under the effect 'edges'. */
KERNEL void rounded_count(const struct geometry *geometry);

#endif
