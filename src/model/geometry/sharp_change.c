/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Finds differences of the energy H between two chains with sharp edges. Each pass visits the dominoes of
 * both chains in parallel. Power series replace the far tails (far.h). */
#include "geometry/far.h"
#include "geometry/law.h"

/*
 * Returns h(A) - h(B): how much the potential energy of a domino differs between its tilts a and b, whose
 * angles are A and B. t is tan((A - B)/2). Subtracting two nearly equal energies would lose digits. So the
 * difference is computed as the product
 *
 *     2 sin((A - B)/2) [h.x cos((A + B)/2) - h.y sin((A + B)/2)].
 */
KERNEL_LOOP real energy_change(const struct geometry *geometry, struct tilt a, struct tilt b, real t)
{
    return t * (geometry->h.x * (a.y + b.y) - geometry->h.y * (a.x + b.x));
}

/*
 * Returns tan((theta_f - theta_1) / 2) for a follower that detaches later in the cycle. The follower is now
 * at theta_1, and its leader, the argument `leader`, is at theta. The follower detaches at theta_f, when the
 * leader reaches theta_leave. The formula of energy_change_between, applied to the leader's tilts theta_leave
 * and theta, gives the result. In this formula, Y at theta_leave is r L x, because the arm is 0 there. Let t
 * be tan((theta_leave - theta) / 2). Subtracting the two tilts could lose digits, so t is computed from the
 * arm of `leader`, which contains the factor
 *
 *     cos theta - cos theta_leave = (leave_at - leave_by v) / leave_by.
 */
static real leaving_half_turn(const struct geometry *geometry, const struct link *leader)
{
    real rL = geometry->r * geometry->L, x = leader->tilt.x, sines = geometry->leave.x + x,
         Y = leader->contact.Y;
    if (sines == 0) /* the follower is at theta_f from the start (r s = 1) */
        return 0;
    real t = leader->contact.arm * (Y + rL * x) / (geometry->leave_by * sines);
    real whole = rL * geometry->leave.x + Y, F = leader->contact.arm / whole, G = rL * sines / whole;
    return t * F / (1 + t * t * G);
}

KERNEL_LOOP real H2_term(const struct link *k, real second_derivative)
{
    return k->weight * (second_derivative * geometry_height_slope(k->geometry, k->tilt) -
                        k->slope * k->slope * geometry_height(k->geometry, k->tilt));
}

KERNEL_LOOP void pair_add(struct sum_state *state, const struct link *a, const struct link *b, real t)
{
    add_J(state, a);
    add_H1(state, a);
    series_add(&state->dH, a->weight * energy_change(a->geometry, a->tilt, b->tilt, t));
}

/* Returns true when the tails of dH, J and H1 can be left out. `shrink` is the result of pair_shrink. */
KERNEL_LOOP bool pair_done(struct sum_state *state, const struct link *a, real t, real shrink, real tol)
{
    real ratio = fmax(a->geometry->weight * shrink, a->geometry->decay);
    return series_done(&state->dH, a->weight * 2 * t * a->geometry->steepest, ratio, tol) &&
           done_J(state, a) && done_H1(state, a, tol);
}

/*
 * Returns true if bounds prove that a contact meets the conditions derived below during the whole motion of
 * its leader from b to a. If every contact of a chain meets these conditions, all contacts stay closed. The
 * reason is as follows.
 *
 * Multiply the torque on each domino by its factor S. (See dynamics/friction.c; without friction, S =
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

/*
 * Finds the sums of chain a, and H(head) - H(from). The head of chain a is at `head`, and the head of chain b
 * is at `from`. Subtracting two nearly equal energies would lose digits. So each domino's term of the
 * difference is computed from t = tan((theta_a - theta_b)/2), where theta_a and theta_b are its tilts in the
 * two chains. Since X_a - X_b = r L (y_a - y_b), the follower's t is exactly
 *
 *     t (1 - G) / (1 + t^2 G),   G = r L (x_a + x_b) / (Y_a + Y_b).
 *
 * G is a mean of the values of r L x / Y in the two chains. The slope of a contact is 1 - r L x / Y
 * (14; b10).
 */
KERNEL_LOOP enum dom_status energy_change_between(const struct geometry *geometry, struct tilt from,
                                                  struct tilt head, real t, const enum pass pass,
                                                  struct sums *sums)
{
    struct sum_state state = {0};
    struct link a = link_head(geometry, head), b = link_head(geometry, from);
    real H2 = 0, second_derivative = 0;
    bool pushes = true,
         closes = geometry->far.order > 0 && !geometry->follower && geometry->n == CHAIN_ENDLESS;
    for (;;) {
        enum dom_status status = chain_watch(geometry, a.i);
        if (status != DOM_OK)
            return status;
        if (closes && far_suffices(geometry, &state, &a, &b, t)) {
            struct far_point rest = far_add(geometry, &state, &a, &b, t);
            if (pass & PASS_SECOND_DERIVATIVE)
                H2 += far_H2(&a, second_derivative, &rest);
            break;
        }
        pair_add(&state, &a, &b, t);
        if (pass & PASS_SECOND_DERIVATIVE)
            H2 += H2_term(&a, second_derivative);
        if (a.i + 1 >= geometry->n || !b.leads)
            break;
        if (!a.leads) {
            /* The follower has detached in this cycle and stays at theta_f. */
            struct link leader = b;
            if (pass & PASS_SHIFT) {
                b.tilt = a.tilt;
                b.weight = a.weight * geometry->weight;
            } else {
                link_next(&b);
            }
            real t_f = leaving_half_turn(geometry, &leader);
            state.left = b.weight * energy_change(geometry, geometry->f, b.tilt, t_f);
            series_add(&state.dH, state.left);
            break;
        }
        if (pass & PASS_PUSHES)
            pushes = pushes && contact_pushes(&a, &b);
        real shrink = pair_shrink(&a, &b, t);
        if (pair_done(&state, &a, t, shrink, geometry->tol))
            break;
        t *= shrink;
        if (pass & PASS_SECOND_DERIVATIVE)
            second_derivative = link_second_derivative(&a, second_derivative);
        if (pass & PASS_SHIFT) {
            b.tilt = a.tilt;
            b.contact = a.contact;
        } else {
            link_next(&b);
        }
        link_next(&a);
    }
    enum dom_status status = sum_result(geometry, &state, H2, a.i + 1, sums);
    sums->pushes = pushes;
    return status;
}

/* In each of these calls `pass` is a constant, so the compiler removes the sums that are not needed. */
KERNEL enum dom_status sharp_change(const struct geometry *geometry, struct tilt from, struct tilt head,
                                    real t, enum pass pass, struct sums *sums)
{
    switch (pass) {
    case PASS_SHIFT:
        return energy_change_between(geometry, from, head, t, PASS_SHIFT, sums);
    case PASS_SECOND_DERIVATIVE:
        return energy_change_between(geometry, from, head, t, PASS_SECOND_DERIVATIVE, sums);
    case PASS_PUSHES:
        return energy_change_between(geometry, from, head, t, PASS_PUSHES, sums);
    default:
        return energy_change_between(geometry, from, head, t, PASS_PLAIN, sums);
    }
}

/* Makes both passes in one loop to save time: while the processor waits for a square root of one chain, it
 * can work on the other chain. */
KERNEL enum dom_status sharp_both(const struct geometry *geometry, struct tilt head, struct sums *sums,
                                  struct sums *at_c)
{
    struct sum_state up = {0}, down = {0};
    struct link a = link_head(geometry, head), b = link_head(geometry, standing),
                c = link_head(geometry, geometry->c);
    real t = half_of_tilt(head), t_c = half_of_tilt(geometry->c), H2 = 0, second_derivative = 0;
    bool closes = geometry->far.order > 0;
    for (;;) {
        enum dom_status status = chain_watch(geometry, a.i);
        if (status != DOM_OK)
            return status;
        if (closes && far_suffices(geometry, &up, &a, &b, t) && far_suffices(geometry, &down, &c, &b, t_c)) {
            struct far_point rest = far_add(geometry, &up, &a, &b, t);
            far_add(geometry, &down, &c, &b, t_c);
            H2 += far_H2(&a, second_derivative, &rest);
            break;
        }
        pair_add(&up, &a, &b, t);
        pair_add(&down, &c, &b, t_c);
        H2 += H2_term(&a, second_derivative);
        real shrink = pair_shrink(&a, &b, t), shrink_c = pair_shrink(&c, &b, t_c);
        if (pair_done(&up, &a, t, shrink, geometry->tol) &&
            pair_done(&down, &c, t_c, shrink_c, geometry->tol))
            break;
        t *= shrink;
        t_c *= shrink_c;
        second_derivative = link_second_derivative(&a, second_derivative);
        link_next(&a);
        b.tilt = c.tilt;
        b.contact = c.contact;
        link_next(&c);
    }
    *at_c = sums_of(&down, 0, a.i + 1);
    return sums_finite(at_c) ? sum_result(geometry, &up, H2, a.i + 1, sums) : DOM_NOT_FINITE;
}
