/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Computes the train while its head is upright: its fuel, its inertia, and its initial kinetic energy. */
#include "proof/model/energy.h"
#include "proof/model/rest.h"

/* Domino i of the chain, and the sums over all dominoes before domino i. */
struct walk {
    struct domino domino;
    struct dual slope;        /* domino.slope */
    struct span share, power; /* r^(-(q+1) i), r^(-q i) */
    struct dual fuel, T;
};

/* Returns r^(-a i) with its derivative, for an a > 0. */
static struct dual power_of(const struct growth *g, struct span power, struct span a, int i)
{
    return (struct dual){power, span_negate(span_scale(span_scale(span_of(i), span_over(a, g->r)), power))};
}

/* Returns dF/dtheta = 1 - r L x / Y with its total derivative with respect to r: if r changes, the tilt of
 * the domino changes too, by dtheta_i/dr = shift. */
static struct dual step_of(const struct growth *g, const struct contact *c, const struct domino *domino)
{
    const struct span y = {least_0(down(1 - domino->v.hi)), up(1 - domino->v.lo)}, shift = domino->shift;
    const struct dual rL = {{g->low.rL.lo, g->high.rL.hi}, g->shape->L}, x = {c->x, span_scale(y, shift)},
                      rLx = dual_scale(rL, x);
    /* X = r (L y - d), so dX/dr = X/r - r L x shift; Y^2 = 1 - X^2 */
    const struct span X_by_r = span_sub(span_over(c->X, g->r), span_scale(rLx.value, shift));
    const struct dual Y = {c->Y, span_negate(span_over(span_scale(c->X, X_by_r), c->Y))};
    return (struct dual){c->slope, span_negate(dual_over(rLx, Y).by_r)};
}

/* Returns the slope of the follower, dtheta_(i+1)/dtheta, given that of domino i. */
static struct dual slope_next(const struct growth *g, const struct walk *w, const struct contact *c,
                              struct span slope)
{
    if (c->held)
        return (struct dual){slope, span_of(0)};
    const struct span by_r = dual_scale(step_of(g, c, &w->domino), w->slope).by_r;
    return (struct dual){slope, c->may_hold ? span_hull(by_r, span_of(0)) : by_r};
}

/* Adds the term of domino i, r^(-(q+1) i) slope^2, to T. */
static void add_inertia(const struct growth *g, struct walk *w, int i)
{
    const struct dual share = power_of(g, w->share, span_add(g->shape->q, span_of(1)), i);
    w->T = dual_add(w->T, dual_scale(share, dual_scale(w->slope, w->slope)));
}

/* Adds the term of domino i, r^(-q i) (h(theta_i) - h(theta_(i+1))), to P. */
static void add_fuel(struct walk *w, const struct link *link)
{
    w->fuel = dual_add(w->fuel, dual_scale(link[0].weight, dual_sub(link[0].g, link[1].g)));
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
    double slope = w->slope.value.hi, square = up(up(slope * slope) * w->share.hi), n = u->n;
    double rL = g->high.rL.hi, Y = c->Y.lo, cube = down(Y * down(Y * Y));
    w->T.value.hi = PROOF_BOUND(REST_OF_T, up(w->T.value.hi + up(square * series)), w->T.value.hi);
    double by_theta = up(up(rL / Y) + up(up(c->X.hi * up(rL * rL)) / cube));
    double Q = up(up(by_theta * rest->shift) + up(g->shape->L.hi / cube));
    double twist = larger(w->slope.by_r.hi, -w->slope.by_r.lo);
    double first = up(up(2 * up(slope * w->share.hi)) *
                      up(up(twist * series) + up(up(up(slope * Q) * up(p * m)) * up(series * series))));
    double second =
        up(up(up(up(g->shape->q.hi + 1) / g->r.lo) * square) * up(series * up(n + up(e * series))));
    w->T.by_r = span_add(w->T.by_r, (struct span){-up(first + second), first});
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
    struct span *P = &w->fuel.value;
    P->hi = PROOF_BOUND(REST_OF_FUEL, up(P->hi + up(w->power.hi * fall)), P->hi);
    struct span change = {-up(rest->slides + rest->drops), up(rest->slides / u->growth.weight.lo)};
    w->fuel.by_r = span_add(w->fuel.by_r, change);
}

/* Finds the kinetic energy K from equation (24; c6). If P > 0, then K = P / E with E = r^q (1 + 1/T) - 1. */
static void kinetic_of_train(struct upright *u, const struct walk *w)
{
    const struct growth *g = &u->growth;
    const struct dual one = dual_of(span_of(1)),
                      rq = {g->rq, span_scale(g->rq, span_over(g->shape->q, g->r))},
                      E = dual_sub(dual_scale(rq, dual_add(one, dual_over(one, w->T))), one);
    u->fuel = w->fuel.value;
    u->inertia = w->T.value;
    u->kinetic = dual_over(w->fuel, E);
    if (!(E.value.lo > 0))
        u->kinetic.value = (struct span){-INFINITY, INFINITY};
}

/*
 * Finds the kinetic energy K for a train of two dominoes, as in the paper's section "Two dominoes". Domino 1
 * tips over its edge from rest and releases the energy h(theta_u) - h(theta_c) before it hits the head. The
 * unit of this energy is m g h / 2 of domino 1. This energy times f is the kinetic energy of the pair after
 * the hit, in the unit m g h / 2 of the head:
 *
 *     f = r k^2/(1 + k),   k = r^(-(q+1)).
 */
static void kinetic_of_pair(struct upright *u, struct span hit)
{
    const struct growth *g = &u->growth;
    const struct span top = g->shape->v_top;
    const struct dual one = dual_of(span_of(1)),
                      k = power_of(g, g->inertia, span_add(g->shape->q, span_of(1)), 1),
                      share = dual_scale((struct dual){g->r, span_of(1)},
                                         dual_over(dual_scale(k, k), dual_add(one, k)));
    struct dual push = dual_sub(dual_of(g->shape->g_top), u->link[1].g);
    u->kinetic.by_r = dual_scale(share, push).by_r;
    /* If theta_c < theta_u, domino 1 touches the head before it can tip over its edge, so the pair has no
     * fuel (5; b0). */
    if (!(hit.lo > top.hi))
        push.value.lo = -1;
    if (hit.hi < top.lo)
        push.value.hi = -1;
    u->fuel = push.value;
    u->kinetic.value = span_scale(share.value, push.value);
    u->by_r = u->by_r && hit.lo > top.hi;
}

/* Replaces the fuel P by the paper's closed form P = 1 - h(theta_last). */
static void paper_fuel(const struct upright *u, struct walk *w)
{
    const struct growth *g = &u->growth;
    struct domino last = chain_last(g);
    w->fuel = (struct dual){span_negate(tilt_height(g->shape, last.v)),
                            span_negate(span_mul(tilt_rise(g->shape, last.v), last.shift))};
}

static void link_make(struct upright *u, const struct walk *w, int i)
{
    const struct shape *shape = u->growth.shape;
    u->link[i] = (struct link){.weight = power_of(&u->growth, w->power, shape->q, i)};
    if (i > 0)
        u->link[i].g = (struct dual){tilt_height(shape, w->domino.v),
                                     span_mul(tilt_rise(shape, w->domino.v), w->domino.shift)};
}

bool upright_find(const struct shape *shape, double r_low, double r_high, double rest_most, struct upright *u)
{
    struct contact c;
    struct walk w = {.domino = {.slope = {1, 1}}, .slope.value = {1, 1}, .share = {1, 1}, .power = {1, 1}};
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
        u->fuel = u->kinetic.value = (struct span){-HUGE_VAL, 0};
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
        if (i == 0) /* for the upright head the slope is exact, since sin theta = 0 */
            next.domino.slope = span_of(1);
        next.slope = i == 0 ? dual_of(span_of(1)) : slope_next(g, &w, &c, next.domino.slope);
        finite = finite && c.Y.lo > 0 && isfinite(c.shift.hi) && span_finite(next.slope.by_r);
        w = next;
        w.power = span_scale(w.power, g->weight);
        w.share = span_scale(w.share, g->inertia);
        if (i + 1 > LINKS_MOST)
            return false;
        link_make(u, &w, i + 1);
        add_fuel(&w, &u->link[i]);
        if (u->exact_end || (shape->pair && i == 1)) {
            u->n = i + 1;
            break;
        }
        fall = least_0(up(u->link[i + 1].g.value.hi - u->g_last));
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
    u->by_r = u->by_r && span_finite(u->kinetic.by_r);
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
