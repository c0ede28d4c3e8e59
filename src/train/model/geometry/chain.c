/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The passes down a chain, each from the head down: equation_by sums the terms of the equation of motion, and
 * chain_pass the terms of H and J. `rolls` says whether the edges are rounded. It is a constant in every call
 * below. The step from a domino to its follower is link_next.
 */
#include "geometry/chain.h"

/* ---- The terms of one domino ---- */

KERNEL_LOOP real inertia_of(const struct link *k, const bool rolls)
{
    return rolls ? geometry_inertia(k->geometry, k->tilt) : 1;
}

/* Returns an upper bound on |geometry_lift|. */
KERNEL_LOOP real steepest_of(const struct geometry *geometry, const bool rolls)
{
    return rolls ? geometry->steepest + fabs(geometry->rounded.roll) : geometry->steepest;
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
    /* The rounding error of S, in units of the unit roundoff, is at most `noise` S. It grows if X < 0, since
     * digits then cancel in the arm b. With rounded edges an arm takes more operations; 8 is a choice, with
     * which 12,000 random trains in float are solved. */
    real S = 1, noise = rolls ? 8 : 1;
    bool wrong_side = false; /* true if b <= 0: a contact force passes on the wrong side of a hinge */
    for (;; link_next(&k, rolls, true)) {
        enum dom_status status = chain_watch(geometry, k.i);
        if (status != DOM_OK)
            return status;
        const struct geometry *self = k.geometry;
        const real i = inertia_of(&k, rolls), slope = k.slope,
                   half_i1 = rolls ? geometry_inertia_slope(self, k.tilt) / 2 : 0;
        series_add(&A, k.inertia * S * i * slope);
        series_add(&B, k.inertia * S * (i * k.second_derivative + (half_i1 + self->drag) * slope * slope));
        series_add(&C, -k.weight * S * geometry_lift(self, k.tilt) / 2);
        if (k.i + 1 >= geometry->n || !k.leads)
            break;
        const struct arms arms = link_arms(&k, rolls);
        link_bend(&k, rolls);
        const real size = fabs(S), passed = fabs(arms.ratio),
                   bends = fabs(k.second_derivative) + slope * slope * (fabs(k.curve) + 1 + self->drag),
                   next = fmax(self->inertia * passed, fmax(self->decay, self->decay_J));
        if (series_done(&C, k.weight * size * steepest_of(self, rolls),
                        fmax(self->weight * passed, self->decay), self->tol) &&
            series_done(&A, k.inertia * size * fabs(slope), next, self->tol) &&
            series_done(&B, k.inertia * size * bends, next, self->tol))
            break;
        wrong_side = wrong_side || (self->mu != 0 && arms.b <= 0);
        if (k.contact.X < 0)
            noise += 2 * (arms.b_plain / fabs(arms.b) - 1);
        S *= arms.ratio; /* (55; e4) */
    }
    chain_count(geometry, k.i + 1);
    *equation = (struct equation_of_motion){.A = A.sum + A.lost,
                                            .B = B.sum + B.lost,
                                            .C = C.sum + C.lost,
                                            .A_size = A.size * noise,
                                            .B_size = B.size * noise,
                                            .C_size = C.size * noise,
                                            .n = k.i + 1};
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
 * leader reaches theta_leave. The formula of followers_apart, applied to the leader's tilts theta_leave and
 * theta, gives the result. In this formula, Y at theta_leave is r L x, because the arm is 0 there. Let t
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

/* ---- The pass ---- */

/*
 * Returns the difference between the tilts of the followers of a and b. If `shifted`, b is the leader of a,
 * and the difference is the turn from a to its follower. Otherwise, with sharp edges, X_a - X_b = r L (y_a -
 * y_b). So if t is the tangent of half the difference between a and b, that of their followers is exactly
 *
 *     t (1 - G) / (1 + t^2 G),   G = r L (x_a + x_b) / (Y_a + Y_b).
 *
 * G is a mean of the values of r L x / Y in the two chains. The slope of a contact is 1 - r L x / Y
 * (14; b10).
 */
KERNEL_LOOP struct apart followers_apart(const struct link *a, const struct link *b, struct apart apart,
                                         const bool shifted, const bool rolls)
{
    const real Y = a->contact.Y + b->contact.Y;
    if (shifted) {
        /* Near theta_inf, the turn has only rounding errors, which would go on for ever. The slope decreases
         * with the tilt, so it bounds the turn. */
        const struct apart most = {apart.by * b->contact.slope, apart.t * b->contact.slope};
        const real t = a->contact.X / (1 + a->contact.Y);
        return fabs(t) > most.t ? most : (struct apart){rolls ? a->turn.angle : 2 * t, t};
    }
    if (rolls)
        return apart_next(a, b, apart);
    if (apart.t == 0)
        return apart;
    /* 1 - G comes from the lever arms, since a subtraction would lose digits where G is almost 1 */
    const real t = apart.t * (a->contact.arm + b->contact.arm) /
                   (Y + apart.t * apart.t * a->geometry->rL * (a->tilt.x + b->tilt.x));
    return (struct apart){2 * t, t};
}

/* Moves on to the follower in chain b, of which only the tilts are needed. If `shifted`, this follower is the
 * domino of chain a. Copying all its members would take a third of the time of a pass. */
KERNEL_LOOP void other_next(struct link *b, const struct link *a, const bool shifted, const bool rolls)
{
    if (shifted) {
        b->tilt = a->tilt;
        b->contact = a->contact;
        b->leads = a->leads;
    } else if (rolls)
        rounded_step(b);
    else
        link_next(b, false, false);
}

/* Returns the change of the energy of a follower that leans on b, but no longer on a: it has detached between
 * the two tilts, and is at theta_f. Moves on to the follower in chain b. */
KERNEL_LOOP real detached_change(const struct geometry *geometry, const struct link *a, struct link *b,
                                 const bool shifted, const bool rolls)
{
    const real leaving = rolls ? 0 : leaving_half_turn(geometry, b);
    other_next(b, a, shifted, rolls);
    const real to_f = rolls ? tan_half_between(b->tilt, geometry->f) : leaving;
    return a->weight * geometry->weight *
           energy_change(geometry, geometry->f, b->tilt, apart_by(to_f), rolls);
}

/* Returns true if a pass compares two chains. */
KERNEL_LOOP bool pass_compares(const enum pass pass)
{
    return pass != PASS_SUMS && pass != PASS_SIGN;
}

/* Returns true if all dominoes behind a can be left out of the sums that the pass needs. `apart` and `next`
 * are the differences between the two chains at domino a and at its follower. */
KERNEL_LOOP bool pass_done(const struct sum_state *sum, const struct link *a, struct apart apart,
                           struct apart next, real tol, const enum pass pass, const bool rolls)
{
    const struct geometry *self = a->geometry;
    const real by = fabs(apart.by), shrink = by == 0 ? 1 : fabs(next.by) / by, slope = a->contact.slope;
    /* a tail of at most 7/8 of the sum cannot change its sign */
    const real tol_H1 = pass == PASS_SIGN ? (real)0.875 / TAIL_SHARE : tol;
    /* Rounding an edge never increases the inertia, so the bound on the tail of J holds for rounded edges as
     * well. */
    return (!pass_compares(pass) || series_done(&sum->dH, a->weight * by * steepest_of(self, rolls),
                                                fmax(self->weight * shrink, self->decay), tol)) &&
           (pass == PASS_SIGN || series_done(&sum->J, a->inertia * a->slope * a->slope,
                                             fmax(self->inertia * slope * slope, self->decay_J), tol)) &&
           (pass == PASS_FUEL || series_done(&sum->H1, a->weight * a->slope * steepest_of(self, rolls),
                                             fmax(self->weight * slope, self->decay), tol_H1));
}

/*
 * Finds the sums of chain a, whose head is at `head`, and, if the pass compares two chains, H(head) -
 * H(from). Subtracting two nearly equal energies would lose digits. So each domino's term of the difference
 * is computed from `apart`, the difference between its tilts in chain a and in chain b, whose head is at
 * `from`. The loop moves down both chains and adds the terms of each domino. It ends
 * - if the series of far.c give the rest of all sums,
 * - after the last domino of the chain,
 * - where the follower has detached. If it still leans on its leader in chain b, its energy differs, too,
 * - if the rest of all sums can be left out.
 */
KERNEL_LOOP enum dom_status chain_pass(const struct geometry *geometry, struct tilt from, struct tilt head,
                                       real t, const enum pass pass, const bool rolls, struct sums *sums)
{
    const bool compares = pass_compares(pass), bends = pass == PASS_SECOND_DERIVATIVE,
               shifted = pass == PASS_FUEL;
    struct sum_state sum = {0};
    struct link a = link_head(geometry, head, rolls), b = compares ? link_head(geometry, from, rolls) : a;
    struct apart apart = rolls ? apart_by(t) : (struct apart){2 * t, t};
    bool pushes = pass == PASS_PUSHES && geometry->drag == 0; /* the proof is for a chain without drag */
    real far_from = !rolls && geometry->far.order > 0 && geometry->n == CHAIN_ENDLESS ? geometry->far.from
                                                                                      : (real)INFINITY;
    for (;;) {
        enum dom_status status = chain_watch(geometry, a.i);
        if (status != DOM_OK)
            return status;
        if (compares && b.tilt.v >= far_from) {
            struct sums tail;
            far_from = far_find(a, b.tilt, apart.t, sum, &tail);
            if (far_from == 0) {
                series_add(&sum.dH, tail.dH);
                series_add(&sum.H1, tail.H1);
                series_add(&sum.J, tail.J);
                sum.H2 += tail.H2;
                break;
            }
        }
        const struct geometry *self = a.geometry;
        series_add(&sum.J, a.inertia * a.slope * a.slope * inertia_of(&a, rolls)); /* (20; c2) */
        if (!shifted)
            series_add(&sum.H1, a.weight * a.slope * geometry_lift(self, a.tilt));
        if (compares) /* (19; c1) */
            series_add(&sum.dH, a.weight * energy_change(self, a.tilt, b.tilt, apart, rolls));
        if (bends)
            sum.H2 += a.weight * (a.second_derivative * geometry_lift(self, a.tilt) -
                                  a.slope * a.slope * geometry_height(self, a.tilt));
        if (a.i + 1 >= geometry->n || !(compares ? b.leads : a.leads))
            break;
        if (!a.leads) {
            sum.left = detached_change(geometry, &a, &b, shifted, rolls);
            series_add(&sum.dH, sum.left);
            break;
        }
        if (pushes) {
            if (rolls)
                rounded_levers(&b);
            pushes = contact_pushes(&a, &b, PUSHES_HALVINGS);
        }
        const struct apart next = followers_apart(&a, &b, apart, shifted, rolls);
        if (pass_done(&sum, &a, apart, next, geometry->tol, pass, rolls))
            break;
        apart = next;
        if (compares)
            other_next(&b, &a, shifted, rolls);
        if (bends)
            link_bend(&a, rolls);
        link_next(&a, rolls, bends);
    }
    chain_count(geometry, a.i + 1);
    *sums = (struct sums){.J = sum.J.sum + sum.J.lost,
                          .H1 = sum.H1.sum + sum.H1.lost,
                          .H2 = sum.H2,
                          .dH = sum.dH.sum + sum.dH.lost,
                          .left = sum.left,
                          .n = a.i + 1,
                          .pushes = pushes};
    return isfinite(sums->J) && isfinite(sums->H1) && isfinite(sums->dH) ? DOM_OK : DOM_NOT_FINITE;
}

/* In each of these calls `pass` and `rolls` are constants, so the compiler removes the sums that are not
 * needed. */
KERNEL_LOOP enum dom_status pass_by(const struct geometry *geometry, struct tilt from, struct tilt head,
                                    real t, enum pass pass, const bool rolls, struct sums *sums)
{
    switch (pass) {
    case PASS_SIGN:
        return chain_pass(geometry, from, head, t, PASS_SIGN, rolls, sums);
    case PASS_SUMS:
        return chain_pass(geometry, from, head, t, PASS_SUMS, rolls, sums);
    case PASS_SECOND_DERIVATIVE:
        return chain_pass(geometry, from, head, t, PASS_SECOND_DERIVATIVE, rolls, sums);
    case PASS_PUSHES:
        return chain_pass(geometry, from, head, t, PASS_PUSHES, rolls, sums);
    case PASS_FUEL:
        return chain_pass(geometry, from, head, t, PASS_FUEL, rolls, sums);
    default:
        return chain_pass(geometry, from, head, t, PASS_PLAIN, rolls, sums);
    }
}

KERNEL enum dom_status chain_change_by(const struct geometry *geometry, struct tilt from, struct tilt head,
                                       real t, enum pass pass, struct sums *sums)
{
    return geometry->rolls ? pass_by(geometry, from, head, t, pass, true, sums)
                           : pass_by(geometry, from, head, t, pass, false, sums);
}

KERNEL_SHARED enum dom_status chain_change(const struct geometry *geometry, struct tilt from,
                                           struct tilt head, enum pass pass, struct sums *sums)
{
    return chain_change_by(geometry, from, head, tan_half_between(from, head), pass, sums);
}

KERNEL enum dom_status chain_sum(const struct geometry *geometry, struct tilt head, bool sign,
                                 struct sums *sums)
{
    return chain_change_by(geometry, head, head, 0, sign ? PASS_SIGN : PASS_SUMS, sums);
}

/* ---- Where a domino detaches ---- */

KERNEL enum dom_status chain_edges(const struct geometry *geometry, real edge[CHAIN_EDGES], int *edges,
                                   real *leave, size_t *domino)
{
    /* With sharp edges and r s = 1, the follower detaches as soon as the head moves, so H' jumps at the tilt
     * 0. Start just after the jump. */
    edge[0] = geometry->short_of == 0 ? REAL_MIN : 0;
    edge[1] = tilt_angle(geometry->c);
    *edges = 2;
    *leave = REAL_NAN;
    *domino = 0;
    if (!geometry->detaches)
        return DOM_OK;
    struct link b = link_head(geometry, standing, geometry->rolls);
    /* The part of the torque on domino b.i that reaches the head. Without friction, this is theta_i'. */
    real passed = 1;
    while (b.leads) {
        enum dom_status status = chain_watch(geometry, b.i);
        if (status != DOM_OK)
            return status;
        /* A domino that contributes less than the rounding errors does not matter, even if it detaches. */
        if (b.i + 1 >= geometry->n || b.weight * fmax(b.slope, passed) < REAL_EPSILON * REAL_EPSILON)
            return DOM_OK;
        const struct arms arms = link_arms(&b, geometry->rolls);
        passed *= fabs(arms.a / arms.b);
        link_on(&b);
    }
    /* When the head is upright, the follower of domino b.i is already detached. The next domino to detach is
     * b.i itself. This happens when the leader of b.i reaches theta_leave. */
    struct tilt head = geometry->leave;
    for (size_t i = b.i; i > 1; i--)
        head = geometry_leader(geometry, head);
    *domino = b.i;
    *leave = tilt_angle(head);
    if (*leave > edge[0] && *leave < edge[1]) {
        edge[2] = edge[1];
        edge[1] = *leave;
        *edges = 3;
    }
    return DOM_OK;
}
