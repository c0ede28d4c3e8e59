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

/* Moves on to the follower. With sharp edges, theta_i'' is found only if `bends` is true, after walk_bend. */
KERNEL_LOOP void walk_next(struct walk *k, const bool rolls, const bool bends)
{
    if (rolls) {
        rounded_next(k);
        return;
    }
    if (bends)
        k->second_derivative = link_second_derivative(&k->link, k->curve, k->second_derivative);
    link_next(&k->link);
}

/* Finds theta_1'' of the contact with the follower. With rounded edges, rounded_next has found it. */
KERNEL_LOOP void walk_bend(struct walk *k, const bool rolls)
{
    if (!rolls)
        k->curve = link_curve(&k->link);
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
                       fmax(geometry->inertia * k->contact.slope * k->contact.slope, geometry->decay_J),
                       geometry->tol);
}

KERNEL_LOOP bool done_H1(const struct sum_state *a, const struct link *k, real tol, const bool rolls)
{
    const struct geometry *geometry = k->geometry;
    return series_done(&a->H1, k->weight * k->slope * steepest_of(geometry, rolls),
                       fmax(geometry->weight * k->contact.slope, geometry->decay), tol);
}

/* Returns true when the tail of dH can be left out. `by` is the angle by which this domino turns, and
 * `shrink` is the angle of its follower divided by `by`. */
KERNEL_LOOP bool done_dH(const struct sum_state *a, const struct link *k, real by, real shrink,
                         const bool rolls)
{
    const struct geometry *geometry = k->geometry;
    return series_done(&a->dH, k->weight * by * steepest_of(geometry, rolls),
                       fmax(geometry->weight * shrink, geometry->decay), geometry->tol);
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

/* ---- Sums at one tilt ---- */

/* Finds J and H1. If `sign` is true, ends as soon as the sign of H1 is certain, and J is not complete. */
KERNEL_LOOP enum dom_status sum_by(const struct geometry *geometry, struct tilt head, bool sign,
                                   const bool rolls, struct sums *sums)
{
    /* a tail of at most 7/8 of the sum cannot change its sign */
    const real tol_H1 = sign ? (real)0.875 / TAIL_SHARE : geometry->tol;
    struct sum_state a = {0};
    struct walk k = walk_begin(geometry, head, rolls);
    const struct link *link = &k.link;
    for (;; walk_next(&k, rolls, false)) {
        enum dom_status status = chain_watch(geometry, link->i);
        if (status != DOM_OK)
            return status;
        add_J(&a, link, rolls);
        add_H1(&a, link, rolls);
        if (link->i + 1 >= geometry->n || !link->leads ||
            (done_H1(&a, link, tol_H1, rolls) && (sign || done_J(&a, link))))
            break;
    }
    return pass_result(geometry, &a, 0, link->i + 1, rolls, sums);
}

KERNEL enum dom_status chain_sum(const struct geometry *geometry, struct tilt head, struct sums *sums)
{
    return geometry->law->rolls ? sum_by(geometry, head, false, true, sums)
                                : sum_by(geometry, head, false, false, sums);
}

KERNEL enum dom_status chain_slope(const struct geometry *geometry, struct tilt head, bool sign, real *H1)
{
    struct sums sums = {.H1 = REAL_NAN};
    const enum dom_status status = geometry->law->rolls ? sum_by(geometry, head, sign, true, &sums)
                                                        : sum_by(geometry, head, sign, false, &sums);
    *H1 = sums.H1;
    return status;
}

/* ---- The equation of motion at one tilt ---- */

/* Returns true when the tails of all three sums can be left out. Each tail is bounded by a geometric series.
 * The ratio of this series is at least `decay`, because without friction the ratio of successive terms of C
 * tends to `decay` far down an endless train. */
KERNEL_LOOP bool equation_done(const struct walk *k, real S, real ratio, const struct series *A,
                               const struct series *B, const struct series *C, const bool rolls)
{
    const struct link *link = &k->link;
    const struct geometry *self = link->geometry;
    const real size = fabs(S), passed = fabs(ratio), slope = fabs(link->slope),
               bends = fabs(k->second_derivative) + slope * slope * (fabs(k->curve) + 1 + self->drag),
               next = fmax(self->inertia * passed, fmax(self->decay, self->decay_J));
    return series_done(C, link->weight * size * steepest_of(self, rolls),
                       fmax(self->weight * passed, self->decay), self->tol) &&
           series_done(A, link->inertia * size * slope, next, self->tol) &&
           series_done(B, link->inertia * size * bends, next, self->tol);
}

/* With rounded edges, the inertia i of a domino depends on its tilt. So its term in A contains i theta', and
 * its term in B contains i theta'' + (i'/2 + drag) theta'^2. */
KERNEL_LOOP enum dom_status equation_by(const struct geometry *geometry, struct tilt head, const bool rolls,
                                        struct equation_of_motion *equation)
{
    struct series A = {0}, B = {0}, C = {0};
    struct walk k = walk_begin(geometry, head, rolls);
    const struct link *link = &k.link;
    /* The rounding error of S, in units of the unit roundoff, is at most `noise` S. It grows if X < 0, since
     * digits then cancel in the arm b. With rounded edges an arm takes more operations; 8 is a choice, with
     * which 12,000 random trains in float are solved. */
    real S = 1, noise = rolls ? 8 : 1;
    bool wrong_side = false; /* true if b <= 0: a contact force passes on the wrong side of a hinge */
    for (;;) {
        enum dom_status status = chain_watch(geometry, link->i);
        if (status != DOM_OK)
            return status;
        const struct geometry *self = link->geometry;
        const real i = inertia_of(link, rolls), slope = link->slope,
                   half_i1 = rolls ? geometry_inertia_slope(self, link->tilt) / 2 : 0;
        series_add(&A, link->inertia * S * i * slope);
        series_add(&B,
                   link->inertia * S * (i * k.second_derivative + (half_i1 + self->drag) * slope * slope));
        series_add(&C, -link->weight * S * lift_of(link, rolls) / 2);
        if (link->i + 1 >= geometry->n || !link->leads)
            break;
        const struct arms arms = rolls ? rounded_arms(link) : sharp_arms(link);
        walk_bend(&k, rolls);
        if (equation_done(&k, S, arms.ratio, &A, &B, &C, rolls))
            break;
        wrong_side = wrong_side || (link->geometry->mu != 0 && arms.b <= 0);
        if (link->contact.X < 0)
            noise += 2 * (arms.b_plain / fabs(arms.b) - 1);
        S *= arms.ratio; /* (55; e4) */
        walk_next(&k, rolls, true);
    }
    chain_count(geometry, link->i + 1);
    if (rolls)
        rounded_count(geometry);
    if (geometry->work && geometry->mu != 0)
        geometry->work->entered[DOM_EFFECT_friction]++;
    *equation = (struct equation_of_motion){.A = A.sum + A.lost,
                                            .B = B.sum + B.lost,
                                            .C = C.sum + C.lost,
                                            .A_size = A.size * noise,
                                            .B_size = B.size * noise,
                                            .C_size = C.size * noise,
                                            .n = link->i + 1};
    equation->locks = wrong_side || equation->A <= 0;
    return isfinite(equation->A) && isfinite(equation->B) && isfinite(equation->C) ? DOM_OK : DOM_NOT_FINITE;
}

KERNEL enum dom_status chain_equation(const struct geometry *geometry, struct tilt head,
                                      struct equation_of_motion *equation)
{
    return geometry->law->rolls ? equation_by(geometry, head, true, equation)
                                : equation_by(geometry, head, false, equation);
}

/* ---- The difference between the tilts of a domino in two chains ---- */

/* The difference between the tilts of a domino in two chains, and the tangent of half the difference. */
struct apart {
    real by, t;
};

KERNEL_LOOP struct apart apart_by(real t)
{
    return (struct apart){2 * atan(t), t};
}

/*
 * Returns h(A) - h(B): how much the potential energy of a domino differs between its tilts a and b, whose
 * angles are A and B. Subtracting two nearly equal energies would lose digits. So the difference is computed
 * from t = tan((A - B)/2), as the product
 *
 *     2 sin((A - B)/2) [h.x cos((A + B)/2) - h.y sin((A + B)/2)].
 */
KERNEL_LOOP real energy_change(const struct geometry *geometry, struct tilt a, struct tilt b,
                               struct apart apart, const bool rolls)
{
    const real change = apart.t * (geometry->h.x * (a.y + b.y) - geometry->h.y * (a.x + b.x));
    return rolls ? change + geometry->rounded.roll * apart.by : change;
}

KERNEL real rounded_fall(const struct geometry *geometry, struct tilt t)
{
    return -energy_change(geometry, t, standing, apart_by(half_of_tilt(t)), true);
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

/* Returns the energy that a follower gains until it has detached and stays at theta_f. It is now at the tilt
 * `now`, and leans on *leader. */
KERNEL_LOOP real energy_left(const struct geometry *geometry, struct tilt now, const struct link *leader,
                             const bool rolls)
{
    const real t = rolls ? tan_half_between(now, geometry->f) : leaving_half_turn(geometry, leader);
    return energy_change(geometry, geometry->f, now, apart_by(t), rolls);
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
               link->weight * energy_change(link->geometry, link->tilt, b->link.tilt, p->apart, rolls));
    if (bends)
        p->H2 += link->weight * (p->a.second_derivative * lift_of(link, rolls) -
                                 link->slope * link->slope * geometry_height(link->geometry, link->tilt));
}

/* Finds the difference between the followers, and returns true when the tails of dH, J and H1 can be left
 * out. */
KERNEL_LOOP bool pair_done(struct pair *p, const struct walk *b, const bool rolls)
{
    const struct link *link = &p->a.link;
    const struct apart now = p->apart;
    real shrink;
    if (rolls) {
        p->apart = apart_next(&p->a, b, now);
        shrink = now.by == 0 ? 1 : fabs(p->apart.by / now.by);
    } else {
        shrink = pair_shrink(link, &b->link, now.t);
        p->apart = (struct apart){2 * (now.t * shrink), now.t * shrink};
    }
    return done_dH(&p->state, link, fabs(now.by), shrink, rolls) && done_J(&p->state, link) &&
           done_H1(&p->state, link, link->geometry->tol, rolls);
}

KERNEL_LOOP bool pair_near(const struct pair *p, const struct walk *b)
{
    return far_suffices(p->a.link.geometry, &p->state, &p->a.link, &b->link, p->apart.t, true);
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

KERNEL_LOOP void other_next(struct walk *b, const bool rolls)
{
    if (rolls)
        rounded_step(b); /* only the tilts of chain b are needed */
    else
        link_next(&b->link);
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
    const bool bends = pass == PASS_SECOND_DERIVATIVE;
    struct pair p = pair_begin(geometry, from, head, t, rolls);
    const struct link *link = &p.a.link;
    struct walk b = walk_begin(geometry, from, rolls);
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
            const struct link leader = b.link;
            other_next(&b, rolls);
            p.state.left =
                link->weight * geometry->weight * energy_left(geometry, b.link.tilt, &leader, rolls);
            series_add(&p.state.dH, p.state.left);
            break;
        }
        if (pass == PASS_PUSHES && pushes) {
            if (rolls)
                rounded_levers(&b);
            pushes = contact_pushes(&p.a, &b);
        }
        if (pair_done(&p, &b, rolls))
            break;
        other_next(&b, rolls);
        if (bends)
            walk_bend(&p.a, rolls);
        walk_next(&p.a, rolls, bends);
    }
    enum dom_status status = pass_result(geometry, &p.state, p.H2, link->i + 1, rolls, sums);
    sums->pushes = pushes;
    return status;
}

/* In each of these calls `pass` and `rolls` are constants, so the compiler removes the sums that are not
 * needed. */
KERNEL_LOOP enum dom_status change_by(const struct geometry *geometry, struct tilt from, struct tilt head,
                                      real t, enum pass pass, const bool rolls, struct sums *sums)
{
    switch (pass) {
    case PASS_SECOND_DERIVATIVE:
        return chain_difference(geometry, from, head, t, PASS_SECOND_DERIVATIVE, rolls, sums);
    case PASS_PUSHES:
        return chain_difference(geometry, from, head, t, PASS_PUSHES, rolls, sums);
    default:
        return chain_difference(geometry, from, head, t, PASS_PLAIN, rolls, sums);
    }
}

KERNEL enum dom_status chain_change_by(const struct geometry *geometry, struct tilt from, struct tilt head,
                                       real t, enum pass pass, struct sums *sums)
{
    return geometry->law->rolls ? change_by(geometry, from, head, t, pass, true, sums)
                                : change_by(geometry, from, head, t, pass, false, sums);
}

/* ---- The fuel ---- */

/*
 * Finds J at theta_c (20; c2), and H(theta_c) - H(0) (19; c1), which is minus the fuel (25; c7). During the
 * cycle, each domino turns to the initial tilt of its follower. So one chain is enough: the chain at theta_c,
 * shifted by one domino, is the chain at 0.
 */
KERNEL_LOOP enum dom_status fuel_by(const struct geometry *geometry, const bool rolls, struct sums *sums)
{
    struct sum_state a = {0};
    struct walk k = walk_begin(geometry, geometry->c, rolls);
    const struct link *link = &k.link;
    struct link leader = rolls ? (struct link){.tilt = standing} : link_head(geometry, standing);
    const real half = half_of_tilt(geometry->c);
    struct apart turn = {rolls ? k.theta : 2 * half, half};
    const bool closes = geometry->far.order > 0 && geometry->n == CHAIN_ENDLESS;
    for (;;) {
        enum dom_status status = chain_watch(geometry, link->i);
        if (status != DOM_OK)
            return status;
        if (closes && far_suffices(geometry, &a, link, &leader, turn.t, false)) {
            far_add(geometry, &a, link, &leader, turn.t);
            break;
        }
        add_J(&a, link, rolls);
        series_add(&a.dH, link->weight * energy_change(geometry, link->tilt, leader.tilt, turn, rolls));
        if (link->i + 1 >= geometry->n)
            break;
        if (!link->leads) {
            a.left = link->weight * geometry->weight * energy_left(geometry, link->tilt, &leader, rolls);
            series_add(&a.dH, a.left);
            break;
        }
        const real t = rolls ? half_of_tilt(k.turn.tilt) : link->contact.X / (1 + link->contact.Y);
        const struct apart next = {rolls ? k.turn.angle : 2 * t, t};
        if (done_dH(&a, link, fabs(turn.by), fabs(next.by / turn.by), rolls) && done_J(&a, link))
            break;
        turn = next;
        leader = *link;
        walk_next(&k, rolls, false);
    }
    return pass_result(geometry, &a, 0, link->i + 1, rolls, sums);
}

KERNEL enum dom_status chain_fuel(const struct geometry *geometry, struct sums *sums)
{
    return geometry->law->rolls ? fuel_by(geometry, true, sums) : fuel_by(geometry, false, sums);
}
