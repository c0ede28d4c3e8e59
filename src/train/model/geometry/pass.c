/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The passes down a chain. Each pass visits the dominoes from the head down. There is one set of passes:
 * `rolls` says whether the edges are rounded. It is a constant in every call below. The step from a domino to
 * its follower is link_next.
 */
#include "geometry/chain.h"

/* ---- The terms of one domino ---- */

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
    series_add(&a->J, k->inertia * k->slope * k->slope * inertia_of(k, rolls));
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

/* Counts the pass, and returns its sums. */
static enum dom_status pass_result(const struct geometry *geometry, struct sum_state a, real H2, size_t n,
                                   struct sums *sums)
{
    chain_count(geometry, n);
    *sums = (struct sums){.J = a.J.sum + a.J.lost,
                          .H1 = a.H1.sum + a.H1.lost,
                          .H2 = H2,
                          .dH = a.dH.sum + a.dH.lost,
                          .left = a.left,
                          .n = n};
    return isfinite(sums->J) && isfinite(sums->H1) && isfinite(sums->dH) ? DOM_OK : DOM_NOT_FINITE;
}

/* ---- Sums at one tilt ---- */

/* Finds J and H1. If `sign` is true, ends as soon as the sign of H1 is certain, and J is not complete. */
KERNEL_LOOP enum dom_status sum_by(const struct geometry *geometry, struct tilt head, bool sign,
                                   const bool rolls, struct sums *sums)
{
    /* a tail of at most 7/8 of the sum cannot change its sign */
    const real tol_H1 = sign ? (real)0.875 / TAIL_SHARE : geometry->tol;
    struct sum_state a = {0};
    struct link k = link_head(geometry, head, rolls);
    const struct link *link = &k;
    for (;; link_next(&k, rolls, false)) {
        enum dom_status status = chain_watch(geometry, link->i);
        if (status != DOM_OK)
            return status;
        add_J(&a, link, rolls);
        add_H1(&a, link, rolls);
        if (link->i + 1 >= geometry->n || !link->leads ||
            (done_H1(&a, link, tol_H1, rolls) && (sign || done_J(&a, link))))
            break;
    }
    return pass_result(geometry, a, 0, link->i + 1, sums);
}

KERNEL enum dom_status chain_sum(const struct geometry *geometry, struct tilt head, bool sign,
                                 struct sums *sums)
{
    return geometry->rolls ? sum_by(geometry, head, sign, true, sums)
                           : sum_by(geometry, head, sign, false, sums);
}

/* ---- The equation of motion at one tilt ---- */

/*
 * With rounded edges, the inertia i of a domino depends on its tilt. So its term in A contains i theta', and
 * its term in B contains i theta'' + (i'/2 + drag) theta'^2.
 *
 * The pass ends when the tails of all three sums can be left out. Each tail is bounded by a geometric series.
 * The ratio of this series is at least `decay`, because without friction the ratio of successive terms of C
 * tends to `decay` far down an endless train.
 */
KERNEL_LOOP enum dom_status equation_by(const struct geometry *geometry, struct tilt head, const bool rolls,
                                        struct equation_of_motion *equation)
{
    struct series A = {0}, B = {0}, C = {0};
    struct link k = link_head(geometry, head, rolls);
    const struct link *link = &k;
    /* The rounding error of S, in units of the unit roundoff, is at most `noise` S. It grows if X < 0, since
     * digits then cancel in the arm b. With rounded edges an arm takes more operations; 8 is a choice, with
     * which 12,000 random trains in float are solved. */
    real S = 1, noise = rolls ? 8 : 1;
    bool wrong_side = false; /* true if b <= 0: a contact force passes on the wrong side of a hinge */
    for (;; link_next(&k, rolls, true)) {
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
        const struct arms arms = link_arms(link, rolls);
        link_bend(&k, rolls);
        const real size = fabs(S), passed = fabs(arms.ratio),
                   bends = fabs(k.second_derivative) + slope * slope * (fabs(k.curve) + 1 + self->drag),
                   next = fmax(self->inertia * passed, fmax(self->decay, self->decay_J));
        if (series_done(&C, link->weight * size * steepest_of(self, rolls),
                        fmax(self->weight * passed, self->decay), self->tol) &&
            series_done(&A, link->inertia * size * fabs(slope), next, self->tol) &&
            series_done(&B, link->inertia * size * bends, next, self->tol))
            break;
        wrong_side = wrong_side || (self->mu != 0 && arms.b <= 0);
        if (link->contact.X < 0)
            noise += 2 * (arms.b_plain / fabs(arms.b) - 1);
        S *= arms.ratio; /* (55; e4) */
    }
    chain_count(geometry, link->i + 1);
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
    return geometry->rolls ? equation_by(geometry, head, true, equation)
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

/*
 * Returns the difference between the tilts of the followers of a and b. `apart` is the difference between the
 * tilts of a and b themselves. The turn is the angle from a domino to its follower. Let D be the turn of a
 * minus the turn of b. Subtracting the contact equation of b from that of a gives
 *
 *     l_1 (Y_a + Y_b) tan(D/2) + rho_1 D cos theta_a = R.
 *
 * Every term of R is proportional to the difference between a and b, so D is accurate even if this difference
 * is tiny. The stored turns of a and b could give D by a subtraction, but digits would cancel. Only the term
 * 2 tan(D/2) - D, called `excess`, is computed from that subtraction. If D is small, this term is about
 * D^3/12, so its error does not matter.
 */
KERNEL_LOOP struct apart apart_next(const struct link *a, const struct link *b, struct apart apart)
{
    const struct geometry *geometry = a->geometry;
    const struct rounded *of = &geometry->rounded;
    struct tilt A = a->tilt, B = b->tilt;
    real by = apart.by, t = apart.t, sines = t * (A.x + B.x), cosines = t * (A.y + B.y);
    real D = a->turn.angle - b->turn.angle, excess = 2 * tan(D / 2) - D;
    real more = of->rho - of->rho_1, c = of->rho_1 * A.y,
         R = more * (sines - cosines + by * A.y - b->theta * sines) +
             sines * (of->rho_1 * b->turn.angle - geometry->L);
    real t_D = (R + c * excess) / (of->tall_1 * (a->turn.tilt.y + b->turn.tilt.y) + 2 * c);
    const real t_1 = (t + t_D) / (1 - t * t_D);
    /* a sum would keep the rounding errors of the first dominoes, so `by` would never become small */
    return (struct apart){t_1 * t_1 < ROUNDOFF ? 2 * t_1 : by + 2 * t_D - excess, t_1};
}

/* ---- The pass that compares two chains ---- */

/* Returns the difference between the tilts of the followers of a and b. If `shifted`, b is the leader of a,
 * and the difference is the turn from a to its follower. */
KERNEL_LOOP struct apart followers_apart(const struct link *a, const struct link *b, struct apart apart,
                                         const bool shifted, const bool rolls)
{
    if (shifted) {
        /* Near theta_inf, the turn has only rounding errors, which would go on for ever. The slope decreases
         * with the tilt, so it bounds the turn. */
        const struct apart most = {apart.by * b->contact.slope, apart.t * b->contact.slope};
        const real t = rolls ? half_of_tilt(a->turn.tilt) : a->contact.X / (1 + a->contact.Y);
        return fabs(t) > most.t ? most : (struct apart){rolls ? a->turn.angle : 2 * t, t};
    }
    if (rolls)
        return apart_next(a, b, apart);
    /* 1 - G of chain_difference, from the lever arms, since a subtraction would lose digits where G is almost
     * 1 */
    const real t = apart.t, arms = a->contact.arm + b->contact.arm, Y = a->contact.Y + b->contact.Y,
               next = t * arms / (Y + t * t * a->geometry->rL * (a->tilt.x + b->tilt.x));
    return t == 0 ? apart : (struct apart){2 * next, next};
}

/* Moves on to the follower in chain b, of which only the tilts are needed. */
KERNEL_LOOP void other_next(struct link *b, const struct link *a, const bool shifted, const bool rolls)
{
    if (shifted)
        *b = *a;
    else if (rolls)
        rounded_step(b);
    else
        link_next(b, false, false);
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
    const bool bends = pass == PASS_SECOND_DERIVATIVE, shifted = pass == PASS_FUEL;
    struct sum_state sum = {0};
    struct link a = link_head(geometry, head, rolls), b = link_head(geometry, from, rolls);
    const struct link *link = &a;
    struct apart apart = !rolls        ? (struct apart){2 * t, t}
                         : from.x == 0 ? (struct apart){a.theta, t}
                                       : apart_by(t);
    real H2 = 0;
    bool pushes = pass == PASS_PUSHES && geometry->drag == 0; /* the proof is for a chain without drag */
    real far_from = !rolls && geometry->far.order > 0 && geometry->n == CHAIN_ENDLESS ? geometry->far.from
                                                                                      : (real)INFINITY;
    for (;;) {
        enum dom_status status = chain_watch(geometry, link->i);
        if (status != DOM_OK)
            return status;
        if (!rolls && b.tilt.v >= far_from) {
            struct far_tail tail = {.a = link->tilt,
                                    .b = b.tilt,
                                    .t = apart.t,
                                    .weight = link->weight,
                                    .inertia = link->inertia,
                                    .slope = link->slope,
                                    .second_derivative = a.second_derivative};
            far_from = far_find(geometry, &tail, sum);
            if (far_from == 0) {
                series_add(&sum.dH, tail.dH);
                series_add(&sum.H1, tail.H1);
                series_add(&sum.J, tail.J);
                H2 += tail.H2;
                break;
            }
        }
        add_J(&sum, link, rolls);
        if (!shifted)
            add_H1(&sum, link, rolls);
        series_add(&sum.dH, link->weight * energy_change(link->geometry, link->tilt, b.tilt, apart, rolls));
        if (bends)
            H2 += link->weight * (a.second_derivative * lift_of(link, rolls) -
                                  link->slope * link->slope * geometry_height(link->geometry, link->tilt));
        if (link->i + 1 >= geometry->n || !b.leads)
            break;
        if (!link->leads) {
            const struct link leader = b;
            other_next(&b, &a, shifted, rolls);
            const real to_f =
                rolls ? tan_half_between(b.tilt, geometry->f) : leaving_half_turn(geometry, &leader);
            sum.left = link->weight * geometry->weight *
                       energy_change(geometry, geometry->f, b.tilt, apart_by(to_f), rolls);
            series_add(&sum.dH, sum.left);
            break;
        }
        if (pass == PASS_PUSHES && pushes) {
            if (rolls)
                rounded_levers(&b);
            pushes = contact_pushes(&a, &b, PUSHES_HALVINGS);
        }
        const struct apart next = followers_apart(&a, &b, apart, shifted, rolls);
        const struct geometry *self = link->geometry;
        const real by = fabs(apart.by), shrink = by == 0 ? 1 : fabs(next.by) / by;
        if (series_done(&sum.dH, link->weight * by * steepest_of(self, rolls),
                        fmax(self->weight * shrink, self->decay), self->tol) &&
            done_J(&sum, link) && (shifted || done_H1(&sum, link, self->tol, rolls)))
            break;
        apart = next;
        other_next(&b, &a, shifted, rolls);
        if (bends)
            link_bend(&a, rolls);
        link_next(&a, rolls, bends);
    }
    const enum dom_status status = pass_result(geometry, sum, H2, link->i + 1, sums);
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
    case PASS_FUEL:
        return chain_difference(geometry, from, head, t, PASS_FUEL, rolls, sums);
    default:
        return chain_difference(geometry, from, head, t, PASS_PLAIN, rolls, sums);
    }
}

KERNEL enum dom_status chain_change_by(const struct geometry *geometry, struct tilt from, struct tilt head,
                                       real t, enum pass pass, struct sums *sums)
{
    return geometry->rolls ? change_by(geometry, from, head, t, pass, true, sums)
                           : change_by(geometry, from, head, t, pass, false, sums);
}

KERNEL_SHARED enum dom_status chain_change(const struct geometry *geometry, struct tilt from,
                                           struct tilt head, enum pass pass, struct sums *sums)
{
    return chain_change_by(geometry, from, head, tan_half_between(from, head), pass, sums);
}
