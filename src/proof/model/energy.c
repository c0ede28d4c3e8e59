/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Computes the train while its head is upright, and the energy D = H(theta) - H(0) that it must climb.
 *
 * Sums over the infinitely many dominoes of a train are computed only up to domino n - 1, and domino n and
 * all later ones are beyond theta_u, where h decreases. The sign of each remainder is therefore known:
 *
 * - The fuel P is a sum of r^(-q i) (h(theta_i) - h(theta_(i+1))). No term is negative beyond theta_u. Since
 *   r^(-q i) <= r^(-q n), the remainder is at most r^(-q n) (h(theta_n) - h(theta_last)).
 * - The inertia T is a sum of squares. For i >= n, Y_i <= 1 and x_i >= x_n, so the slopes decrease at least
 *   by the factor p from domino to domino, where
 *
 *       dF/dtheta = 1 - r L x_i / Y_i <= p = 1 - r L sin theta_n.
 *
 *   The remainder is at most term n, divided by 1 - p^2 r^-(q+1).
 * - In D, domino i is at theta_i0 or beyond, where theta_i0 is its tilt while the head is upright. So h is at
 *   most what it was then, and the remainder is at most 0. For theta <= theta_c, the tilt of domino i is at
 *   most theta_(i+1)0. With these tilts the sum telescopes like the fuel, so the remainder is at least
 *   -r^(-q n) (h(theta_n0) - h(theta_last)).
 *
 * So the sums without remainders, K_n and D_n, satisfy K_n - D_n <= K - D for every growth and tilt, if
 * P_n >= 0. To show that K - D > 0, it is enough to show that K_n - D_n > 0 for one n, and only these finite
 * sums need derivatives.
 */
#include "proof/model/proof.h"

static const struct span everything = {-HUGE_VAL, HUGE_VAL};

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

/* Returns the slope of the follower, dtheta_(i+1)/dtheta, whose value is known, given that of domino i. It is
 * multiplied by dF/dtheta = 1 - r L x / Y. If r changes, the tilt of the domino changes too, by dtheta_i/dr =
 * shift. */
static struct dual slope_next(const struct growth *g, const struct walk *w, const struct contact *c,
                              struct span slope)
{
    const struct domino *domino = &w->domino;
    const struct span y = {least_0(down(1 - domino->v.hi)), up(1 - domino->v.lo)}, shift = domino->shift;
    const struct dual rL = {{g->low.rL.lo, g->high.rL.hi}, g->shape->L}, x = {c->x, span_scale(y, shift)},
                      rLx = dual_scale(rL, x);
    if (c->held)
        return (struct dual){slope, span_of(0)};
    /* X = r (L y - d), so dX/dr = X/r - r L x shift; Y^2 = 1 - X^2 */
    const struct span X_by_r = span_sub(span_over(c->X, g->r), span_scale(rLx.value, shift));
    const struct dual Y = {c->Y, span_negate(span_over(span_scale(c->X, X_by_r), c->Y))},
                      step = {c->slope, span_negate(dual_over(rLx, Y).by_r)};
    const struct span by_r = dual_scale(step, w->slope).by_r;
    return (struct dual){slope, c->may_hold ? span_hull(by_r, span_of(0)) : by_r};
}

/* Finds the kinetic energy K from equation (24; c6). If P > 0, then K = P / E with E = r^q (1 + 1/T) - 1. */
static struct dual kinetic_of_train(const struct growth *g, struct dual fuel, struct dual T)
{
    const struct dual one = dual_of(span_of(1)),
                      rq = {g->rq, span_scale(g->rq, span_over(g->shape->q, g->r))},
                      E = dual_sub(dual_scale(rq, dual_add(one, dual_over(one, T))), one);
    struct dual kinetic = dual_over(fuel, E);
    if (!(E.value.lo > 0))
        kinetic.value = everything;
    return kinetic;
}

/*
 * Finds the kinetic energy K for a train of two dominoes, as in the paper's section "Two dominoes". Domino 1
 * tips over its edge from rest and releases the energy h(theta_u) - h(theta_c) before it hits the head. The
 * unit of this energy is m g h / 2 of domino 1. This energy times f is the kinetic energy of the pair after
 * the hit, in the unit m g h / 2 of the head:
 *
 *     f = r k^2/(1 + k),   k = r^(-(q+1)).
 */
static void kinetic_of_pair(struct upright *u)
{
    const struct growth *g = &u->growth;
    const struct span top = g->shape->v_top, hit = g->v_hit;
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
    u->by_r = hit.lo > top.hi;
}

static void link_make(struct upright *u, const struct walk *w, int i)
{
    const struct shape *shape = u->growth.shape;
    u->link[i] = (struct link){.weight = power_of(&u->growth, w->power, shape->q, i)};
    if (i > 0)
        u->link[i].g = (struct dual){tilt_height(shape, w->domino.v),
                                     span_mul(tilt_rise(shape, w->domino.v), w->domino.shift)};
}

bool upright_find(const struct shape *shape, double r_low, double r_high, double rest_most, int n,
                  struct upright *u)
{
    struct walk w = {.domino = {.slope = {1, 1}}, .slope.value = {1, 1}, .share = {1, 1}, .power = {1, 1}};
    double fall = 0, rest_before = INFINITY, v_before = 0;
    bool finite = true, done = false;
    *u = (struct upright){.growth = growth_make(shape, r_low, r_high), .link = u->link};
    const struct growth *g = &u->growth;
    if (!shape->pair && g->high.last <= shape->v_top.lo) {
        /* No domino reaches theta_u. So h increases from domino to domino, and every term of the fuel P is
         * negative. */
        u->exact_end = true;
        u->fuel = u->kinetic.value = (struct span){-HUGE_VAL, 0};
        u->inertia = (struct span){0, HUGE_VAL};
        return true;
    }
    u->g_last = tilt_height(shape, span_of(g->high.last)).lo;
    link_make(u, &w, 0);
    while (!done) {
        const int i = u->n++;
        const struct contact c = chain_contact(g, w.domino.v);
        u->exact_end = shape->pair ? i == 1 : i > 0 && w.domino.v.lo >= g->leave.hi;
        struct walk next = w;
        next.domino = chain_next(g, &w.domino, &c);
        if (i == 0) /* for the upright head the slope is exact, since sin theta = 0 */
            next.domino.slope = span_of(1);
        next.slope = i == 0 ? dual_of(span_of(1)) : slope_next(g, &w, &c, next.domino.slope);
        finite = finite && c.Y.lo > 0 && isfinite(c.shift.hi) && span_finite(next.slope.by_r);
        w = next;
        w.power = span_scale(w.power, g->weight);
        w.share = span_scale(w.share, g->inertia);
        if (u->n > LINKS_MOST)
            return false;
        link_make(u, &w, u->n);
        w.fuel = dual_add(w.fuel, dual_scale(u->link[i].weight, dual_sub(u->link[i].g, u->link[i + 1].g)));
        fall = least_0(up(u->link[u->n].g.value.hi - u->g_last));
        const double rest = up(w.power.hi * fall);
        /*
         * Usually, stop when the tilts hardly grow from domino to domino, since more dominoes do not help
         * then. But if equal dominoes stand close together, their tilts approach the limit slowly, and more
         * dominoes do help. So if the interval of growths is narrow, stop only when rounding hides the
         * increase.
         */
        const double grows = r_high > r_low * (1 + 1e-9) ? 1e-3 : 1e-15;
        const bool still = w.domino.v.lo < v_before * (1 + grows) && rest > 0.98 * rest_before;
        done = n > 0 ? u->n == n
                     : u->exact_end || (!shape->pair && w.domino.v.lo > shape->v_top.hi &&
                                        (rest <= rest_most || still || u->n == LINKS_MOST));
        rest_before = rest;
        v_before = w.domino.v.lo;
        if (!done) /* adds r^(-(q+1) i) slope^2 */
            w.T = dual_add(w.T, dual_scale(power_of(g, w.share, span_add(shape->q, span_of(1)), u->n),
                                           dual_scale(w.slope, w.slope)));
    }
    if (shape->pair)
        kinetic_of_pair(u);
    else {
        if (shape->paper) { /* the paper's closed form of the fuel, P = 1 - h(theta_last) */
            const struct domino last = chain_last(g);
            w.fuel = (struct dual){span_negate(tilt_height(shape, last.v)),
                                   span_negate(span_mul(tilt_rise(shape, last.v), last.shift))};
        }
        u->kinetic = kinetic_of_train(g, w.fuel, w.T);
        if (!u->exact_end) {
            const double slope = w.slope.value.hi,
                         p = PROOF_BOUND(
                             CONTRACTION,
                             least_0(up(1 - down(g->low.rL.lo * least_0(tilt_sine(w.domino.v).lo)))), 0),
                         ratio = up(up(p * p) * g->inertia.hi),
                         T_rest = up(up(up(slope * slope) * w.share.hi) * up(1 / least_0(down(1 - ratio))));
            struct span *P = &w.fuel.value, *T = &w.T.value;
            if (!shape->paper)
                P->hi = PROOF_BOUND(REST_OF_FUEL, up(P->hi + up(w.power.hi * fall)), P->hi);
            T->hi = PROOF_BOUND(REST_OF_T, up(T->hi + T_rest), T->hi);
            u->kinetic.value = kinetic_of_train(g, w.fuel, w.T).value;
        }
        u->fuel = w.fuel.value;
        u->inertia = w.T.value;
    }
    u->by_r = finite && span_finite(u->kinetic.by_r) && (!shape->pair || u->by_r);
    return true;
}

struct climb climb_find(const struct upright *u, double low, double high, bool derivatives)
{
    const struct growth *g = &u->growth;
    const struct shape *shape = g->shape;
    /* The arguments `low` and `high` are values of sigma = 2 sin(theta/2). It follows that v = sigma^2/2, and
     * that dtheta/dsigma = 1/sqrt(1 - sigma^2/4). */
    struct domino domino = {.v = {least_0(down(low * low / 2)), most_1(up(high * high / 2))},
                            .slope = {1, 1}};
    struct dual height = {{0, 0}, {0, 0}};
    struct span by_tilt = {0, 0};
    bool bounded = derivatives && u->by_r;
    if (u->n == 0)
        return (struct climb){everything, everything, everything};
    for (int i = 0; i < u->n; i++) {
        const struct link *link = &u->link[i];
        struct dual h = dual_of(tilt_height(shape, domino.v));
        if (!derivatives) {
            height.value =
                span_add(height.value, span_scale(link->weight.value, span_sub(h.value, link->g.value)));
            domino.v = chain_follow(g, domino.v);
            continue;
        }
        const struct span rise = tilt_rise(shape, domino.v);
        h.by_r = span_mul(rise, domino.shift);
        height = dual_add(height, dual_scale(link->weight, dual_sub(h, link->g)));
        by_tilt = span_add(by_tilt, span_scale(link->weight.value, span_mul(rise, domino.slope)));
        const struct contact contact = chain_contact(g, domino.v);
        bounded = bounded && contact.Y.lo > 0 && isfinite(contact.shift.hi);
        domino = chain_next(g, &domino, &contact);
    }
    const struct span quarter = {down(low * low / 4), up(high * high / 4)};
    by_tilt = span_over(by_tilt, span_sqrt(span_sub(span_of(1), quarter)));
    if (!u->exact_end) {
        const struct link *last = &u->link[u->n];
        const double rest = up(last->weight.value.hi * least_0(up(last->g.value.hi - u->g_last)));
        height.value.lo = PROOF_BOUND(REST_OF_HEIGHT, down(height.value.lo - rest), height.value.lo);
    }
    return (struct climb){height.value, derivatives && span_finite(by_tilt) ? by_tilt : everything,
                          bounded && span_finite(height.by_r) ? height.by_r : everything};
}
