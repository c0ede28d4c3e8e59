/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The passes down a chain with rounded edges (rounded.h). */
#include "geometry/far.h"
#include "geometry/rounded.h"

KERNEL void rounded_count(const struct geometry *geometry)
{
    if (geometry->work)
        geometry->work->entered[DOM_EFFECT_edges]++;
}

static enum dom_status rolling_result(const struct geometry *geometry, const struct sum_state *a, real H2,
                                      size_t n, struct sums *sums)
{
    rounded_count(geometry);
    return sum_result(geometry, a, H2, n, sums);
}

static void rounded_add_J(struct sum_state *a, const struct link *k)
{
    series_add(&a->J, k->inertia * k->slope * k->slope * geometry_inertia(k->geometry, k->tilt));
}

static void rounded_add_H1(struct sum_state *a, const struct link *k)
{
    series_add(&a->H1, k->weight * k->slope * geometry_lift(k->geometry, k->tilt));
}

/* Returns true when the tail of H1 can be left out. For the tail of J, done_J can be used with rounded edges
 * as well: rounding an edge never increases the inertia, so the bound in done_J still holds. */
static bool rolling_done_H1(struct sum_state *a, const struct link *k, real tol)
{
    const struct geometry *geometry = k->geometry;
    return series_done(&a->H1, k->weight * k->slope * (geometry->steepest + fabs(geometry->rounded.roll)),
                       fmax(geometry->weight * k->contact_slope, geometry->decay), tol);
}

/* Finds J, H1 and half of dJ/dtheta. If `sign` is true, finds H1 alone, and only as precisely as its sign
 * requires. */
static enum dom_status rolling_sum(const struct geometry *geometry, struct tilt head, bool sign,
                                   struct sums *sums, real *half_J1)
{
    struct sum_state a = {0};
    struct walk k = rounded_begin(geometry, head);
    const struct link *link = &k.link;
    const real tol = sign ? (real)0.75 / TAIL_SHARE : geometry->tol;
    *half_J1 = 0;
    for (;; rounded_next(&k)) {
        enum dom_status status = chain_watch(geometry, link->i);
        if (status != DOM_OK)
            return status;
        rounded_add_H1(&a, link);
        if (!sign) {
            rounded_add_J(&a, link);
            *half_J1 += link->inertia * link->slope *
                        (k.second_derivative * geometry_inertia(link->geometry, link->tilt) +
                         link->slope * link->slope * geometry_inertia_slope(link->geometry, link->tilt) / 2);
        }
        if (link->i + 1 >= geometry->n || !link->leads ||
            ((sign || done_J(&a, link)) && rolling_done_H1(&a, link, tol)))
            return rolling_result(geometry, &a, 0, link->i + 1, sums);
    }
}

KERNEL enum dom_status rounded_sign(const struct geometry *geometry, struct tilt head, real *H1)
{
    struct sums sums;
    real half_J1;
    enum dom_status status = rolling_sum(geometry, head, true, &sums, &half_J1);
    *H1 = sums.H1;
    return status;
}

KERNEL enum dom_status rounded_sum(const struct geometry *geometry, struct tilt head, struct sums *sums)
{
    real half_J1;
    return rolling_sum(geometry, head, false, sums, &half_J1);
}

KERNEL enum dom_status rounded_rates(const struct geometry *geometry, struct tilt head, bool every,
                                     struct sums *sums, real *half_J1)
{
    (void)every;
    return rolling_sum(geometry, head, false, sums, half_J1);
}

/* ---- Differences ---- */

/* The difference between the tilts of a domino in two chains, and the tangent of half the difference. */
struct apart {
    real by, t;
};

static struct apart apart_by(real t)
{
    return (struct apart){2 * atan(t), t};
}

/* Returns h(A) - h(B) for a domino, like energy_change in sharp_change.c. */
static real rolling_rise(const struct geometry *geometry, struct tilt a, struct tilt b, struct apart apart)
{
    return apart.t * (geometry->h.x * (a.y + b.y) - geometry->h.y * (a.x + b.x)) +
           geometry->rounded.roll * apart.by;
}

KERNEL real rounded_fall(const struct geometry *geometry, struct tilt t)
{
    return -rolling_rise(geometry, t, standing, apart_by(half_of_tilt(t)));
}

/* Returns 2 tan(D/2) - D. Uses a power series if the two terms would cancel. */
KERNEL_LOOP real tangent_excess(real D)
{
    const real square = D * D, small = square * square * square * square * square;
    if (small > 65536 * ROUNDOFF)
        return 2 * tan(D / 2) - D;
    return D * square * ((real)1 / 12) *
           (1 + square * ((real)1 / 10) * (1 + square * ((real)17 / 168) * (1 + square * ((real)31 / 306))));
}

/*
 * Returns the difference between the tilts of the followers of a and b. `apart` is the difference between the
 * tilts of a and b themselves. The turn is the angle from a domino to its follower. Let D be the turn of a
 * minus the turn of b. Subtracting the contact equation of b from that of a gives
 *
 *     l_1 (Y_a + Y_b) tan(D/2) + rho_1 D cos theta_a = R.
 *
 * Every term of R is proportional to the difference between a and b, so D is accurate even if this difference
 * is tiny. The stored turns of a and b could give D by a subtraction, but digits would cancel. Only the term
 * 2 tan(D/2) - D is computed from that subtraction. If D is small, this term is about D^3/12, so its error
 * does not matter.
 */
KERNEL_LOOP struct apart apart_next(const struct walk *a, const struct walk *b, struct apart apart)
{
    const struct geometry *geometry = a->link.geometry;
    const struct rounded *of = &geometry->rounded;
    struct tilt A = a->link.tilt, B = b->link.tilt;
    real by = apart.by, t = apart.t, sines = t * (A.x + B.x), cosines = t * (A.y + B.y);
    real more = of->rho - of->rho_1, c = of->rho_1 * A.y,
         excess = tangent_excess(a->turn.angle - b->turn.angle);
    real R = more * (sines - cosines + by * A.y - b->theta * sines) +
             sines * (of->rho_1 * b->turn.angle - geometry->L);
    real t_D = (R + c * excess) / (of->tall_1 * (a->turn.tilt.y + b->turn.tilt.y) + 2 * c);
    return (struct apart){by + 2 * t_D - excess, (t + t_D) / (1 - t * t_D)};
}

/* Returns what apart_next would return if the follower of b had the tilt of a, as in a pass with PASS_SHIFT.
 * The difference between the two followers is then the turn from a to its own follower. */
static struct apart apart_turn(const struct walk *a)
{
    return (struct apart){.by = a->turn.angle, .t = half_of_tilt(a->turn.tilt)};
}

/* Returns the smallest value of `a` * u for u in [lo, hi]. */
static real least_product(real a, real lo, real hi)
{
    return fmin(a * lo, a * hi);
}

/*
 * Does for rounded edges what pushes_between in sharp_change.c does for sharp edges: tests a contact while
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

/* Chain a, its difference from chain b, and the sums over the dominoes visited so far. */
struct rolling_pair {
    struct walk a;
    struct apart apart; /* difference between the current dominoes of a and b */
    struct sum_state state;
    real H2;
};

/* Starts chain a at `head`. Chain b, which the caller starts, is at `from`. t is the tangent of half the
 * angle between these two tilts. */
static void rolling_begin(struct rolling_pair *p, const struct geometry *geometry, struct tilt from,
                          struct tilt head, real t)
{
    *p = (struct rolling_pair){.a = rounded_begin(geometry, head)};
    p->apart = from.x == 0 ? (struct apart){p->a.theta, t} : apart_by(t);
}

KERNEL_LOOP void rolling_add(struct rolling_pair *p, const struct walk *b)
{
    const struct link *link = &p->a.link;
    rounded_add_J(&p->state, link);
    rounded_add_H1(&p->state, link);
    series_add(&p->state.dH, link->weight * rolling_rise(link->geometry, link->tilt, b->link.tilt, p->apart));
    p->H2 += link->weight * (p->a.second_derivative * geometry_lift(link->geometry, link->tilt) -
                             link->slope * link->slope * geometry_height(link->geometry, link->tilt));
}

/* Moves on to `next`, the difference between the followers. Returns true if no further terms matter. */
KERNEL_LOOP bool rolling_done(struct rolling_pair *p, struct apart next)
{
    const struct link *link = &p->a.link;
    const struct geometry *self = link->geometry;
    const real by = p->apart.by, shrink = by == 0 ? 1 : fabs(next.by / by);
    p->apart = next;
    return series_done(&p->state.dH, link->weight * fabs(by) * (self->steepest + fabs(self->rounded.roll)),
                       fmax(self->weight * shrink, self->decay), self->tol) &&
           done_J(&p->state, link) && rolling_done_H1(&p->state, link, self->tol);
}

static bool rolling_near(const struct rolling_pair *p, const struct walk *b)
{
    return far_suffices(p->a.link.geometry, &p->state, &p->a.link, &b->link, p->apart.t);
}

/* Adds the current domino and all dominoes behind it, using the far series. */
static void rolling_add_far(struct rolling_pair *p, const struct walk *b)
{
    const struct far_point rest = far_add(p->a.link.geometry, &p->state, &p->a.link, &b->link, p->apart.t);
    p->H2 += far_H2(&p->a.link, p->a.second_derivative, &rest);
}

/* Like energy_change_between for sharp edges. */
KERNEL enum dom_status rounded_change(const struct geometry *geometry, struct tilt from, struct tilt head,
                                      real t, enum pass pass, struct sums *sums)
{
    bool pushes = pass == PASS_PUSHES;
    struct rolling_pair p;
    struct walk b;
    const struct link *link = &p.a.link;
    rolling_begin(&p, geometry, from, head, t);
    if (pass == PASS_SHIFT) /* only the tilts of the upright chain are needed */
        b = (struct walk){.link = {.tilt = from, .leads = geometry->n > 1}};
    else
        b = rounded_begin(geometry, from);
    const bool closes =
        geometry->far.order > 0 && !geometry->follower && geometry->n == CHAIN_ENDLESS && !pushes;
    for (;;) {
        enum dom_status status = chain_watch(geometry, link->i);
        if (status != DOM_OK)
            return status;
        if (closes && rolling_near(&p, &b)) {
            rolling_add_far(&p, &b);
            break;
        }
        rolling_add(&p, &b);
        if (link->i + 1 >= geometry->n || !b.link.leads)
            break;
        if (!link->leads) { /* The follower has detached in this cycle and stays at theta_f. */
            if (pass == PASS_SHIFT)
                b = p.a;
            else
                rounded_step(&b);
            p.state.left = link->weight * geometry->weight *
                           rolling_rise(geometry, geometry->f, b.link.tilt,
                                        apart_by(tan_half_between(b.link.tilt, geometry->f)));
            series_add(&p.state.dH, p.state.left);
            break;
        }
        if (pushes) {
            rounded_levers(&b);
            pushes = rounded_pushes(&p.a, &b);
        }
        if (rolling_done(&p, pass == PASS_SHIFT ? apart_turn(&p.a) : apart_next(&p.a, &b, p.apart)))
            break;
        if (pass == PASS_SHIFT)
            b = p.a;
        else
            rounded_step(&b);
        rounded_next(&p.a);
    }
    enum dom_status status = rolling_result(geometry, &p.state, p.H2, link->i + 1, sums);
    sums->pushes = pushes;
    return status;
}

/* The two passes run side by side, as in sharp_both. The upright chain needs no computation of its own: it is
 * the chain at theta_c, shifted by one domino. */
KERNEL enum dom_status rounded_both(const struct geometry *geometry, struct tilt head, struct sums *sums,
                                    struct sums *at_c)
{
    struct rolling_pair up, down;
    rolling_begin(&up, geometry, standing, head, half_of_tilt(head));
    rolling_begin(&down, geometry, standing, geometry->c, half_of_tilt(geometry->c));
    struct walk b = {.link = {.tilt = standing}, .turn = {down.a.theta, geometry->c}};
    const bool closes = geometry->far.order > 0;
    for (;;) {
        enum dom_status status = chain_watch(geometry, up.a.link.i);
        if (status != DOM_OK)
            return status;
        if (closes && rolling_near(&up, &b) && rolling_near(&down, &b)) {
            rolling_add_far(&up, &b);
            rolling_add_far(&down, &b);
            break;
        }
        rolling_add(&up, &b);
        rolling_add(&down, &b);
        const bool done = rolling_done(&up, apart_next(&up.a, &b, up.apart));
        if (rolling_done(&down, apart_turn(&down.a)) && done)
            break;
        b = down.a;
        rounded_factors(&up.a);
        rounded_factors(&down.a);
        rounded_step(&up.a);
        rounded_step(&down.a);
        rounded_levers(&up.a);
        rounded_levers(&down.a);
    }
    *at_c = sums_of(&down.state, 0, up.a.link.i + 1);
    return sums_finite(at_c) ? rolling_result(geometry, &up.state, up.H2, up.a.link.i + 1, sums)
                             : DOM_NOT_FINITE;
}
