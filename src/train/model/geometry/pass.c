/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The passes down a chain. Each pass visits the dominoes from the head down. There is one set of passes:
 * `rolls` says whether the edges are rounded. It is a constant in every call below, so the compiler makes a
 * loop for sharp edges that knows nothing of rounded ones. The step from a domino to its follower is
 * link_next (geometry/link.h), or rounded_next with rounded edges.
 */
#include "geometry/far.h"
#include "geometry/rounded.h"

KERNEL void rounded_count(const struct geometry *geometry)
{
    if (geometry->work)
        geometry->work->entered[DOM_EFFECT_edges]++;
}

/* ---- A walk, and the terms of one domino ---- */

KERNEL_LOOP struct walk walk_begin(const struct geometry *geometry, struct tilt head, const bool rolls)
{
    return rolls ? rounded_begin(geometry, head) : (struct walk){.link = link_head(geometry, head)};
}

/* Moves on to the follower. With sharp edges, theta_i'' is found only if `bends` is true. */
KERNEL_LOOP void walk_next(struct walk *k, const bool rolls, const bool bends)
{
    if (rolls) {
        rounded_next(k);
        return;
    }
    if (bends)
        k->second_derivative = link_second_derivative(&k->link, k->second_derivative);
    link_next(&k->link);
}

KERNEL_LOOP real inertia_of(const struct link *k, const bool rolls)
{
    return rolls ? geometry_inertia(k->geometry, k->tilt) : 1;
}

KERNEL_LOOP real lift_of(const struct link *k, const bool rolls)
{
    return rolls ? geometry_lift(k->geometry, k->tilt) : geometry_height_slope(k->geometry, k->tilt);
}

/* Returns an upper bound on |lift_of|. */
KERNEL_LOOP real steepest_of(const struct geometry *geometry, const bool rolls)
{
    return rolls ? geometry->steepest + fabs(geometry->rounded.roll) : geometry->steepest;
}

KERNEL_LOOP void add_J(struct sum_state *a, const struct link *k, const bool rolls) /* (20; c2) */
{
    series_add(&a->J, rolls ? k->inertia * k->slope * k->slope * inertia_of(k, rolls)
                            : k->inertia * k->slope * k->slope);
}

KERNEL_LOOP void add_H1(struct sum_state *a, const struct link *k, const bool rolls)
{
    series_add(&a->H1, k->weight * k->slope * lift_of(k, rolls));
}

/* Returns true when the tail of J can be left out. Rounding an edge never increases the inertia, so the bound
 * holds for rounded edges as well. */
KERNEL_LOOP bool done_J(const struct sum_state *a, const struct link *k)
{
    const struct geometry *geometry = k->geometry;
    return series_done(&a->J, k->inertia * k->slope * k->slope,
                       fmax(geometry->inertia * k->contact_slope * k->contact_slope, geometry->decay_J),
                       geometry->tol);
}

KERNEL_LOOP bool done_H1(const struct sum_state *a, const struct link *k, const bool rolls)
{
    const struct geometry *geometry = k->geometry;
    return series_done(&a->H1, k->weight * k->slope * steepest_of(geometry, rolls),
                       fmax(geometry->weight * k->contact_slope, geometry->decay), geometry->tol);
}

/* Counts the pass, and returns its sums. */
KERNEL_LOOP enum dom_status pass_result(const struct geometry *geometry, const struct sum_state *a, real H2,
                                        size_t n, const bool rolls, struct sums *sums)
{
    const struct sum_state sum = *a;
    if (rolls)
        rounded_count(geometry);
    return sum_result(geometry, &sum, H2, n, sums);
}

/* ---- J, H1 and dJ/dtheta at one tilt ---- */

/* Uses the far series to add this domino and all dominoes behind it to J, H1 and J'/2. If no series applies,
 * or if the tilt is too far from theta_inf for the series, adds nothing and returns false. */
static bool rates_close(const struct link *k, real second_derivative, struct sum_state *a, real *half_J1)
{
    const struct geometry *geometry = k->geometry;
    const struct far *far = &geometry->far;
    if (geometry->n != CHAIN_ENDLESS || far->order == 0 || geometry->follower)
        return false;
    real z = far_variable(geometry, k->tilt), share = far_share(far, z), H1 = k->weight * k->slope,
         J = k->inertia * k->slope * k->slope;
    if (!far_done(&a->H1, -H1 / 2 * far->H[1], H1 / 2 * far->rest_H * share, geometry->tol) ||
        !far_done(&a->J, J * far->J[0], J * far->rest_J * share, geometry->tol))
        return false;
    struct far_point J_far = far_J(far, z);
    series_add(&a->H1, H1 * far_H(far, z).first);
    series_add(&a->J, J * J_far.value);
    *half_J1 +=
        k->inertia * k->slope * (second_derivative * J_far.value + k->slope * k->slope * J_far.first / 2);
    return true;
}

/* Finds J and H1. With `bends`, also finds half of dJ/dtheta. */
KERNEL_LOOP enum dom_status chain_sums(const struct geometry *geometry, struct tilt head, const bool rolls,
                                       const bool bends, bool every, struct sums *sums, real *half_J1)
{
    struct sum_state a = {0};
    struct walk k = walk_begin(geometry, head, rolls);
    const struct link *link = &k.link;
    *half_J1 = 0;
    for (;; walk_next(&k, rolls, bends)) {
        enum dom_status status = chain_watch(geometry, link->i);
        if (status != DOM_OK)
            return status;
        if (bends && !rolls && !every && rates_close(link, k.second_derivative, &a, half_J1))
            break;
        add_J(&a, link, rolls);
        add_H1(&a, link, rolls);
        if (bends && rolls)
            *half_J1 += link->inertia * link->slope *
                        (k.second_derivative * inertia_of(link, rolls) +
                         link->slope * link->slope * geometry_inertia_slope(link->geometry, link->tilt) / 2);
        else if (bends)
            *half_J1 += link->inertia * link->slope * k.second_derivative;
        if (link->i + 1 >= geometry->n || !link->leads || (done_J(&a, link) && done_H1(&a, link, rolls)))
            break;
    }
    return pass_result(geometry, &a, 0, link->i + 1, rolls, sums);
}

KERNEL enum dom_status sharp_sum(const struct geometry *geometry, struct tilt head, struct sums *sums)
{
    real half_J1;
    return chain_sums(geometry, head, false, false, true, sums, &half_J1);
}

KERNEL enum dom_status rounded_sum(const struct geometry *geometry, struct tilt head, struct sums *sums)
{
    real half_J1;
    return chain_sums(geometry, head, true, false, true, sums, &half_J1);
}

KERNEL enum dom_status sharp_rates(const struct geometry *geometry, struct tilt head, bool every,
                                   struct sums *sums, real *half_J1)
{
    return chain_sums(geometry, head, false, true, every, sums, half_J1);
}

KERNEL enum dom_status rounded_rates(const struct geometry *geometry, struct tilt head, bool every,
                                     struct sums *sums, real *half_J1)
{
    return chain_sums(geometry, head, true, true, every, sums, half_J1);
}

/* ---- The difference between the tilts of a domino in two chains ---- */

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
 * leader reaches theta_leave. The formula of chain_difference, applied to the leader's tilts theta_leave
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

/* The difference between the tilts of a domino in two chains, and the tangent of half the difference. */
struct apart {
    real by, t;
};

KERNEL_LOOP struct apart apart_by(real t)
{
    return (struct apart){2 * atan(t), t};
}

/* Returns h(A) - h(B) for a domino, like energy_change. */
KERNEL_LOOP real rolling_rise(const struct geometry *geometry, struct tilt a, struct tilt b,
                              struct apart apart)
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

/* ---- Differences of H between two chains ---- */

/* Chain a, its difference from chain b, and the sums over the dominoes visited so far. */
struct pair {
    struct walk a;
    struct apart apart; /* difference between the current dominoes of a and b */
    struct sum_state state;
    real H2;
};

/* Starts chain a at `head`. Chain b, which the caller starts, is at `from`. t is the tangent of half the
 * angle between these two tilts. */
KERNEL_LOOP struct pair pair_begin(const struct geometry *geometry, struct tilt from, struct tilt head,
                                   real t, const bool rolls)
{
    struct pair p = {.a = walk_begin(geometry, head, rolls), .apart = {2 * t, t}};
    if (rolls)
        p.apart = from.x == 0 ? (struct apart){p.a.theta, t} : apart_by(t);
    return p;
}

KERNEL_LOOP void pair_add(struct pair *p, const struct walk *b, const bool rolls, const bool bends)
{
    const struct link *link = &p->a.link;
    add_J(&p->state, link, rolls);
    add_H1(&p->state, link, rolls);
    series_add(&p->state.dH,
               link->weight * (rolls ? rolling_rise(link->geometry, link->tilt, b->link.tilt, p->apart)
                                     : energy_change(link->geometry, link->tilt, b->link.tilt, p->apart.t)));
    if (bends)
        p->H2 += link->weight * (p->a.second_derivative * lift_of(link, rolls) -
                                 link->slope * link->slope * geometry_height(link->geometry, link->tilt));
}

/* Finds the difference between the followers, and returns true when the tails of dH, J and H1 can be left
 * out. If `shifted` is true, chain b is chain a shifted by one domino. */
KERNEL_LOOP bool pair_done(struct pair *p, const struct walk *b, const bool shifted, const bool rolls)
{
    const struct link *link = &p->a.link;
    const struct geometry *self = link->geometry;
    const struct apart now = p->apart;
    real shrink;
    if (rolls) {
        p->apart = shifted ? apart_turn(&p->a) : apart_next(&p->a, b, now);
        shrink = now.by == 0 ? 1 : fabs(p->apart.by / now.by);
    } else {
        shrink = pair_shrink(link, &b->link, now.t);
        p->apart = (struct apart){2 * (now.t * shrink), now.t * shrink};
    }
    return series_done(&p->state.dH,
                       link->weight * (rolls ? fabs(now.by) : now.by) * steepest_of(self, rolls),
                       fmax(self->weight * shrink, self->decay), self->tol) &&
           done_J(&p->state, link) && done_H1(&p->state, link, rolls);
}

KERNEL_LOOP bool pair_near(const struct pair *p, const struct walk *b)
{
    return far_suffices(p->a.link.geometry, &p->state, &p->a.link, &b->link, p->apart.t);
}

/* Adds the current domino and all dominoes behind it, using the far series. Copies are passed to far_add, so
 * that the compiler can keep the pair in registers. */
KERNEL_LOOP void pair_add_far(struct pair *p, const struct walk *b, const bool bends)
{
    struct sum_state state = p->state;
    const struct link a = p->a.link, other = b->link;
    const struct far_point rest = far_add(a.geometry, &state, &a, &other, p->apart.t);
    p->state = state;
    if (bends)
        p->H2 += far_H2(&a, p->a.second_derivative, &rest);
}

/* Moves chain b on to the follower: to the domino of chain a, if chain b is chain a shifted by one domino. */
KERNEL_LOOP void other_next(struct walk *b, const struct walk *a, const bool shifted, const bool rolls)
{
    if (shifted && rolls) {
        *b = *a;
    } else if (shifted) {
        b->link.tilt = a->link.tilt;
        b->link.contact = a->link.contact;
    } else if (rolls) {
        rounded_step(b);
    } else {
        link_next(&b->link);
    }
}

/* Adds the energy of a follower that has detached in this cycle and stays at theta_f. */
KERNEL_LOOP void pair_add_left(struct pair *p, struct walk *b, const bool shifted, const bool rolls)
{
    const struct link leader = b->link;
    const struct geometry *geometry = p->a.link.geometry;
    other_next(b, &p->a, shifted, rolls);
    const real weight = p->a.link.weight * geometry->weight;
    const struct tilt tilt = b->link.tilt;
    p->state.left =
        weight *
        (rolls ? rolling_rise(geometry, geometry->f, tilt, apart_by(tan_half_between(tilt, geometry->f)))
               : energy_change(geometry, geometry->f, tilt, leaving_half_turn(geometry, &leader)));
    series_add(&p->state.dH, p->state.left);
}

/*
 * Finds the sums of chain a, and H(head) - H(from). The head of chain a is at `head`, and the head of chain b
 * is at `from`. Subtracting two nearly equal energies would lose digits. So each domino's term of the
 * difference is computed from t = tan((theta_a - theta_b)/2), where theta_a and theta_b are its tilts in the
 * two chains. With sharp edges X_a - X_b = r L (y_a - y_b), so the follower's t is exactly
 *
 *     t (1 - G) / (1 + t^2 G),   G = r L (x_a + x_b) / (Y_a + Y_b).
 *
 * G is a mean of the values of r L x / Y in the two chains. The slope of a contact is 1 - r L x / Y
 * (14; b10).
 */
KERNEL_LOOP enum dom_status chain_difference(const struct geometry *geometry, struct tilt from,
                                             struct tilt head, real t, const enum pass pass, const bool rolls,
                                             struct sums *sums)
{
    const bool shifted = pass == PASS_SHIFT, bends = pass == PASS_SECOND_DERIVATIVE;
    struct pair p = pair_begin(geometry, from, head, t, rolls);
    const struct link *link = &p.a.link;
    struct walk b = shifted && rolls /* only the tilts of the upright chain are needed */
                        ? (struct walk){.link = {.tilt = from, .leads = geometry->n > 1}}
                        : walk_begin(geometry, from, rolls);
    bool pushes = pass == PASS_PUSHES && geometry->drag == 0; /* the proof is for a chain without drag */
    const bool closes = geometry->far.order > 0 && !geometry->follower && geometry->n == CHAIN_ENDLESS &&
                        !(rolls && pass == PASS_PUSHES);
    for (;;) {
        enum dom_status status = chain_watch(geometry, link->i);
        if (status != DOM_OK)
            return status;
        if (closes && pair_near(&p, &b)) {
            pair_add_far(&p, &b, bends);
            break;
        }
        pair_add(&p, &b, rolls, bends);
        if (link->i + 1 >= geometry->n || !b.link.leads)
            break;
        if (!link->leads) {
            pair_add_left(&p, &b, shifted, rolls);
            break;
        }
        if (pass == PASS_PUSHES && pushes && rolls)
            rounded_levers(&b);
        if (pass == PASS_PUSHES && pushes)
            pushes = rolls ? rounded_pushes(&p.a, &b) : contact_pushes(link, &b.link);
        if (pair_done(&p, &b, shifted, rolls))
            break;
        other_next(&b, &p.a, shifted, rolls);
        walk_next(&p.a, rolls, bends);
    }
    enum dom_status status = pass_result(geometry, &p.state, p.H2, link->i + 1, rolls, sums);
    sums->pushes = pushes;
    return status;
}

/* In each of these calls `pass` is a constant, too, so the compiler removes the sums that are not needed. */
KERNEL_LOOP enum dom_status change_by(const struct geometry *geometry, struct tilt from, struct tilt head,
                                      real t, enum pass pass, const bool rolls, struct sums *sums)
{
    switch (pass) {
    case PASS_SHIFT:
        return chain_difference(geometry, from, head, t, PASS_SHIFT, rolls, sums);
    case PASS_SECOND_DERIVATIVE:
        return chain_difference(geometry, from, head, t, PASS_SECOND_DERIVATIVE, rolls, sums);
    case PASS_PUSHES:
        return chain_difference(geometry, from, head, t, PASS_PUSHES, rolls, sums);
    default:
        return chain_difference(geometry, from, head, t, PASS_PLAIN, rolls, sums);
    }
}

KERNEL enum dom_status sharp_change(const struct geometry *geometry, struct tilt from, struct tilt head,
                                    real t, enum pass pass, struct sums *sums)
{
    return change_by(geometry, from, head, t, pass, false, sums);
}

KERNEL enum dom_status rounded_change(const struct geometry *geometry, struct tilt from, struct tilt head,
                                      real t, enum pass pass, struct sums *sums)
{
    return change_by(geometry, from, head, t, pass, true, sums);
}

/*
 * Makes two passes in one loop to save time: while the processor waits for a square root of one chain, it can
 * work on the other chain. The upright chain needs no computation of its own: it is the chain at theta_c,
 * shifted by one domino.
 */
KERNEL_LOOP enum dom_status both_by(const struct geometry *geometry, struct tilt head, const bool rolls,
                                    struct sums *sums, struct sums *at_c)
{
    struct pair up = pair_begin(geometry, standing, head, half_of_tilt(head), rolls),
                down = pair_begin(geometry, standing, geometry->c, half_of_tilt(geometry->c), rolls);
    struct walk b = {.link = {.tilt = standing}, .turn = {down.a.theta, geometry->c}};
    if (!rolls)
        b.link = link_head(geometry, standing);
    const bool closes = geometry->far.order > 0;
    for (;;) {
        enum dom_status status = chain_watch(geometry, up.a.link.i);
        if (status != DOM_OK)
            return status;
        if (closes && pair_near(&up, &b) && pair_near(&down, &b)) {
            pair_add_far(&up, &b, true);
            pair_add_far(&down, &b, false);
            break;
        }
        pair_add(&up, &b, rolls, true);
        pair_add(&down, &b, rolls, false);
        const bool up_done = pair_done(&up, &b, false, rolls), down_done = pair_done(&down, &b, true, rolls);
        if (up_done && down_done)
            break;
        other_next(&b, &down.a, true, rolls);
        if (rolls) {
            rounded_factors(&up.a);
            rounded_factors(&down.a);
            rounded_step(&up.a);
            rounded_step(&down.a);
            rounded_levers(&up.a);
            rounded_levers(&down.a);
        } else {
            walk_next(&up.a, false, true);
            walk_next(&down.a, false, false);
        }
    }
    const size_t n = up.a.link.i + 1;
    *at_c = sums_of(&down.state, 0, n);
    return sums_finite(at_c) ? pass_result(geometry, &up.state, up.H2, n, rolls, sums) : DOM_NOT_FINITE;
}

KERNEL enum dom_status sharp_both(const struct geometry *geometry, struct tilt head, struct sums *sums,
                                  struct sums *at_c)
{
    return both_by(geometry, head, false, sums, at_c);
}

KERNEL enum dom_status rounded_both(const struct geometry *geometry, struct tilt head, struct sums *sums,
                                    struct sums *at_c)
{
    return both_by(geometry, head, true, sums, at_c);
}
