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

SPAN struct span tilt_cosine(struct span v)
{
    return (struct span){least_0(down(1 - v.hi)), up(1 - v.lo)};
}

/* Returns g = d sin theta - (1 - cos theta), which is h(theta) - 1. It increases up to theta_u and decreases
 * after it. */
SPAN struct span tilt_height(const struct shape *shape, struct span v)
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
SPAN struct span tilt_rise(const struct shape *shape, struct span v)
{
    return span_sub(span_product(shape->d, tilt_cosine(v)), tilt_sine(v));
}

/* ---- A domino and its follower ---- */

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
SPAN struct span chain_follow(const struct upright *t, struct span v)
{
    const struct corner *const low = PROOF_BOUND(CORNERS, &t->low, &t->high);
    return (struct span){corner_follow(low, v.lo).lo, corner_follow(&t->high, v.hi).hi};
}

/* One domino of a chain, for all tilts of the head and all growths in a box. */
struct domino {
    struct span v;
    struct span slope; /* dtheta_i/dtheta >= 0 */
    struct span shift; /* dtheta_i/dr >= 0, for a head with a fixed tilt */
};

/* The derivatives of the tilt F of a domino's follower. */
struct contact {
    struct dual slope; /* dF/dtheta, and its derivative with respect to r along the chain */
    struct span shift; /* dF/dr */
};

/*
 * Returns the contact of a domino with its follower, with the derivative of dF/dtheta if `second` is true.
 * With the sine X and the cosine Y of the angle between the two, and the sine x of the leader's tilt,
 *
 *     dF/dtheta = 1 - r L x/Y (14; b10), which is between 0 and 1;     dF/dr = (X/r)/Y.
 *
 * Beyond theta_leave, F is constant, so all tilts beyond theta_leave are treated like theta_leave. The
 * derivatives of F have no jump at theta_leave, since dF/dtheta = 0 there.
 */
SPAN struct contact contact_find(const struct upright *t, const struct domino *leader, bool second)
{
    /* the leader is beyond theta_leave in the whole box, or in a part of it */
    const bool held = leader->v.lo >= t->leave.hi, may_hold = leader->v.hi >= t->leave.lo;
    const struct span u = {smaller(leader->v.lo, t->leave.lo), smaller(leader->v.hi, t->leave.hi)};
    const struct turn low = corner_turn(&t->low, span_of(u.hi)), high = corner_turn(&t->high, span_of(u.lo));
    struct dual X = {.value = {low.X.lo, high.X.hi}}, Y = {.value = {high.Y.lo, low.Y.hi}},
                x = {.value = tilt_sine(u)}, rL = {{t->low.rL.lo, t->high.rL.hi}, t->shape->L};
    struct dual slope = {.value = span_sub(one, span_over(span_mul(rL.value, x.value), Y.value))};
    slope.value = u.hi == 0 ? one : (struct span){least_0(slope.value.lo), most_1(least_0(slope.value.hi))};
    if (second) { /* the tilt of the leader changes along with r; X = r (L cos theta - d), Y^2 = 1 - X^2 */
        x.by_r = span_mul(tilt_cosine(leader->v), leader->shift);
        const struct dual rLx = dual_mul(rL, x);
        X.by_r = span_sub(span_over(X.value, t->r), span_mul(rLx.value, leader->shift));
        Y.by_r = span_negate(span_over(span_mul(X.value, X.by_r), Y.value));
        slope.by_r = span_negate(dual_over(rLx, Y).by_r);
    }
    if (may_hold)
        slope.by_r = (struct span){smaller(slope.by_r.lo, 0), larger(slope.by_r.hi, 0)};
    /* X/r depends on the tilt alone. dF/dr decreases with theta and increases with r. */
    return (struct contact){
        held ? dual_of(span_of(0)) : slope,
        {least_0(down(down(X.value.lo / t->r.lo) / Y.value.hi)), up(up(X.value.hi / t->r.hi) / Y.value.lo)}};
}

/* Returns the follower of `leader`. */
SPAN struct domino chain_next(const struct upright *t, const struct domino *leader,
                              const struct contact *contact)
{
    struct domino next = {.v = chain_follow(t, leader->v),
                          .slope = span_mul(contact->slope.value, leader->slope),
                          .shift = span_add(span_mul(contact->slope.value, leader->shift), contact->shift)};
    next.slope.lo = least_0(next.slope.lo);
    next.shift.lo = least_0(next.shift.lo);
    return next;
}

/* Returns h - 1 of a domino. */
SPAN struct dual energy_of(const struct shape *shape, const struct domino *domino)
{
    return (struct dual){tilt_height(shape, domino->v), span_mul(tilt_rise(shape, domino->v), domino->shift)};
}

/* ---- The train with an upright head ---- */

/* Returns x^q for x >= 1 and q >= 0. The functions of libm have no guaranteed error bounds, so powers take
 * only products and square roots: if q = n + f with a whole number n and f < 1, x^q = x^n sqrt(x^(2 f)). Each
 * step takes a binary digit from f, and each square root halves the relative error. */
static struct span power_of(double x, double q)
{
    const double whole = floor(q);
    if (q > whole) { /* q - whole is exact, like 2 (q - whole) */
        const struct span root = span_sqrt(power_of(x, 2 * (q - whole)));
        return whole > 0 ? span_product(power_of(x, whole), root) : root;
    }
    if (q <= 1)
        return q > 0 ? span_of(x) : one;
    if (fmod(q, 2) > 0)
        return span_product(span_of(x), power_of(x, q - 1));
    const struct span half = power_of(x, q / 2);
    return span_product(half, half);
}

static struct upright growth_make(const struct shape *shape, double r_low, double r_high)
{
    struct upright t = {.shape = shape, .r = {r_low, r_high}};
    t.low = corner_make(shape, r_low);
    t.high = corner_make(shape, r_high);
    t.leave = (struct span){t.high.leave.lo, t.low.leave.hi}; /* theta_leave decreases with r */
    t.rq.value = (struct span){larger(power_of(r_low, shape->q.lo).lo, 1), power_of(r_high, shape->q.hi).hi};
    t.weight.value = span_over(one, t.rq.value);
    t.weight.value.hi = most_1(t.weight.value.hi);
    const struct span rate = span_over(shape->q, t.r); /* dr^q/dr = (q/r) r^q */
    t.rq.by_r = span_mul(rate, t.rq.value);
    t.weight.by_r = span_negate(span_mul(rate, t.weight.value));
    t.inertia = dual_over(t.weight, (struct dual){t.r, one});
    t.v_hit = chain_follow(&t, span_of(0));
    t.hit = span_sqrt(span_add(t.v_hit, t.v_hit));
    return t;
}

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
static struct dual kinetic_of_train(const struct upright *t, struct dual fuel, struct dual T)
{
    const struct dual unit = dual_of(one),
                      E = dual_sub(dual_mul(t->rq, dual_add(unit, dual_over(unit, T))), unit);
    return E.value.lo > 0 ? dual_over(fuel, E) : (struct dual){everything, everything};
}

/* Finds P, T and K. The arguments are the sums P_n, T_n, term n of T, and v of domino n while the head is
 * upright. The paper's closed form of the fuel, P = 1 - h(theta_last), has no remainder. */
static void energies_of_train(struct upright *t, struct dual fuel, struct dual T, double term, struct span v)
{
    t->kinetic = kinetic_of_train(t, fuel, T);
    /* For i >= n, Y_i <= 1 and x_i >= x_n, so dF/dtheta = 1 - r L x_i / Y_i <= p = 1 - r L x_n, and from
     * term n on, each term of T is at most p^2 r^-(q+1) times the term before. */
    const double sine = least_0(tilt_sine(v).lo),
                 p = PROOF_BOUND(CONTRACTION, least_0(up(1 - down(t->low.rL.lo * sine))), 0),
                 ratio = up(up(p * p) * t->inertia.value.hi), T_rest = up(term / least_0(down(1 - ratio)));
    if (!t->shape->paper)
        fuel.value.hi = PROOF_BOUND(REST_OF_FUEL, up(fuel.value.hi + t->rest), fuel.value.hi);
    T.value.hi = PROOF_BOUND(REST_OF_T, up(T.value.hi + T_rest), T.value.hi);
    t->kinetic.value = kinetic_of_train(t, fuel, T).value;
    t->fuel = fuel.value;
    t->T = T.value;
}

/*
 * Finds the fuel and the kinetic energy K for a train of two dominoes, as in the paper's section "Two
 * dominoes". Domino 1 tips over its edge from rest and releases the energy h(theta_u) - h(theta_c) before it
 * hits the head. The unit of this energy is m g h / 2 of domino 1. This energy times f is the kinetic energy
 * of the pair after the hit, in the unit m g h / 2 of the head:
 *
 *     f = r k^2/(1 + k),   k = r^(-(q+1)).
 */
static void energies_of_pair(struct upright *t)
{
    const struct span top = t->shape->v_top, hit = t->v_hit;
    const struct dual k = t->inertia, f = dual_mul((struct dual){t->r, one},
                                                   dual_over(dual_mul(k, k), dual_add(dual_of(one), k)));
    struct dual fuel = dual_sub(dual_of(t->shape->g_top), t->link[1].g);
    /* If theta_c < theta_u, domino 1 touches the head before it can tip over its edge, so the pair has no
     * fuel (5; b0). */
    if (!(hit.lo > top.hi))
        fuel = (struct dual){{-1, fuel.value.hi}, everything};
    if (hit.hi < top.lo)
        fuel.value.hi = -1;
    t->fuel = fuel.value;
    t->kinetic = dual_mul(f, fuel);
}

bool upright_find(const struct shape *shape, double r_low, double r_high, double rest_most, int n,
                  struct upright *t)
{
    struct link *const link = t->link;
    struct domino domino = {.slope = one}, last = {.v = one};
    struct contact contact;
    struct dual fuel = dual_of(span_of(0)), T = fuel, slope = dual_of(one), inertia = slope, term = T;
    double rest_before, v_before;
    bool no_more, enough;
    *t = growth_make(shape, r_low, r_high);
    t->link = link;
    t->rest = INFINITY;
    /* F(pi/2) is theta_last, the largest tilt that any follower reaches: theta_f if followers detach, and
     * theta_inf otherwise. */
    contact = contact_find(t, &last, false);
    last = chain_next(t, &last, &contact);
    const struct dual g_last = energy_of(shape, &last);
    if (!shape->pair && last.v.hi <= shape->v_top.lo) {
        /* No domino reaches theta_u. So h increases from domino to domino, and every term of the fuel P is
         * negative. */
        t->fuel = (struct span){-HUGE_VAL, 0};
        t->T = (struct span){0, HUGE_VAL};
        t->kinetic = (struct dual){t->fuel, everything};
        return true;
    }
    link[0] = (struct link){.weight = dual_of(one)};
    do {
        no_more = shape->pair ? t->n == 1 : t->n > 0 && domino.v.lo >= t->leave.hi;
        rest_before = t->rest;
        v_before = domino.v.lo;
        contact = contact_find(t, &domino, true);
        domino = chain_next(t, &domino, &contact);
        slope = dual_mul(contact.slope, slope);
        slope.value = domino.slope;
        const int i = ++t->n;
        if (i > LINKS_MOST)
            return false;
        link[i] = (struct link){energy_of(shape, &domino), dual_mul(link[i - 1].weight, t->weight)};
        fuel = dual_add(fuel, dual_mul(link[i - 1].weight, dual_sub(link[i - 1].g, link[i].g)));
        T = dual_add(T, term);
        inertia = dual_mul(inertia, t->inertia);
        term = dual_mul(inertia, dual_mul(slope, slope));
        /* Dominoes that have detached do not move. */
        t->rest =
            no_more ? 0 : up(link[i].weight.value.hi * least_0(up(link[i].g.value.hi - g_last.value.lo)));
        /*
         * Usually, stop when the tilts hardly grow from domino to domino, since more dominoes do not help
         * then. But if equal dominoes stand close together, their tilts approach the limit slowly, and more
         * dominoes do help. So if the interval of growths is narrow, stop only when rounding hides the
         * increase.
         */
        const double grows = r_high > r_low * (1 + 1e-9) ? 1e-3 : 1e-15;
        enough = t->rest <= rest_most || i == LINKS_MOST ||
                 (domino.v.lo < v_before * (1 + grows) && t->rest > 0.98 * rest_before);
    } while (n > 0 ? t->n < n : !no_more && (shape->pair || !(enough && domino.v.lo > shape->v_top.hi)));
    if (shape->pair)
        energies_of_pair(t);
    else
        energies_of_train(t, shape->paper ? dual_sub(dual_of(span_of(0)), g_last) : fuel, T, term.value.hi,
                          domino.v);
    return true;
}

/* ---- The climb ---- */

struct climb climb_find(const struct upright *t, double low, double high, bool derivatives)
{
    /* The arguments `low` and `high` are values of sigma = 2 sin(theta/2). It follows that v = sigma^2/2, and
     * that dtheta/dsigma = 1/sqrt(1 - sigma^2/4). */
    struct domino domino = {.v = {least_0(down(low * low / 2)), most_1(up(high * high / 2))}, .slope = one};
    struct contact contact = {{everything, everything}, everything};
    struct climb climb = {.height = dual_of(span_of(0))};
    if (t->n == 0)
        return (struct climb){{everything, everything}, everything};
    for (const struct link *link = t->link; link < t->link + t->n; link++) {
        const struct span rise = span_mul(tilt_rise(t->shape, domino.v), domino.slope);
        climb.height =
            dual_add(climb.height, dual_mul(link->weight, dual_sub(energy_of(t->shape, &domino), link->g)));
        climb.by_tilt = span_add(climb.by_tilt, span_mul(link->weight.value, rise));
        if (derivatives)
            contact = contact_find(t, &domino, false);
        domino = chain_next(t, &domino, &contact);
    }
    const struct span quarter = {down(low * low / 4), up(high * high / 4)};
    climb.by_tilt = span_over(climb.by_tilt, span_sqrt(span_sub(one, quarter)));
    climb.height.value.lo =
        PROOF_BOUND(REST_OF_HEIGHT, down(climb.height.value.lo - t->rest), climb.height.value.lo);
    return climb;
}
