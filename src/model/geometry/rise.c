/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Differences of H: two chains side by side, and the far end of both in closed form. */
#include "geometry/bound.h"
#include "geometry/chain.h"

/*
 * h(A) - h(B) of one domino at the tilts a and b, h = cos + d sin, from t = tan((A - B)/2): the product
 * form of 2 sin((A-B)/2) (d cos((A+B)/2) - sin((A+B)/2)), free of cancellation.
 */
KERNEL_LOOP real rise(const struct lean *g, struct tilt a, struct tilt b, real t)
{
    return t * (g->d * (a.y + b.y) - (a.x + b.x));
}

/* The errors of chain_rise, where they are asked for. */
struct rise_bound {
    struct bound a, b;
    real t;
    struct sums sums;
};

static struct rise_bound error_head(const struct lean *g, const struct link *a, const struct link *b, real t)
{
    real angle = lean_error_head(a->tilt);
    return (struct rise_bound){
        .a = bound_head(g, a, angle),
        .b = bound_head(g, b, 0),
        .t = (1 + t * t) * angle / 2 + 3 * UNIT * t,
    };
}

static void error_add(const struct lean *g, struct rise_bound *e, const struct link *a, const struct link *b,
                      real t)
{
    real term = fabs(rise(g, a->tilt, b->tilt, t));
    e->sums.J += bound_J(a, &e->a);
    e->sums.H1 += bound_H1(g, a, &e->a);
    e->sums.dH += a->weight * (bound_rise(g, a->tilt, b->tilt, e->a.angle, e->b.angle, t, e->t) +
                               term * (e->a.weight + UNIT));
}

/*
 * tan((theta_f - theta_1) / 2) for the follower that leaves at theta_f and stood at theta_1 when its leader
 * was upright's: the step of chain_rise from theta_leave, where a = 0, so Y = r L x, and
 * cos - cos theta_leave = (leave_at - leave_by v) / leave_by is what the leader's arm is made of.
 */
static real leaving_half_turn(const struct lean *g, const struct link *leader)
{
    real rL = g->r * g->L, x = leader->tilt.x, sines = g->leave.x + x, Y = leader->turn.Y;
    if (sines == 0) /* r s = 1: it lies at theta_f from the first */
        return 0;
    real t = leader->turn.arm * (Y + rL * x) / (g->leave_by * sines);
    real whole = rL * g->leave.x + Y, F = leader->turn.arm / whole, G = rL * sines / whole;
    return t * F / (1 + t * t * G);
}

/* How far a tilt is from theta_inf, to the second order. */
KERNEL_LOOP real far_off(const struct lean *g, struct tilt tilt)
{
    real part = (g->inf.v - tilt.v) * g->far.per_sine;
    return part + part * part * g->far.half_cot;
}

/* Is the last term of a tail below the tolerance of the sum with it?  rest is the first, which may cancel the
 * sum. */
KERNEL_LOOP bool far_done(const struct series *s, real rest, real last, real tol)
{
    return fabs(last) <= TAIL_SHARE * fmax(tol * fabs(s->sum + rest), UNIT * s->size);
}

/*
 * The rest of a pass from a and b on: are both so near to theta_inf that the last term of the series there
 * does not matter?
 */
KERNEL_LOOP bool far_near(const struct lean *g, const struct sum_state *state, const struct link *a,
                          const struct link *b, real t)
{
    const struct far *far = &g->far;
    real off = far_off(g, b->tilt), H = a->weight * 2 * t;
    if (!far_done(&state->dH, H * far->H1, H * far->H3 * off * off, g->tol) || off > g->inf.x / 16)
        return false;
    real e = far_off(g, a->tilt), H1 = a->weight * a->slope, J = a->inertia * a->slope * a->slope;
    return far_done(&state->H1, H1 * far->H1, H1 * far->H3 * e * e, g->tol) &&
           far_done(&state->J, J * far->J0, J * far->J2 * e * e, g->tol);
}

static void far_add(const struct lean *g, struct sum_state *state, const struct link *a, const struct link *b,
                    real t)
{
    const struct far *far = &g->far;
    real off = far_off(g, b->tilt),
         e = far_off(g, a->tilt); /* before theta_inf: they deviate by -off and -e */
    series_add(&state->dH,
               a->weight * 2 * t * (1 - t * t / 3) *
                   (far->H1 - far->H2 * (e + off) / 2 + far->H3 * (e * e + e * off + off * off) / 6));
    series_add(&state->H1, a->weight * a->slope * (far->H1 - far->H2 * e + far->H3 * e * e / 2));
    series_add(&state->J, a->inertia * a->slope * a->slope * (far->J0 - far->J1 * e + far->J2 * e * e / 2));
}

/* H2 of one domino, whose theta'' is bend, and of all from there on. */
KERNEL_LOOP real bend_H2(const struct link *k, real bend)
{
    return k->weight * (bend * (k->lean->d * k->tilt.y - k->tilt.x) -
                        k->slope * k->slope * (k->tilt.y + k->lean->d * k->tilt.x));
}

static real far_H2(const struct link *k, real bend)
{
    return k->weight * (bend * k->lean->far.H1 + k->slope * k->slope * k->lean->far.H2);
}

/* One pair of dominoes into the sums. */
KERNEL_LOOP void pair_add(struct sum_state *state, const struct link *a, const struct link *b, real t)
{
    add_J(state, a);
    add_H1(state, a);
    series_add(&state->dH, a->weight * rise(a->lean, a->tilt, b->tilt, t));
}

/* By what t shrinks from a pair to the next: the arms keep the digits of 1 - G. */
KERNEL_LOOP real pair_shrinks(const struct link *a, const struct link *b, real t)
{
    real arms = a->turn.arm + b->turn.arm, Y = a->turn.Y + b->turn.Y;
    return t == 0 ? 1 : arms / (Y + t * t * a->lean->rL * (a->tilt.x + b->tilt.x));
}

/* Does the tail behind this pair matter? */
KERNEL_LOOP bool pair_done(struct sum_state *state, const struct link *a, real t, real shrinks, real tol)
{
    real ratio = fmax(a->lean->weight * shrinks, a->lean->decay);
    return series_done(&state->dH, a->weight * 2 * t * a->lean->reach, ratio, tol) && done_J(state, a) &&
           done_H1(state, a, tol);
}

/* What a pass is asked for: a constant of each caller, so that the others do not pay for it. */
enum {
    PASS_ERROR = 1, /* bounds */
    PASS_SHIFT = 2, /* a is the endless train at theta_c: b, from its second domino on */
    PASS_BEND = 4,  /* H2 */
};

/*
 * Two chains run side by side: a from the head's tilt, b from upright.  With t = tan((theta_a - theta_b)/2)
 * of one domino, its follower has, exactly, t (1 - G) / (1 + t^2 G), G = r L (x_a + x_b) / (Y_a + Y_b),
 * because X_a - X_b = r L (y_a - y_b).  G is the slope's r L x / Y (b10) between the two tilts; so the
 * smallest differences keep their digits.
 */
KERNEL_LOOP enum dom_status rise_between(const struct lean *g, struct tilt from, struct tilt head, real t,
                                         const int pass, struct sums *sums, struct sums *error)
{
    struct sum_state state = {0};
    struct link a = link_head(g, head), b = link_head(g, from);
    struct rise_bound e;
    real H2 = 0, bend = 0;
    bool ended = true, closes = !(pass & PASS_ERROR) && !g->falls_off && !g->behind && g->n == CHAIN_ENDLESS;
    if (pass & PASS_ERROR)
        e = error_head(g, &a, &b, t);
    for (;;) {
        enum dom_status status = chain_watch(g, a.i);
        if (status != DOM_OK)
            return status;
        if (closes && far_near(g, &state, &a, &b, t)) {
            far_add(g, &state, &a, &b, t);
            if (pass & PASS_BEND)
                H2 += far_H2(&a, bend);
            break;
        }
        pair_add(&state, &a, &b, t);
        if (pass & PASS_BEND)
            H2 += bend_H2(&a, bend);
        if (pass & PASS_ERROR)
            error_add(g, &e, &a, &b, t);
        if (a.i + 1 >= g->n || !b.leads)
            break;
        if (!a.leads) {
            /* The follower has left during this cycle: it keeps the energy of theta_f. */
            struct link leader = b;
            if (pass & PASS_SHIFT) {
                b.tilt = a.tilt;
                b.weight = a.weight * g->weight;
            } else {
                link_next(&b);
            }
            real t_f = leaving_half_turn(g, &leader);
            state.left = b.weight * rise(g, g->f, b.tilt, t_f);
            series_add(&state.dH, state.left);
            if (pass & PASS_ERROR) {
                real angle = lean_error_f(g), t_error = bound_leaving(g, &leader, &e.b, t_f);
                bound_next(g, &leader, &b, &e.b);
                e.sums.dH += b.weight * (bound_rise(g, g->f, b.tilt, angle, e.b.angle, t_f, t_error) +
                                         fabs(rise(g, g->f, b.tilt, t_f)) * (e.b.weight + UNIT));
            }
            break;
        }
        real shrinks = pair_shrinks(&a, &b, t);
        ended = false;
        if (pair_done(&state, &a, t, shrinks, g->tol))
            break;
        ended = true;
        if (pass & PASS_ERROR)
            e.t = bound_half_turn(&a, &b, &e.a, &e.b, t, e.t);
        t *= shrinks;
        struct link leader_a = a, leader_b = b;
        link_next(&a);
        if (pass & PASS_SHIFT) {
            b.tilt = leader_a.tilt;
            b.turn = leader_a.turn;
        } else {
            link_next(&b);
        }
        if (pass & PASS_BEND)
            bend = link_bend(&leader_a, bend, &a);
        if (pass & PASS_ERROR) {
            bound_next(g, &leader_a, &a, &e.a);
            bound_next(g, &leader_b, &b, &e.b);
        }
    }
    if (pass & PASS_ERROR)
        *error = (struct sums){.J = e.sums.J + series_error(&state.J, ended),
                               .H1 = e.sums.H1 + series_error(&state.H1, ended),
                               .dH = e.sums.dH + series_error(&state.dH, ended)};
    return sum_result(g, &state, H2, a.i + 1, sums);
}

/* tan of half the difference; exact where it is the whole tilt. */
static real half_turn(struct tilt from, struct tilt head)
{
    real sine = head.x * from.y - head.y * from.x, cosine = head.y * from.y + head.x * from.x;
    return sine / (1 + cosine);
}

/* Bounds of what another pass gave for the same: those of one that follows every domino, and the difference.
 */
static enum dom_status rise_error(const struct lean *g, struct tilt head, const struct sums *sums,
                                  struct sums *error)
{
    struct sums whole;
    enum dom_status status = rise_between(g, standing, head, half_of_tilt(head), PASS_ERROR, &whole, error);
    if (status == DOM_OK) {
        error->J += fabs(sums->J - whole.J);
        error->H1 += fabs(sums->H1 - whole.H1);
        error->dH += fabs(sums->dH - whole.dH);
    }
    return status;
}

KERNEL enum dom_status chain_rise(const struct lean *g, struct tilt head, struct sums *sums,
                                  struct sums *error)
{
    enum dom_status status = rise_between(g, standing, head, half_of_tilt(head), 0, sums, NULL);
    return status == DOM_OK && error ? rise_error(g, head, sums, error) : status;
}

KERNEL enum dom_status chain_fall(const struct lean *g, struct sums *sums, struct sums *error)
{
    enum dom_status status = rise_between(g, standing, g->c, half_of_tilt(g->c), PASS_SHIFT, sums, NULL);
    return status == DOM_OK && error ? rise_error(g, g->c, sums, error) : status;
}

KERNEL enum dom_status chain_rise_from(const struct lean *g, struct tilt from, struct tilt head,
                                       struct sums *sums)
{
    return rise_between(g, from, head, half_turn(from, head), 0, sums, NULL);
}

KERNEL enum dom_status chain_rise_by(const struct lean *g, struct tilt from, struct tilt head, real by,
                                     struct sums *sums)
{
    return rise_between(g, from, head, tan(by / 2), 0, sums, NULL);
}

KERNEL enum dom_status chain_bend_from(const struct lean *g, struct tilt from, struct tilt head,
                                       struct sums *sums)
{
    return rise_between(g, from, head, half_turn(from, head), PASS_BEND, sums, NULL);
}

KERNEL enum dom_status chain_both(const struct lean *g, struct tilt head, struct sums *sums,
                                  struct sums *fall)
{
    struct sum_state up = {0}, down = {0};
    struct link a = link_head(g, head), b = link_head(g, standing), c = link_head(g, g->c);
    real t = half_of_tilt(head), t_c = half_of_tilt(g->c), H2 = 0, bend = 0;
    for (;;) {
        enum dom_status status = chain_watch(g, a.i);
        if (status != DOM_OK)
            return status;
        if (far_near(g, &up, &a, &b, t) && far_near(g, &down, &c, &b, t_c)) {
            far_add(g, &up, &a, &b, t);
            far_add(g, &down, &c, &b, t_c);
            H2 += far_H2(&a, bend);
            break;
        }
        pair_add(&up, &a, &b, t);
        pair_add(&down, &c, &b, t_c);
        H2 += bend_H2(&a, bend);
        real shrinks = pair_shrinks(&a, &b, t), shrinks_c = pair_shrinks(&c, &b, t_c);
        if (pair_done(&up, &a, t, shrinks, g->tol) && pair_done(&down, &c, t_c, shrinks_c, g->tol))
            break;
        t *= shrinks;
        t_c *= shrinks_c;
        struct link leader = a;
        link_next(&a);
        bend = link_bend(&leader, bend, &a);
        b.tilt = c.tilt;
        b.turn = c.turn;
        link_next(&c);
    }
    *fall = sums_of(&down, 0, a.i + 1);
    return sums_finite(fall) ? sum_result(g, &up, H2, a.i + 1, sums) : DOM_NOT_FINITE;
}
