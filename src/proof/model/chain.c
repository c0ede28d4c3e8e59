/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Computes the chain of leaning dominoes of a train, and its energies.
 *
 * A tilt theta is represented by v = 1 - cos theta, which increases with theta. The sine of the tilt is
 * sqrt(v (2 - v)), so no trigonometric function is needed.
 *
 * The follower of a domino with the tilt theta leans on it at the tilt
 *
 *     theta_1(theta, r) = theta + asin X,   X = r (L cos theta - d).
 *
 * This tilt increases with theta up to theta_leave, where the follower detaches. From then on, the follower
 * keeps its tilt. (If theta_inf < theta_leave, no domino tilts beyond theta_inf, so no follower detaches.) So
 * the tilt of the follower is F(theta, r), defined as the maximum of theta_1(t, r) over all t <= theta. It
 * increases with theta and with r (Lemma 1 in domino-model(7)).
 *
 * An interval of tilts and an interval of growths form a box. The lower corner of the box is the smallest
 * tilt with the smallest growth, and the upper corner is the largest tilt with the largest growth. Every
 * chain in a box lies between the chains at these two corners.
 */
#include "proof/model/proof.h"

static const struct span one = {1, 1}, everything = {-HUGE_VAL, HUGE_VAL};

/* ---- One domino ---- */

struct shape shape_make(double s, double d, double q)
{
    struct shape shape = {.s = span_around(s), .d = span_around(d)};
    shape.q = q == floor(q) && q <= 64 ? span_of(q) : span_around(q);
    shape.L = span_add(shape.s, shape.d);
    shape.v_inf = span_over(shape.s, shape.L);
    /* The value of v at theta_u is 1 - cos theta_u = [sqrt(1 + d^2) - 1]/sqrt(1 + d^2). To avoid
     * cancellation, the numerator is computed as d^2/(1 + sqrt(1 + d^2)). */
    struct span square = span_product(shape.d, shape.d), root = span_sqrt(span_add(one, square));
    shape.g_top = span_over(square, span_add(one, root));
    shape.v_top = span_over(shape.g_top, root);
    return shape;
}

/* Returns the sine of a tilt. The computed square root has a relative error below 2^-52. The factors
 * 1 - 2^-51 and 1 + 2^-51 cover this error and the rounding error of the product with the factor. */
SPAN struct span tilt_sine(struct span v)
{
    const double low = sqrt(v.lo * (2 - v.lo)), high = sqrt(v.hi * (2 - v.hi));
    return (struct span){PROOF_BOUND(SINE, low * (1 - 0x1p-51), low), high * (1 + 0x1p-51)};
}

static struct span tilt_cosine(struct span v)
{
    return (struct span){least_0(down(1 - v.hi)), up(1 - v.lo)};
}

/* Returns g = d sin theta - (1 - cos theta), which is h(theta) - 1. It increases up to theta_u and decreases
 * after it. */
static struct span tilt_height(const struct shape *shape, struct span v)
{
    const struct span lo = span_of(v.lo), hi = span_of(v.hi),
                      at_lo = span_sub(span_product(shape->d, tilt_sine(lo)), lo),
                      at_hi = span_sub(span_product(shape->d, tilt_sine(hi)), hi);
    return (struct span){smaller(at_lo.lo, at_hi.lo),
                         v.lo >= shape->v_top.hi ? at_lo.hi
                         : v.hi <= shape->v_top.lo
                             ? at_hi.hi
                             : PROOF_BOUND(TOP_OF_ONE, shape->g_top.hi, larger(at_lo.lo, at_hi.lo))};
}

/* Returns dh/dtheta = d cos theta - sin theta, which decreases on [0, pi/2]. */
static struct span tilt_rise(const struct shape *shape, struct span v)
{
    return span_sub(span_product(shape->d, tilt_cosine(v)), tilt_sine(v));
}

/* ---- A domino and its follower ---- */

/* One domino of a chain, for all tilts of the head and all growths in a box. */
struct domino {
    struct span v;
    struct span slope; /* dtheta_i/dtheta >= 0 */
    struct span shift; /* dtheta_i/dr >= 0, for a head with a fixed tilt */
};

/* The sine X and the cosine Y of the angle theta_1 - theta at one growth. If v increases, X
 * decreases and Y increases. */
struct turn {
    struct span X, Y;
};

SPAN struct turn corner_turn(const struct corner *c, struct span v)
{
    const struct span less = span_product(v, c->rL), X = span_sub(c->rs, less);
    struct turn t = {.X = {least_0(X.lo), least_0(most_1(X.hi))}}; /* X >= 0 up to theta_inf */
    /* Y follows from Y^2 = (1 - X) (1 + X). To avoid cancellation, 1 - X is computed as (1 - r s) + r L v. */
    t.Y = span_sqrt(span_product(span_add(c->short_of, less), span_add(one, t.X)));
    t.Y.hi = most_1(t.Y.hi);
    return t;
}

/* Returns v of the tilt theta_1(theta) at one growth. The formula is a sum of terms that are not negative:
 *
 *     1 - cos(theta + asin X) = X^2/(1 + Y) + Y v + X sin theta. */
SPAN struct span turned(const struct corner *c, struct span v)
{
    const struct turn t = corner_turn(c, v);
    const struct span next =
        span_add(span_add(span_over(span_product(t.X, t.X), span_add(one, t.Y)), span_product(v, t.Y)),
                 span_product(t.X, tilt_sine(v)));
    return (struct span){least_0(next.lo), most_1(next.hi)};
}

static struct corner corner_make(const struct shape *shape, double r)
{
    const struct span of_r = span_of(r), s = shape->s;
    struct corner c = {.rs = span_mul(of_r, s), .rL = span_mul(of_r, shape->L)};
    c.rs.hi = most_1(c.rs.hi); /* all bounds in this file hold only for r s <= 1 */
    /* 1 - r s by fma, which rounds only once */
    c.short_of = (struct span){least_0(down(fma(-r, s.hi, 1))), least_0(up(fma(-r, s.lo, 1)))};
    /* 1 - cos theta_leave = (1 - r s) (1 + r s) / (2 d L r^2) (41; A17) */
    c.leave = span_over(span_mul(c.short_of, span_add(one, c.rs)),
                        span_mul(span_mul(span_add(shape->d, shape->d), shape->L), span_product(of_r, of_r)));
    c.leave.lo = smaller(least_0(c.leave.lo), shape->v_inf.lo);
    c.leave.hi = smaller(c.leave.hi, shape->v_inf.hi);
    c.last = turned(&c, c.leave).hi;
    return c;
}

/* Returns v of the follower, F(theta), at one growth. F is the maximum of theta_1(t) over all t <= theta, so
 * v of theta_1(t) is a lower bound for any such t. */
SPAN struct span corner_follow(const struct corner *c, double v)
{
    const struct span next = turned(c, span_of(smaller(v, c->leave.lo)));
    const double high = v >= c->leave.lo ? c->last : smaller(next.hi, c->last);
    return (struct span){next.lo, PROOF_BOUND(DETACHED, high, turned(c, span_of(v)).hi)};
}

/* Given v of a domino, returns v of its follower. */
static struct span chain_follow(const struct growth *g, struct span v)
{
    const struct corner *const low = PROOF_BOUND(CORNERS, &g->low, &g->high);
    return (struct span){corner_follow(low, v.lo).lo, corner_follow(&g->high, v.hi).hi};
}

/* One contact: from domino i to domino i + 1. */
struct contact {
    struct span X, Y;  /* sine and cosine of theta_(i+1) - theta_i */
    struct span x;     /* sin theta_i */
    struct span slope; /* dF/dtheta */
    struct span shift; /* dF/dr */
    /* true if theta_i is beyond theta_leave in the whole box; the follower then stays at theta_f */
    bool held;
    bool may_hold; /* true if theta_i may be beyond theta_leave in a part of the box */
};

/* Given v of a domino, returns its contact with its follower. */
static struct contact chain_contact(const struct growth *g, struct span v)
{
    struct contact c = {.held = v.lo >= g->leave.hi, .may_hold = v.hi >= g->leave.lo};
    /* Beyond theta_leave, F is constant, so all tilts beyond theta_leave are treated like theta_leave. The
     * derivatives of F have no jump at theta_leave, since dF/dtheta = 0 there. */
    const struct span u = {smaller(v.lo, g->leave.lo), smaller(v.hi, g->leave.hi)};
    const struct turn low = corner_turn(&g->low, span_of(u.hi)), high = corner_turn(&g->high, span_of(u.lo));
    c.X = (struct span){low.X.lo, high.X.hi};
    c.Y = (struct span){high.Y.lo, low.Y.hi};
    c.x = tilt_sine(u);
    /* dF/dtheta = 1 - r L sin theta / Y (14; b10), which is between 0 and 1. */
    c.slope = span_sub(one, span_over(span_mul((struct span){g->low.rL.lo, g->high.rL.hi}, c.x), c.Y));
    c.slope = c.held ? span_of(0) : (struct span){least_0(c.slope.lo), most_1(least_0(c.slope.hi))};
    /* dF/dr = (X/r)/Y, where X/r = L cos theta - d. dF/dr decreases with theta and increases with r. */
    c.shift =
        (struct span){least_0(down(down(c.X.lo / g->r.lo) / c.Y.hi)), up(up(c.X.hi / g->r.hi) / c.Y.lo)};
    return c;
}

/* Returns the follower of `leader`, including derivatives. */
static struct domino chain_next(const struct growth *g, const struct domino *leader,
                                const struct contact *contact)
{
    struct domino next = {.v = chain_follow(g, leader->v),
                          .slope = span_mul(contact->slope, leader->slope),
                          .shift = span_add(span_mul(contact->slope, leader->shift), contact->shift)};
    next.slope.lo = least_0(next.slope.lo);
    next.shift.lo = least_0(next.shift.lo);
    return next;
}

/* Returns the derivative of dF/dtheta = 1 - r L x / Y with respect to r. If r changes, the tilt of the domino
 * changes too, by dtheta_i/dr = shift. */
static struct span slope_by_r(const struct growth *g, const struct domino *domino, const struct contact *c)
{
    const struct dual rL = {{g->low.rL.lo, g->high.rL.hi}, g->shape->L},
                      x = {c->x, span_mul(tilt_cosine(domino->v), domino->shift)}, rLx = dual_mul(rL, x);
    if (c->held)
        return span_of(0);
    /* X = r (L y - d), so dX/dr = X/r - r L x shift; Y^2 = 1 - X^2 */
    const struct span X_by_r = span_sub(span_over(c->X, g->r), span_mul(rLx.value, domino->shift));
    const struct dual Y = {c->Y, span_negate(span_over(span_mul(c->X, X_by_r), c->Y))};
    const struct span by_r = span_negate(dual_over(rLx, Y).by_r);
    return c->may_hold ? (struct span){smaller(by_r.lo, 0), larger(by_r.hi, 0)} : by_r;
}

/* ---- Powers ---- */

/* Returns x^q for x >= 1 and q >= 0. The functions of libm have no guaranteed error bounds, so powers take
 * only products and square roots: if q = n + f with a whole number n and f < 1, x^q = x^n sqrt(x^(2 f)). Each
 * step takes a binary digit from f, and each square root halves the relative error. */
static struct span power_of(double x, double q)
{
    const double rest = q - floor(q); /* exact, like 2 rest */
    struct span power = one, square = span_of(x);
    double n = floor(q);
    while (n > 0) {
        if (fmod(n, 2) > 0)
            power = span_product(power, square);
        square = span_product(square, square);
        n = floor(n / 2);
    }
    return rest > 0 ? span_product(power, span_sqrt(power_of(x, 2 * rest))) : power;
}

static struct growth growth_make(const struct shape *shape, double r_low, double r_high)
{
    struct growth g = {.shape = shape, .r = {r_low, r_high}};
    g.low = corner_make(shape, r_low);
    g.high = corner_make(shape, r_high);
    g.leave = (struct span){g.high.leave.lo, g.low.leave.hi}; /* theta_leave decreases with r */
    g.rq = (struct span){larger(power_of(r_low, shape->q.lo).lo, 1), power_of(r_high, shape->q.hi).hi};
    g.weight = span_over(one, g.rq);
    g.weight.hi = most_1(g.weight.hi);
    g.inertia = span_over(g.weight, g.r);
    g.v_hit = chain_follow(&g, span_of(0));
    g.hit = span_sqrt(span_add(g.v_hit, g.v_hit));
    return g;
}

/* Returns r^(-a i) with its derivative, for an a > 0. */
static struct dual power_by_r(const struct growth *g, struct span power, struct span a, int i)
{
    return (struct dual){power, span_negate(span_mul(span_mul(span_of(i), span_over(a, g->r)), power))};
}

/* ---- Energies ---- */

/*
 * Sums over the infinitely many dominoes of a train are computed only up to domino n - 1. Domino n and all
 * later ones are beyond theta_u, where h decreases, so Lemma 2 in domino-model(7) bounds the remainders:
 * those of the fuel P and of the inertia T are not negative, and that of D is not positive.
 *
 * So the sums without remainders, K_n and D_n, satisfy K_n - D_n <= K - D for every growth and tilt, if
 * P_n >= 0. To show that K - D > 0, it is enough to show that K_n - D_n > 0 for one n, and only these finite
 * sums need derivatives.
 */

/* Finds the kinetic energy K from equation (24; c6). If P > 0, then K = P / E with E = r^q (1 + 1/T) - 1. */
static struct dual kinetic_of_train(const struct growth *g, struct dual fuel, struct dual T)
{
    const struct dual unit = dual_of(one), rq = {g->rq, span_mul(g->rq, span_over(g->shape->q, g->r))},
                      E = dual_sub(dual_mul(rq, dual_add(unit, dual_over(unit, T))), unit);
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
    const struct dual k = power_by_r(g, g->inertia, span_add(g->shape->q, one), 1),
                      share = dual_mul((struct dual){g->r, one},
                                       dual_over(dual_mul(k, k), dual_add(dual_of(one), k)));
    struct dual push = dual_sub(dual_of(g->shape->g_top), u->link[1].g);
    u->kinetic.by_r = dual_mul(share, push).by_r;
    /* If theta_c < theta_u, domino 1 touches the head before it can tip over its edge, so the pair has no
     * fuel (5; b0). */
    if (!(hit.lo > top.hi))
        push.value.lo = -1;
    if (hit.hi < top.lo)
        push.value.hi = -1;
    u->fuel = push.value;
    u->kinetic.value = span_mul(share.value, push.value);
    u->by_r = u->by_r && hit.lo > top.hi;
}

/* The weights r^(-q i) and r^(-(q+1) i) of domino i = n, its slope, and the sums P and T up to it. */
struct sums {
    struct span power, share;
    struct dual slope, fuel, T;
};

/* Finds K, P and T from the sums. For K_n and its derivative, the sums have no remainders. */
static void kinetic_find(struct upright *u, struct sums *sums, const struct domino *last)
{
    const struct growth *g = &u->growth;
    struct span *const P = &sums->fuel.value, *const T = &sums->T.value;
    if (g->shape->paper) { /* the paper's closed form of the fuel, P = 1 - h(theta_last) */
        /* theta_last is the largest tilt that any follower reaches: theta_f = theta_1(theta_leave) if
         * followers detach, and theta_inf otherwise. dF/dtheta is 0 there, so d theta_f/dr = dF/dr. */
        const struct span v = chain_follow(g, one), shift = chain_contact(g, g->leave).shift;
        sums->fuel = (struct dual){span_negate(tilt_height(g->shape, v)),
                                   span_negate(span_mul(tilt_rise(g->shape, v), shift))};
    }
    u->kinetic = kinetic_of_train(g, sums->fuel, sums->T);
    /* For i >= n, Y_i <= 1 and x_i >= x_n, so dF/dtheta = 1 - r L x_i / Y_i <= p = 1 - r L x_n. */
    const double rest = up(sums->power.hi * least_0(up(u->link[u->n].g.value.hi - u->g_last))),
                 slope = sums->slope.value.hi, sine = least_0(tilt_sine(last->v).lo),
                 p = PROOF_BOUND(CONTRACTION, least_0(up(1 - down(g->low.rL.lo * sine))), 0),
                 ratio = up(up(p * p) * g->inertia.hi),
                 T_rest = up(up(up(slope * slope) * sums->share.hi) * up(1 / least_0(down(1 - ratio))));
    if (!g->shape->paper)
        P->hi = PROOF_BOUND(REST_OF_FUEL, up(P->hi + rest), P->hi);
    T->hi = PROOF_BOUND(REST_OF_T, up(T->hi + T_rest), T->hi);
    u->kinetic.value = kinetic_of_train(g, sums->fuel, sums->T).value;
    u->fuel = *P;
    u->inertia = *T;
}

static void link_make(struct upright *u, const struct domino *domino, struct span power, int i)
{
    const struct shape *shape = u->growth.shape;
    u->link[i] = (struct link){.weight = power_by_r(&u->growth, power, shape->q, i)};
    if (i > 0)
        u->link[i].g = (struct dual){tilt_height(shape, domino->v),
                                     span_mul(tilt_rise(shape, domino->v), domino->shift)};
}

bool upright_find(const struct shape *shape, double r_low, double r_high, double rest_most, int n,
                  struct upright *u)
{
    struct sums sums = {.power = {1, 1}, .share = {1, 1}, .slope.value = {1, 1}};
    struct domino domino = {.slope = {1, 1}};
    double rest_before = INFINITY, v_before = 0;
    *u = (struct upright){.growth = growth_make(shape, r_low, r_high), .link = u->link, .by_r = true};
    const struct growth *g = &u->growth;
    if (!shape->pair && g->high.last <= shape->v_top.lo) {
        /* No domino reaches theta_u. So h increases from domino to domino, and every term of the fuel P is
         * negative. */
        u->by_r = false;
        u->fuel = u->kinetic.value = (struct span){-HUGE_VAL, 0};
        u->inertia = (struct span){0, HUGE_VAL};
        return true;
    }
    u->g_last = tilt_height(shape, span_of(g->high.last)).lo;
    link_make(u, &domino, sums.power, 0);
    for (bool done = false; !done;) {
        const int i = u->n++;
        const struct contact c = chain_contact(g, domino.v);
        const bool no_more = shape->pair ? i == 1 : i > 0 && domino.v.lo >= g->leave.hi;
        if (no_more)
            u->g_last = HUGE_VAL;
        struct domino next = chain_next(g, &domino, &c);
        const struct span by_r = slope_by_r(g, &domino, &c);
        if (i == 0) /* for the upright head the slope is exact, since sin theta = 0 */
            next.slope = one;
        else
            sums.slope = dual_mul((struct dual){c.slope, by_r}, sums.slope);
        sums.slope.value = next.slope;
        u->by_r = u->by_r && c.Y.lo > 0 && isfinite(c.shift.hi) && span_finite(sums.slope.by_r);
        domino = next;
        sums.power = span_mul(sums.power, g->weight);
        sums.share = span_mul(sums.share, g->inertia);
        if (u->n > LINKS_MOST)
            return false;
        link_make(u, &domino, sums.power, u->n);
        sums.fuel =
            dual_add(sums.fuel, dual_mul(u->link[i].weight, dual_sub(u->link[i].g, u->link[i + 1].g)));
        const double rest = up(sums.power.hi * least_0(up(u->link[u->n].g.value.hi - u->g_last)));
        /*
         * Usually, stop when the tilts hardly grow from domino to domino, since more dominoes do not help
         * then. But if equal dominoes stand close together, their tilts approach the limit slowly, and more
         * dominoes do help. So if the interval of growths is narrow, stop only when rounding hides the
         * increase.
         */
        const double grows = r_high > r_low * (1 + 1e-9) ? 1e-3 : 1e-15;
        const bool still = domino.v.lo < v_before * (1 + grows) && rest > 0.98 * rest_before;
        done = n > 0 ? u->n == n
                     : no_more || (!shape->pair && domino.v.lo > shape->v_top.hi &&
                                   (rest <= rest_most || still || u->n == LINKS_MOST));
        rest_before = rest;
        v_before = domino.v.lo;
        if (!done) /* adds r^(-(q+1) i) slope^2 */
            sums.T = dual_add(sums.T, dual_mul(power_by_r(g, sums.share, span_add(shape->q, one), u->n),
                                               dual_mul(sums.slope, sums.slope)));
    }
    if (shape->pair)
        kinetic_of_pair(u);
    else
        kinetic_find(u, &sums, &domino);
    u->by_r = u->by_r && span_finite(u->kinetic.by_r);
    return true;
}

struct climb climb_find(const struct upright *u, double low, double high, bool derivatives)
{
    const struct growth *g = &u->growth;
    /* The arguments `low` and `high` are values of sigma = 2 sin(theta/2). It follows that v = sigma^2/2, and
     * that dtheta/dsigma = 1/sqrt(1 - sigma^2/4). */
    struct domino domino = {.v = {least_0(down(low * low / 2)), most_1(up(high * high / 2))},
                            .slope = {1, 1}};
    struct dual height = dual_of(span_of(0));
    struct span by_tilt = {0, 0};
    bool bounded = derivatives && u->by_r;
    if (u->n == 0)
        return (struct climb){everything, everything, everything};
    for (const struct link *link = u->link; link < u->link + u->n; link++) {
        struct dual h = dual_of(tilt_height(g->shape, domino.v));
        if (!derivatives) {
            height.value =
                span_add(height.value, span_mul(link->weight.value, span_sub(h.value, link->g.value)));
            domino.v = chain_follow(g, domino.v);
            continue;
        }
        const struct span rise = tilt_rise(g->shape, domino.v);
        h.by_r = span_mul(rise, domino.shift);
        height = dual_add(height, dual_mul(link->weight, dual_sub(h, link->g)));
        by_tilt = span_add(by_tilt, span_mul(link->weight.value, span_mul(rise, domino.slope)));
        const struct contact contact = chain_contact(g, domino.v);
        bounded = bounded && contact.Y.lo > 0 && isfinite(contact.shift.hi);
        domino = chain_next(g, &domino, &contact);
    }
    const struct span quarter = {down(low * low / 4), up(high * high / 4)};
    by_tilt = span_over(by_tilt, span_sqrt(span_sub(one, quarter)));
    const struct link *last = &u->link[u->n];
    const double rest = up(last->weight.value.hi * least_0(up(last->g.value.hi - u->g_last)));
    height.value.lo = PROOF_BOUND(REST_OF_HEIGHT, down(height.value.lo - rest), height.value.lo);
    return (struct climb){height.value, derivatives && span_finite(by_tilt) ? by_tilt : everything,
                          bounded && span_finite(height.by_r) ? height.by_r : everything};
}
