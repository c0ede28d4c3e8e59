/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Computes the train while its head is upright: its fuel, its inertia, and its initial kinetic energy. */
#include "proof/model/energy.h"
#include "proof/model/rest.h"

/* Domino i of the chain, and the sums over all dominoes before domino i. */
struct walk {
    struct domino domino;
    struct span twist;        /* derivative of the slope with respect to r */
    struct span share, power; /* r^(-(q+1) i), r^(-q i) */
    struct span fuel, fuel_by_r, T, T_by_r;
};

static struct span least_zero(struct span a)
{
    return (struct span){least_0(a.lo), a.hi};
}

/* Returns the total derivative of dF/dtheta with respect to r, where dF/dtheta = 1 - r L x / Y. If r changes,
 * the tilt theta_i of the domino changes too, by dtheta_i/dr = `shift`. */
static struct span step_bend(const struct growth *g, const struct contact *c, struct span v,
                             struct span shift)
{
    struct span y = least_zero((struct span){down(1 - v.hi), up(1 - v.lo)}),
                rL = {g->low.rL.lo, g->high.rL.hi};
    struct span off = least_zero(span_over(span_scale(rL, c->x), c->Y));
    /* The partial derivatives of 1 - r L x / Y are
     * - with respect to theta: (r L / Y) ((r L x / Y) (X x / Y) - y)
     * - with respect to r: -L x / Y^3 */
    struct span pull = span_sub(span_scale(off, span_over(span_scale(c->X, c->x), c->Y)), y);
    struct span by_theta = span_over(span_mul(rL, pull), c->Y);
    struct span by_r = span_over(span_over(span_scale(g->shape->L, c->x), span_square(c->Y)), c->Y);
    return span_sub(span_scale(shift, by_theta), by_r);
}

static struct span chain_twist(const struct growth *g, const struct walk *w, const struct contact *c)
{
    if (c->held)
        return span_of(0);
    struct span bend = step_bend(g, c, w->domino.v, w->domino.shift);
    struct span twist = span_add(span_scale(c->slope, w->twist), span_scale(w->domino.slope, bend));
    return c->may_hold ? span_hull(twist, span_of(0)) : twist;
}

/* Adds the term of domino i, r^(-(q+1) i) slope^2, to T. Adds the derivative of this term to dT/dr. */
static void add_inertia(const struct growth *g, struct walk *w, int i)
{
    struct span square = span_square(w->domino.slope),
                per_r = span_over(span_add(g->shape->q, span_of(1)), g->r);
    struct span change = span_sub(span_scale(span_add(w->domino.slope, w->domino.slope), w->twist),
                                  span_scale(span_scale(span_of(i), per_r), square));
    w->T = span_add(w->T, span_scale(w->share, square));
    w->T_by_r = span_add(w->T_by_r, span_scale(w->share, change));
}

/* Adds the term of domino i, r^(-q i) (h(theta_i) - h(theta_(i+1))), to P. Adds the derivative of this term
 * to dP/dr. */
static void add_fuel(const struct growth *g, struct walk *w, const struct link *link, int i)
{
    struct span power = link[0].weight;
    struct span drop = span_sub(link[0].g, link[1].g);
    struct span per_r = span_scale(span_of(i), span_over(g->shape->q, g->r));
    struct span change = span_sub(span_sub(link[0].slide, link[1].slide), span_scale(per_r, drop));
    w->fuel = span_add(w->fuel, span_scale(power, drop));
    w->fuel_by_r = span_add(w->fuel_by_r, span_scale(power, change));
}

/*
 * Adds bounds on the remainders of T and dT/dr.
 *
 * By rest.h, slope_(n+k) <= p^k slope_n. So the terms of T are bounded by a geometric series with the ratio e
 * = r^(-(q+1)) p^2. The terms of dT/dr are
 *
 *     r^(-(q+1) i) (2 slope_i twist_i - (q+1) i/r slope_i^2),
 *
 * where twist_i is the derivative of slope_i with respect to r. The twist of the next domino is
 *
 *     twist_(i+1) = step_i twist_i + slope_i bend_i,   |bend_i| <= Q.
 *
 * So |twist_(n+k)| <= p^k |twist_n| + k p^(k-1) slope_n Q.
 */
static void rest_of_inertia(const struct upright *u, struct walk *w, const struct contact *c,
                            const struct rest *rest)
{
    const struct growth *g = &u->growth;
    double m = g->inertia.hi, p = rest->p, e = up(up(p * p) * m), series = up(1 / least_0(down(1 - e)));
    double slope = w->domino.slope.hi, square = up(up(slope * slope) * w->share.hi), n = u->n;
    double rL = g->high.rL.hi, Y = c->Y.lo, cube = down(Y * down(Y * Y));
    w->T.hi = PROOF_BOUND(REST_OF_T, up(w->T.hi + up(square * series)), w->T.hi);
    double by_theta = up(up(rL / Y) + up(up(c->X.hi * up(rL * rL)) / cube));
    double Q = up(up(by_theta * rest->shift) + up(g->shape->L.hi / cube));
    double twist = larger(w->twist.hi, -w->twist.lo);
    double first = up(up(2 * up(slope * w->share.hi)) *
                      up(up(twist * series) + up(up(up(slope * Q) * up(p * m)) * up(series * series))));
    double second =
        up(up(up(up(g->shape->q.hi + 1) / g->r.lo) * square) * up(series * up(n + up(e * series))));
    w->T_by_r = span_add(w->T_by_r, (struct span){-up(first + second), first});
}

/*
 * Adds bounds on the remainder of the fuel. The remainder is the sum over i >= n of r^(-q i) (h(theta_i) -
 * h(theta_(i+1))). No term is negative, because h decreases beyond theta_u. Since r^(-q i) <= r^(-q n), the
 * sum is at most
 *
 *     r^(-q n) (h(theta_n) - h(theta_last)).
 */
static void rest_of_fuel(const struct upright *u, struct walk *w, double fall, const struct rest *rest)
{
    w->fuel.hi = PROOF_BOUND(REST_OF_FUEL, up(w->fuel.hi + up(w->power.hi * fall)), w->fuel.hi);
    struct span change = {-up(rest->slides + rest->drops), up(rest->slides / u->growth.weight.lo)};
    w->fuel_by_r = span_add(w->fuel_by_r, change);
}

/* Finds the kinetic energy K from equation (24; c6). If P > 0, then K = P / E with E = r^q (1 + 1/T) - 1. */
static void kinetic_of_train(struct upright *u, const struct walk *w)
{
    const struct growth *g = &u->growth;
    struct span one = span_of(1), T = w->T;
    struct span E = span_sub(span_scale(g->rq, span_add(one, span_over(one, T))), one);
    struct span rq_by_r = span_scale(g->rq, span_over(g->shape->q, g->r));
    struct span E_by_r = span_sub(span_scale(rq_by_r, span_add(one, span_over(one, T))),
                                  span_scale(span_over(g->rq, span_square(T)), w->T_by_r));
    u->fuel = w->fuel;
    u->inertia = T;
    u->kinetic = E.lo > 0 ? span_over(u->fuel, E) : (struct span){-INFINITY, INFINITY};
    u->kinetic_by_r = span_over(span_sub(w->fuel_by_r, span_mul(u->kinetic, E_by_r)), E);
}

/*
 * Finds the kinetic energy K for a train of two dominoes, as in the paper's section "Two dominoes". Domino 1
 * tips over its edge from rest and releases the energy h(theta_u) - h(theta_c) before it hits the head. The
 * unit of this energy is m g h / 2 of domino 1. This energy times f is the kinetic energy of the pair after
 * the hit, in the unit m g h / 2 of the head:
 *
 *     f = r k^2/(1 + k),   k = r^(-(q+1)),
 *     df/dr = k^2/(1 + k) (1 - (q + 1)(2 + k)/(1 + k)).
 */
static void kinetic_of_pair(struct upright *u, struct span hit)
{
    const struct growth *g = &u->growth;
    struct span one = span_of(1), k = g->inertia, sum = span_add(one, k);
    struct span part = span_over(span_square(k), sum), share = span_scale(g->r, part);
    struct span push = span_sub(g->shape->g_top, u->link[1].g);
    struct span order = span_over(span_scale(span_add(g->shape->q, one), span_add(span_of(2), k)), sum);
    u->fuel = push;
    /* If theta_c < theta_u, domino 1 touches the head before it can tip over its edge, so the pair has no
     * fuel (5; b0). */
    if (!(hit.lo > g->shape->v_top.hi))
        u->fuel.lo = -1;
    if (hit.hi < g->shape->v_top.lo)
        u->fuel.hi = -1;
    u->kinetic = span_scale(share, u->fuel);
    u->kinetic_by_r =
        span_sub(span_mul(span_scale(part, span_sub(one, order)), push), span_scale(share, u->link[1].slide));
    u->by_r = u->by_r && hit.lo > g->shape->v_top.hi;
}

/* Replaces the fuel P by the paper's closed form P = 1 - h(theta_last). */
static void paper_fuel(const struct upright *u, struct walk *w)
{
    const struct growth *g = &u->growth;
    struct domino last = chain_last(g);
    w->fuel = span_negate(tilt_height(g->shape, last.v));
    w->fuel_by_r = span_negate(span_mul(tilt_rise(g->shape, last.v), last.shift));
}

static void link_make(struct upright *u, const struct walk *w, int i)
{
    struct span rise = tilt_rise(u->growth.shape, w->domino.v);
    u->link[i] = (struct link){.g = tilt_height(u->growth.shape, w->domino.v),
                               .slide = span_mul(rise, w->domino.shift),
                               .weight = w->power};
    if (i == 0) {
        u->link[i].g = span_of(0);
        u->link[i].slide = span_of(0);
    }
}

bool upright_find(const struct shape *shape, double r_low, double r_high, double rest_most, struct upright *u)
{
    struct contact c;
    struct walk w = {.domino = {.slope = {1, 1}}, .share = {1, 1}, .power = {1, 1}};
    double fall = 0, rest_before = INFINITY, v_before = 0;
    bool finite = true;
    u->growth = growth_make(shape, r_low, r_high);
    const struct growth *g = &u->growth;
    if (!shape->pair && g->high.last <= shape->v_top.lo) {
        /* No domino reaches theta_u. So h increases from domino to domino, and every term of the fuel P is
         * negative. */
        u->n = 0;
        u->exact_end = true;
        u->by_r = false;
        u->fuel = u->kinetic = (struct span){-HUGE_VAL, 0};
        u->inertia = (struct span){0, HUGE_VAL};
        return true;
    }
    u->g_last = tilt_height(shape, span_of(g->high.last)).lo;
    link_make(u, &w, 0);
    for (u->n = 0;; u->n++) {
        int i = u->n;
        c = chain_contact(g, w.domino.v);
        u->exact_end = i > 0 && w.domino.v.lo >= g->leave.hi;
        struct walk next = w;
        next.domino = chain_next(g, &w.domino, &c);
        next.twist = chain_twist(g, &w, &c);
        if (i == 0) { /* for the upright head these numbers are exact, since sin theta = 0 */
            next.domino.slope = span_of(1);
            next.twist = span_of(0);
        }
        finite = finite && c.Y.lo > 0 && isfinite(c.shift.hi) && span_finite(next.twist);
        w = next;
        w.power = span_scale(w.power, g->weight);
        w.share = span_scale(w.share, g->inertia);
        if (i + 1 > LINKS_MOST)
            return false;
        link_make(u, &w, i + 1);
        add_fuel(g, &w, &u->link[i], i);
        if (u->exact_end || (shape->pair && i == 1)) {
            u->n = i + 1;
            break;
        }
        fall = least_0(up(u->link[i + 1].g.hi - u->g_last));
        double rest = up(w.power.hi * fall);
        /*
         * Usually, stop when the tilts hardly grow from domino to domino, since more dominoes do not help
         * then. But if equal dominoes stand close together, their tilts approach the limit slowly, and more
         * dominoes do help. So if the interval of growths is narrow, stop only when rounding hides the
         * increase.
         */
        double grows = r_high > r_low * (1 + 1e-9) ? 1e-3 : 1e-15;
        bool still = w.domino.v.lo < v_before * (1 + grows) && rest > 0.98 * rest_before;
        if (!shape->pair && w.domino.v.lo > shape->v_top.hi &&
            (rest <= rest_most || still || i + 1 == LINKS_MOST)) {
            u->n = i + 1;
            break;
        }
        rest_before = rest;
        v_before = w.domino.v.lo;
        add_inertia(g, &w, i + 1);
    }
    u->by_r = finite;
    u->slide_rest = u->drop_rest = 0;
    if (shape->pair) {
        u->exact_end = true; /* a pair has no other dominoes */
        kinetic_of_pair(u, chain_hit(g));
    } else {
        if (!u->exact_end) {
            c = chain_contact(g, w.domino.v);
            struct rest rest = rest_find(g, &w.domino, &c, w.power.hi, fall, u->n);
            u->slide_rest = rest.slides;
            u->drop_rest = rest.drops;
            rest_of_fuel(u, &w, fall, &rest);
            rest_of_inertia(u, &w, &c, &rest);
        }
        if (shape->paper)
            paper_fuel(u, &w);
        kinetic_of_train(u, &w);
    }
    u->by_r = u->by_r && span_finite(u->kinetic_by_r);
    return true;
}

double upright_hit_above(const struct upright *u)
{
    return up(sqrt(up(2 * chain_hit(&u->growth).hi)));
}

double upright_hit_below(const struct upright *u)
{
    return least_0(down(sqrt(least_0(down(2 * chain_hit(&u->growth).lo)))));
}
