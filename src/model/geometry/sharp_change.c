/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Passes down two chains with sharp edges side by side, to find differences of H. Near the ends of both
 * chains, series replace the dominoes. */
#include "geometry/bound.h"
#include "geometry/far.h"
#include "geometry/law.h"

/*
 * Returns h(A) - h(B), where A and B are the angles of one domino at the tilts a and b, and h = h.y cos + h.x
 * sin. t is tan((A - B)/2). The product 2 sin((A-B)/2) (h.x cos((A+B)/2) - h.y sin((A+B)/2)) has no
 * cancellation.
 */
KERNEL_LOOP real energy_change(const struct geometry *geometry, struct tilt a, struct tilt b, real t)
{
    return t * (geometry->h.x * (a.y + b.y) - geometry->h.y * (a.x + b.x));
}

/* The error bounds on a pass down the chains a and b: bounds for the current domino in each chain, for the t
 * of that domino (see energy_change_between), and for the sums. */
struct energy_change_bound {
    struct bound a, b;
    real t;
    struct sums sums;
};

static struct energy_change_bound error_head(const struct geometry *geometry, const struct link *a,
                                             const struct link *b, real t)
{
    real angle = geometry_error_head(a->tilt);
    return (struct energy_change_bound){
        .a = bound_head(geometry, a, angle),
        .b = bound_head(geometry, b, 0),
        .t = (1 + t * t) * angle / 2 + 3 * UNIT * t,
    };
}

static void error_add(const struct geometry *geometry, struct energy_change_bound *e, const struct link *a,
                      const struct link *b, real t)
{
    real term = fabs(energy_change(geometry, a->tilt, b->tilt, t));
    e->sums.J += bound_J(a, &e->a);
    e->sums.H1 += bound_H1(geometry, a, &e->a);
    e->sums.dH +=
        a->weight * (bound_energy_change(geometry, a->tilt, b->tilt, e->a.angle, e->b.angle, t, e->t) +
                     term * (e->a.weight + UNIT));
}

/*
 * Returns tan((theta_f - theta_1) / 2) for a follower that detaches at theta_f and whose tilt is theta_1
 * while its leader has the tilt of `leader`. This is one step of energy_change_between between `leader` and
 * theta_leave, where the arm a is 0, so that Y = r L x. The arm of the leader contains the factor cos theta -
 * cos theta_leave = (leave_at - leave_by v) / leave_by.
 */
static real leaving_half_turn(const struct geometry *geometry, const struct link *leader)
{
    real rL = geometry->r * geometry->L, x = leader->tilt.x, sines = geometry->leave.x + x,
         Y = leader->contact.Y;
    if (sines == 0) /* r s = 1: the follower is at theta_f from the start */
        return 0;
    real t = leader->contact.arm * (Y + rL * x) / (geometry->leave_by * sines);
    real whole = rL * geometry->leave.x + Y, F = leader->contact.arm / whole, G = rL * sines / whole;
    return t * F / (1 + t * t * G);
}

/*
 * Returns true if a and b are so near to theta_inf that the terms omitted from the far series do not matter.
 * The series can then replace the remaining dominoes of the pass.
 */
KERNEL_LOOP bool far_near(const struct geometry *geometry, const struct sum_state *state,
                          const struct link *a, const struct link *b, real t)
{
    const struct far *far = &geometry->far;
    real share = far_share(far, far_off(geometry, b->tilt)), H = a->weight * t;
    if (!far_done(&state->dH, -H * far->H[1], H * far->rest_H * share, geometry->tol))
        return false;
    /* Far from theta_inf the first term is a poor estimate of the tail, which may cancel the sum. Therefore
     * check again with all terms. */
    real tail = a->weight * far_difference(far, far_off(geometry, a->tilt), far_off(geometry, b->tilt), t);
    if (!far_done(&state->dH, tail, H * far->rest_H * share, geometry->tol))
        return false;
    share = far_share(far, far_off(geometry, a->tilt));
    real H1 = a->weight * a->slope / 2, J = a->inertia * a->slope * a->slope;
    return far_done(&state->H1, -H1 * far->H[1], H1 * far->rest_H * share, geometry->tol) &&
           far_done(&state->J, J * far->J[0], J * far->rest_J * share, geometry->tol);
}

static struct far_point far_add(const struct geometry *geometry, struct sum_state *state,
                                const struct link *a, const struct link *b, real t)
{
    const struct far *far = &geometry->far;
    real z_a = far_off(geometry, a->tilt), z_b = far_off(geometry, b->tilt);
    struct far_point H = far_H(far, z_a);
    series_add(&state->dH, a->weight * far_difference(far, z_a, z_b, t));
    series_add(&state->H1, a->weight * a->slope * H.first);
    series_add(&state->J, a->inertia * a->slope * a->slope * far_J(far, z_a).value);
    return H;
}

/* These two functions return the term of H2 of one domino, and the sum of the terms of this domino and all
 * dominoes behind it. second_derivative is theta'' of this domino. */
KERNEL_LOOP real second_derivative_H2(const struct link *k, real second_derivative)
{
    return k->weight * (second_derivative * geometry_height_slope(k->geometry, k->tilt) -
                        k->slope * k->slope * geometry_height(k->geometry, k->tilt));
}

static real far_H2(const struct link *k, real second_derivative, const struct far_point *H)
{
    return k->weight * (second_derivative * H->first + k->slope * k->slope * H->second);
}

/* Adds one pair of dominoes to the sums. */
KERNEL_LOOP void pair_add(struct sum_state *state, const struct link *a, const struct link *b, real t)
{
    add_J(state, a);
    add_H1(state, a);
    series_add(&state->dH, a->weight * energy_change(a->geometry, a->tilt, b->tilt, t));
}

/* Returns true when the tails of all sums after this pair can be left out. `shrinks` is the ratio of t of the
 * next pair to t of this pair. */
KERNEL_LOOP bool pair_done(struct sum_state *state, const struct link *a, real t, real shrinks, real tol)
{
    real ratio = fmax(a->geometry->weight * shrinks, a->geometry->decay);
    return series_done(&state->dH, a->weight * 2 * t * a->geometry->reach, ratio, tol) && done_J(state, a) &&
           done_H1(state, a, tol);
}

/*
 * Tests a condition on one contact, whose leader moves from b to a. If all contacts of a chain meet the
 * condition, all of them stay closed, for the following reason.
 *
 * The torques on all dominoes from i on, times the factors S of dynamics/friction.c (theta_i' without
 * friction), pass through the contact of domino i with its leader. The part of them that does not accelerate
 * these dominoes is the contact force times S_i b_i > 0. With the acceleration of the whole chain this part
 * is the sum over k >= i of
 *
 *     I_k S_k theta_k' [(a_k - <a>) + (c_k - <c>) w],   w = tau^2 omega^2,
 *     a_k = (weight g)_k / (I_k theta_k'),   c_k = -theta_k'' / theta_k',
 *
 * where g = -h'/2, and <> is the mean over the whole chain with the weights I S theta'. If a_k and c_k do not
 * decrease down the chain, no such sum is negative: all contacts push, at every speed.
 *
 * From a leader to its follower, c increases by r L (y_1 + theta_1' x X) / Y^2 times a square
 * (link_second_derivative), where y_1 = Y y - X x is the cosine of the follower. a does not decrease if f =
 * (weight/inertia) g_1 - theta_1' g >= 0. X and Y of the contact turn g into g_1 of the follower, so that
 *
 *     2 f = x [R (h1.y Y + h1.x X) - theta_1' h.y] + y [R (h1.y X - h1.x Y) + theta_1' h.x].
 *
 * From b to a, X and theta_1' decrease, and Y increases while X >= 0, so that the terms at the two ends give
 * a bound. The arm a of the contact, which must be positive, decreases too. While a leader still leans
 * backwards, none of these bounds holds.
 */
static bool pushes_between(const struct link *a, const struct link *b)
{
    const struct geometry *self = a->geometry, *next = self->follower ? self->follower : self;
    const real X = a->contact.X, Y = fmin(a->contact.Y, b->contact.Y), Y_most = X < 0 ? 1 : a->contact.Y;
    const real less = fmin(X, 0), R = self->weight / self->inertia;
    const real of_x =
                   R * (next->h.y * Y + fmin(next->h.x * X, next->h.x * b->contact.X)) - b->step * self->h.y,
               of_y = R * (next->h.y * X - fmax(next->h.x * Y, next->h.x * Y_most)) +
                      fmin(a->step * self->h.x, b->step * self->h.x);
    return b->tilt.x >= 0 && a->tilt.y >= 0 && a->contact.Y * a->tilt.y - X * a->tilt.x + less >= 0 &&
           Y + self->mu * less > 0 && contact_arm_a(a) >= 0 && self->h.y > 0 && next->h.y > 0 &&
           fmin(a->tilt.x * of_x, b->tilt.x * of_x) + fmin(a->tilt.y * of_y, b->tilt.y * of_y) >= 0;
}

/* Returns true if pushes_between holds from b to a. If it does not, tries both halves of the interval
 * separately, down to `halvings` levels. */
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
 * Finds the sums of chain a, whose head is at `head`, and H of chain a minus H of chain b, whose head is at
 * `from`. With t = tan((theta_a - theta_b)/2) of one domino, t of its follower is exactly t (1 - G) / (1 +
 * t^2 G), where G = r L (x_a + x_b) / (Y_a + Y_b), because X_a - X_b = r L (y_a - y_b). G is r L x / Y of the
 * slope (14; b10), averaged between the two tilts. So the smallest differences keep their digits.
 */
KERNEL_LOOP enum dom_status energy_change_between(const struct geometry *geometry, struct tilt from,
                                                  struct tilt head, real t, const enum pass pass,
                                                  struct sums *sums, struct sums *error)
{
    struct sum_state state = {0};
    struct link a = link_head(geometry, head), b = link_head(geometry, from);
    struct energy_change_bound e;
    real H2 = 0, second_derivative = 0;
    bool ended = true, pushes = true,
         closes = !(pass & PASS_ERROR) && geometry->far.order > 0 && !geometry->follower &&
                  geometry->n == CHAIN_ENDLESS;
    if (pass & PASS_ERROR)
        e = error_head(geometry, &a, &b, t);
    for (;;) {
        enum dom_status status = chain_watch(geometry, a.i);
        if (status != DOM_OK)
            return status;
        if (closes && far_near(geometry, &state, &a, &b, t)) {
            struct far_point rest = far_add(geometry, &state, &a, &b, t);
            if (pass & PASS_SECOND_DERIVATIVE)
                H2 += far_H2(&a, second_derivative, &rest);
            break;
        }
        pair_add(&state, &a, &b, t);
        if (pass & PASS_SECOND_DERIVATIVE)
            H2 += second_derivative_H2(&a, second_derivative);
        if (pass & PASS_ERROR)
            error_add(geometry, &e, &a, &b, t);
        if (a.i + 1 >= geometry->n || !b.leads)
            break;
        if (!a.leads) {
            /* The follower has detached during this cycle and keeps the tilt theta_f. */
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
            if (pass & PASS_ERROR) {
                real angle = geometry_error_f(geometry),
                     t_error = bound_leaving(geometry, &leader, &e.b, t_f);
                bound_next(geometry, &leader, &b, &e.b);
                e.sums.dH +=
                    b.weight *
                    (bound_energy_change(geometry, geometry->f, b.tilt, angle, e.b.angle, t_f, t_error) +
                     fabs(energy_change(geometry, geometry->f, b.tilt, t_f)) * (e.b.weight + UNIT));
            }
            break;
        }
        if (pass & PASS_PUSHES)
            pushes = pushes && contact_pushes(&a, &b);
        real shrinks = pair_shrinks(&a, &b, t);
        ended = false;
        if (pair_done(&state, &a, t, shrinks, geometry->tol))
            break;
        ended = true;
        if (pass & PASS_ERROR)
            e.t = bound_half_turn(&a, &b, &e.a, &e.b, t, e.t);
        t *= shrinks;
        if (pass & PASS_SECOND_DERIVATIVE)
            second_derivative = link_second_derivative(&a, second_derivative);
        struct link leader_a = a, leader_b = b;
        link_next(&a);
        if (pass & PASS_SHIFT) {
            b.tilt = leader_a.tilt;
            b.contact = leader_a.contact;
        } else {
            link_next(&b);
        }
        if (pass & PASS_ERROR) {
            bound_next(geometry, &leader_a, &a, &e.a);
            bound_next(geometry, &leader_b, &b, &e.b);
        }
    }
    if (pass & PASS_ERROR)
        *error = (struct sums){.J = e.sums.J + series_error(&state.J, ended),
                               .H1 = e.sums.H1 + series_error(&state.H1, ended),
                               .dH = e.sums.dH + series_error(&state.dH, ended)};
    enum dom_status status = sum_result(geometry, &state, H2, a.i + 1, sums);
    sums->pushes = pushes;
    return status;
}

/* `pass` is a constant in each call, so that the compiler can remove the sums that are not needed. The error
 * bounds come from a second pass, without series, and include the difference between the sums of the two
 * passes. */
KERNEL enum dom_status sharp_change(const struct geometry *geometry, struct tilt from, struct tilt head,
                                    real t, enum pass pass, struct sums *sums, struct sums *error)
{
    enum dom_status status;
    struct sums whole;
    switch (pass) {
    case PASS_SHIFT:
        status = energy_change_between(geometry, from, head, t, PASS_SHIFT, sums, NULL);
        break;
    case PASS_SECOND_DERIVATIVE:
        status = energy_change_between(geometry, from, head, t, PASS_SECOND_DERIVATIVE, sums, NULL);
        break;
    case PASS_PUSHES:
        status = energy_change_between(geometry, from, head, t, PASS_PUSHES, sums, NULL);
        break;
    default:
        status = energy_change_between(geometry, from, head, t, PASS_PLAIN, sums, NULL);
    }
    if (status != DOM_OK || !error)
        return status;
    status = energy_change_between(geometry, from, head, t, PASS_ERROR, &whole, error);
    error->J += fabs(sums->J - whole.J);
    error->H1 += fabs(sums->H1 - whole.H1);
    error->dH += fabs(sums->dH - whole.dH);
    return status;
}

/* The two passes run side by side, because the processor can compute the square roots of one chain while the
 * other chain waits for its own. */
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
        if (closes && far_near(geometry, &up, &a, &b, t) && far_near(geometry, &down, &c, &b, t_c)) {
            struct far_point rest = far_add(geometry, &up, &a, &b, t);
            far_add(geometry, &down, &c, &b, t_c);
            H2 += far_H2(&a, second_derivative, &rest);
            break;
        }
        pair_add(&up, &a, &b, t);
        pair_add(&down, &c, &b, t_c);
        H2 += second_derivative_H2(&a, second_derivative);
        real shrinks = pair_shrinks(&a, &b, t), shrinks_c = pair_shrinks(&c, &b, t_c);
        if (pair_done(&up, &a, t, shrinks, geometry->tol) &&
            pair_done(&down, &c, t_c, shrinks_c, geometry->tol))
            break;
        t *= shrinks;
        t_c *= shrinks_c;
        second_derivative = link_second_derivative(&a, second_derivative);
        link_next(&a);
        b.tilt = c.tilt;
        b.contact = c.contact;
        link_next(&c);
    }
    *at_c = sums_of(&down, 0, a.i + 1);
    return sums_finite(at_c) ? sum_result(geometry, &up, H2, a.i + 1, sums) : DOM_NOT_FINITE;
}
