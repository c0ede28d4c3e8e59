/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Proofs that no contact of a chain opens while its head moves: contact_pushes. */
#include "geometry/chain.h"

/* Returns the smallest value of `a` * u for u in [lo, hi]. */
static real least_product(real a, real lo, real hi)
{
    return fmin(a * lo, a * hi);
}

/*
 * Returns true if bounds prove that a contact meets the conditions derived below during the whole motion of
 * its leader from b to a. If every contact of a chain meets these conditions, all contacts stay closed. The
 * reason is as follows.
 *
 * Multiply the torque on each domino by its factor S. (See dynamics/dynamics.h; without friction, S =
 * theta'.) Add up these products for domino i and all dominoes behind it. In this sum, the contacts between
 * these dominoes cancel. Only gravity and the contact of domino i with its leader remain. So the force of
 * this contact, multiplied by S_i b_i > 0, is the sum over k >= i of
 *
 *     I_k S_k theta_k' [(a_k - <a>) + (c_k - <c>) w],   w = tau^2 omega^2,
 *     a_k = (weight g)_k / (I_k theta_k'),   c_k = -theta_k'' / theta_k' - i'_k theta_k' / (2 i_k).
 *
 * Here g = -h'/2, and I_k contains the factor i_k of struct rounded, which is 1 with sharp edges. The
 * brackets <> denote the mean over the chain with the weights I S theta'. The acceleration of the whole chain
 * is <a> + <c> w. Suppose that neither a_k nor c_k decreases down the chain. Then this sum is not negative
 * for any i, and all contacts push, at every speed.
 *
 * The condition on c_k: let x and y be the sine and cosine of the leader's tilt. The quantities b, arm, curve
 * and M are those of rounded_levers; rho_1 is 0 with sharp edges. c_k does not decrease if
 *
 *     -curve b >= arm (slope i'_1/i_1 - i'/i) / 2.
 *
 * With sharp edges, the left side is at least 0, and the right side is 0. To bound the left side with rounded
 * edges, let p = 1 - slope, Q = L - rho_1 turn and D = rho - rho_1 (`more`). By the contact equation, the
 * left side -curve b is
 *
 *     (1 - p^2) y Q + p^2 d + 2 rho_1 x p - D [y (1 - theta) + p^2 (1 - x - y + theta y) - x].
 *
 * The expression in square brackets lies between -2 and 1.16. The first two terms are a weighted mean of y Q
 * and d. If y Q < d/2, then x is large. Since p = x (M - rho_1 turn) / b, p is then large, too.
 *
 * The arm decreases as the tilt increases. The rate at which it decreases is the expression above for
 * -curve b, with p in place of p^2 and 1 + p in place of 2 p. The slope, the turn and X decrease, too. Y
 * increases while X >= 0. So the values at a and b bound every term. Only the arm at a is tested: it must not
 * be negative. If a leader leans backwards, none of this holds, and the test fails.
 *
 * The condition on a_k: a_k does not decrease if f = R g_1 - theta_1' g >= 0 with R = weight/inertia i/i_1,
 *
 *     2 f = x [R (h1.y Y + h1.x X) - theta_1' h.y] + y [R (h1.y X - h1.x Y) + theta_1' h.x]
 *           - R roll_1 + theta_1' roll.
 */
KERNEL_LOOP bool pushes_by(const struct link *a, const struct link *b, const bool rolls)
{
    const struct geometry *self = a->geometry, *next = self->follower ? self->follower : self;
    const struct tilt A = a->tilt, B = b->tilt, A_1 = tilt_follower(A, a->contact);
    const real X = a->contact.X, less = fmin(X, 0), Y = fmin(a->contact.Y, b->contact.Y),
               Y_most = X < 0 ? 1 : a->contact.Y, slope = a->contact.slope, slope_most = b->contact.slope;
    real R = self->weight / self->inertia, R_most = R, rest = 0;
    const struct arms arms = link_arms(a, rolls);
    if (!(B.x >= 0 && A.y >= 0 && A_1.y >= 0 && Y + self->mu * less > 0 && arms.a >= 0 && self->h.y > 0 &&
          next->h.y > 0))
        return false;
    if (rolls) {
        const struct rounded *of = &self->rounded, *by = &next->rounded;
        const struct tilt B_1 = tilt_follower(B, b->contact);
        const real Q = self->L - of->rho_1 * fmax(b->turn.angle, 0), more = of->rho - of->rho_1,
                   M = Q - fmax(more, 0), low = self->d / 2, arm_most = of->tall_1 + of->rho_1,
                   far = sqrt(fmax(1 - low * low / (Q * Q), 0)) * M / arm_most,
                   mean = fmax(fmin(self->d, A.y * Q), fmin(low, self->d * far * far)),
                   bends = mean - fmax((real)1.16 * more, -2 * more);
        /* Up to pi/2 the inertia is a concave function of the tilt. So on an interval of tilts, the inertia
         * is smallest at one of the two ends, and its derivative decreases. */
        const real i = fmin(geometry_inertia(self, A), geometry_inertia(self, B)),
                   i_1 = fmin(geometry_inertia(next, A_1), geometry_inertia(next, B_1)),
                   grows = slope_most * fmax(geometry_inertia_slope(next, B_1), 0) / i_1 +
                           fmax(-geometry_inertia_slope(self, A), 0) / i;
        if (!(B_1.x >= 0 && M > 0 && i > 0 && i_1 > 0 && bends >= grows * slope_most * arm_most / 2))
            return false;
        R_most = R * (of->i.c + of->i.x + of->i.y) / i_1;
        R *= i / (by->i.c + by->i.x + by->i.y);
        rest = least_product(-by->roll, R, R_most) + least_product(of->roll, slope, slope_most);
    }
    const real of_x =
                   least_product(next->h.y * Y + fmin(next->h.x * X, next->h.x * b->contact.X), R, R_most) -
                   slope_most * self->h.y,
               of_y = least_product(next->h.y * X - fmax(next->h.x * Y, next->h.x * Y_most), R, R_most) +
                      least_product(self->h.x, slope, slope_most);
    return least_product(of_x, B.x, A.x) + least_product(of_y, A.y, B.y) + rest >= 0;
}

KERNEL_SHARED bool contact_pushes(const struct link *a, const struct link *b, int halvings)
{
    if (a->geometry->rolls ? pushes_by(a, b, true) : pushes_by(a, b, false))
        return true;
    const real x = a->tilt.x + b->tilt.x, y = a->tilt.y + b->tilt.y, size = hypot(x, y);
    if (halvings == 0 || !(size > 0))
        return false;
    struct link middle = *a;
    middle.tilt = tilt_make(x / size, y / size);
    if (a->geometry->rolls)
        middle.theta = (a->theta + b->theta) / 2;
    link_touch(&middle);
    return contact_pushes(&middle, b, halvings - 1) && contact_pushes(a, &middle, halvings - 1);
}
