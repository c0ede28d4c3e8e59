/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Proofs that no contact of a chain opens while its head moves: the function `pushes` of struct contact_law.
 */
#include "geometry/rounded.h"

/*
 * Returns true if bounds prove that a contact meets the conditions derived below during the whole motion of
 * its leader from b to a. If every contact of a chain meets these conditions, all contacts stay closed. The
 * reason is as follows.
 *
 * Multiply the torque on each domino by its factor S. (See dynamics/losses.h; without friction, S =
 * theta'.) Add up these products for domino i and all dominoes behind it. In this sum, the contacts between
 * these dominoes cancel. Only gravity and the contact of domino i with its leader remain. So the force of
 * this contact, multiplied by S_i b_i > 0, is the sum over k >= i of
 *
 *     I_k S_k theta_k' [(a_k - <a>) + (c_k - <c>) w],   w = tau^2 omega^2,
 *     a_k = (weight g)_k / (I_k theta_k'),   c_k = -theta_k'' / theta_k'.
 *
 * Here g = -h'/2. The brackets <> denote the mean over the chain with the weights I S theta'. The
 * acceleration of the whole chain is <a> + <c> w. Suppose that neither a_k nor c_k decreases down the chain.
 * Then this sum is not negative for any i, and all contacts push, at every speed.
 *
 * The condition on c_k: from domino k to its follower, c_k increases by r L (y_1 + theta_1' x X) / Y^2 times
 * theta_k' / theta_1' (link_second_derivative). Here theta_1' >= 0 is the slope of the contact, and y_1 =
 * Y y - X x is the follower's cosine.
 *
 * The condition on a_k: a_k does not decrease if f = (weight/inertia) g_1 - theta_1' g >= 0. With R =
 * weight/inertia,
 *
 *     2 f = x [R (h1.y Y + h1.x X) - theta_1' h.y] + y [R (h1.y X - h1.x Y) + theta_1' h.x].
 *
 * On the way from b to a, X and theta_1' decrease. Y increases while X >= 0. So the values at a and b bound
 * every term.
 *
 * The arm of the force on the leader must not be negative. This arm decreases, too, so only the arm at a is
 * tested. If a leader leans backwards, none of this holds, and the test fails.
 */
static bool pushes_between(const struct link *a, const struct link *b)
{
    const struct geometry *self = a->geometry, *next = self->follower ? self->follower : self;
    const real X = a->contact.X, Y = fmin(a->contact.Y, b->contact.Y), Y_most = X < 0 ? 1 : a->contact.Y;
    const real less = fmin(X, 0), R = self->weight / self->inertia;
    const real of_x = R * (next->h.y * Y + fmin(next->h.x * X, next->h.x * b->contact.X)) -
                      b->contact_slope * self->h.y,
               of_y = R * (next->h.y * X - fmax(next->h.x * Y, next->h.x * Y_most)) +
                      fmin(a->contact_slope * self->h.x, b->contact_slope * self->h.x);
    return b->tilt.x >= 0 && a->tilt.y >= 0 && a->contact.Y * a->tilt.y - X * a->tilt.x + less >= 0 &&
           Y + self->mu * less > 0 && contact_arm_a(a) >= 0 && self->h.y > 0 && next->h.y > 0 &&
           fmin(a->tilt.x * of_x, b->tilt.x * of_x) + fmin(a->tilt.y * of_y, b->tilt.y * of_y) >= 0;
}

/* Returns true if pushes_between proves that the contact passes the test of law->pushes while the leader
 * moves from b to a. If there is no proof for the whole motion, tries both halves of the motion, because the
 * bounds are tighter there. A motion is halved at most `halvings` times in succession. */
static bool pushes_within(const struct link *a, const struct link *b, int halvings)
{
    if (pushes_between(a, b))
        return true;
    const real x = a->tilt.x + b->tilt.x, y = a->tilt.y + b->tilt.y, size = hypot(x, y);
    if (halvings == 0 || !(size > 0))
        return false;
    struct link middle = *a;
    middle.tilt = tilt_make(x / size, y / size);
    link_geometry(&middle);
    return pushes_within(&middle, b, halvings - 1) && pushes_within(a, &middle, halvings - 1);
}

enum { PUSHES_HALVINGS = 4 };

KERNEL bool contact_pushes(const struct link *a, const struct link *b)
{
    return pushes_within(a, b, PUSHES_HALVINGS);
}

/* Returns the smallest value of `a` * u for u in [lo, hi]. */
static real least_product(real a, real lo, real hi)
{
    return fmin(a * lo, a * hi);
}

/*
 * Does for rounded edges what pushes_between does for sharp edges: tests a contact while
 * its leader moves from b to a. Again, the test passes if neither a_k nor c_k decreases down the chain. But
 * with rounded edges, the inertia i changes with the tilt. So a_k has i_k in its denominator, and
 *
 *     c_k = -theta_k'' / theta_k' - i'_k theta_k' / (2 i_k).
 *
 * The condition on c_k: let x and y be the sine and cosine of the leader's tilt. The quantities b, arm, curve
 * and M are those of rounded_levers. c_k does not decrease if
 *
 *     -curve b >= arm (slope i'_1/i_1 - i'/i) / 2.
 *
 * To bound the left side, let p = 1 - slope, Q = L - rho_1 turn and D = rho - rho_1 (`more`). By the contact
 * equation, the left side -curve b is
 *
 *     (1 - p^2) y Q + p^2 d + 2 rho_1 x p - D [y (1 - theta) + p^2 (1 - x - y + theta y) - x].
 *
 * The expression in square brackets lies between -2 and 1.16. The first two terms are a weighted mean of y Q
 * and d. If y Q < d/2, then x is large. Since p = x (M - rho_1 turn) / b, p is then large, too.
 *
 * The arm decreases as the tilt increases. The rate at which it decreases is the expression above for
 * -curve b, with p in place of p^2 and 1 + p in place of 2 p. The slope and the turn decrease, too. So the
 * values at both ends bound every term.
 *
 * The condition on a_k is nearly the same as for sharp edges. R i/i_1 takes the place of R, and there is one
 * more term for a foot that rolls down a slope.
 */
static bool rolling_pushes_between(const struct walk *a, const struct walk *b)
{
    const struct geometry *self = a->link.geometry, *next = self->follower ? self->follower : self;
    const struct rounded *of = &self->rounded, *by = &next->rounded;
    const struct tilt A = a->link.tilt, B = b->link.tilt, A_1 = tilt_follower(A, a->link.contact),
                      B_1 = tilt_follower(B, b->link.contact);
    const real X = a->link.contact.X, less = fmin(X, 0), Y = fmin(a->link.contact.Y, b->link.contact.Y),
               Y_most = X < 0 ? 1 : a->link.contact.Y, slope = a->link.contact_slope,
               slope_most = b->link.contact_slope, arm_most = of->tall_1 + of->rho_1,
               more = of->rho - of->rho_1;
    const real Q = self->L - of->rho_1 * fmax(b->turn.angle, 0), M = Q - fmax(more, 0), low = self->d / 2,
               far = sqrt(fmax(1 - low * low / (Q * Q), 0)) * M / arm_most,
               mean = fmax(fmin(self->d, A.y * Q), fmin(low, self->d * far * far)),
               bends = mean - fmax((real)1.16 * more, -2 * more);
    /* Up to pi/2 the inertia is a concave function of the tilt. So on an interval of tilts, the inertia is
     * smallest at one of the two ends, and its derivative decreases. */
    const real i = fmin(geometry_inertia(self, A), geometry_inertia(self, B)),
               i_1 = fmin(geometry_inertia(next, A_1), geometry_inertia(next, B_1)),
               i_most = of->i.c + of->i.x + of->i.y, i_1_most = by->i.c + by->i.x + by->i.y,
               rolls = slope_most * fmax(geometry_inertia_slope(next, B_1), 0) / i_1 +
                       fmax(-geometry_inertia_slope(self, A), 0) / i;
    const real R = self->weight / self->inertia * i / i_1_most,
               R_most = self->weight / self->inertia * i_most / i_1;
    const real of_x = least_product(next->h.y * Y + fmin(next->h.x * X, next->h.x * b->link.contact.X), R,
                                    R_most) -
                      slope_most * self->h.y,
               of_y = least_product(next->h.y * X - fmax(next->h.x * Y, next->h.x * Y_most), R, R_most) +
                      least_product(self->h.x, slope, slope_most),
               rest = least_product(-by->roll, R, R_most) + least_product(of->roll, slope, slope_most);
    return B.x >= 0 && A.y >= 0 && A_1.y >= 0 && B_1.x >= 0 && Y + self->mu * less > 0 && M > 0 && i > 0 &&
           i_1 > 0 && rounded_arms(&a->link).a >= 0 && bends >= rolls * slope_most * arm_most / 2 &&
           self->h.y > 0 && next->h.y > 0 &&
           least_product(of_x, B.x, A.x) + least_product(of_y, A.y, B.y) + rest >= 0;
}

enum { ROLLING_HALVINGS = 4 };

/* Returns true if rolling_pushes_between proves that the contact passes the test of law->pushes while the
 * leader moves from b to a. If there is no proof for the whole motion, tries both halves of the motion,
 * because the bounds are tighter there. A motion is halved at most `halvings` times in succession. */
static bool rolling_pushes(const struct walk *a, const struct walk *b, int halvings)
{
    if (rolling_pushes_between(a, b))
        return true;
    if (halvings == 0)
        return false;
    const struct walk middle = rounded_between(a, b);
    return rolling_pushes(&middle, b, halvings - 1) && rolling_pushes(a, &middle, halvings - 1);
}

KERNEL bool rounded_pushes(const struct walk *a, const struct walk *b)
{
    return rolling_pushes(a, b, ROLLING_HALVINGS);
}
