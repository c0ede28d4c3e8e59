/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "proof/model/proof.h"

struct shape shape_make(double s, double d, double q)
{
    struct shape shape = {.s = span_around(s), .d = span_around(d)};
    shape.q = q == floor(q) && q <= 64 ? span_of(q) : span_around(q);
    shape.L = span_add(shape.s, shape.d);
    shape.v_inf = span_over(shape.s, shape.L);
    /* The value of v at theta_u is 1 - cos theta_u = [sqrt(1 + d^2) - 1]/sqrt(1 + d^2). To avoid
     * cancellation, the numerator is computed as d^2/(1 + sqrt(1 + d^2)). */
    struct span square = span_square(shape.d), root = span_sqrt(span_add(span_of(1), square));
    shape.g_top = span_over(square, span_add(span_of(1), root));
    shape.v_top = span_over(shape.g_top, root);
    return shape;
}

/* sine_below(v) and sine_above(v) return a lower and an upper bound on the sine of a tilt. The computed
 * square root has a relative error below 2^-52. The factors 1 - 2^-51 and 1 + 2^-51 cover this error and the
 * rounding error of the product with the factor. */
static double sine_below(double v)
{
    return PROOF_BOUND(SINE, sqrt(v * (2 - v)) * (1 - 0x1p-51), sqrt(v * (2 - v)));
}

static double sine_above(double v)
{
    return sqrt(v * (2 - v)) * (1 + 0x1p-51);
}

struct span tilt_sine(struct span v)
{
    return (struct span){sine_below(v.lo), sine_above(v.hi)};
}

struct span tilt_height(const struct shape *shape, struct span v)
{
    /* g increases up to theta_u and decreases after it. */
    struct span g;
    double at_lo = down(down(shape->d.lo * sine_below(v.lo)) - v.lo),
           at_hi = down(down(shape->d.lo * sine_below(v.hi)) - v.hi);
    g.lo = smaller(at_lo, at_hi);
    if (v.lo >= shape->v_top.hi)
        g.hi = up(up(shape->d.hi * sine_above(v.lo)) - v.lo);
    else if (v.hi <= shape->v_top.lo)
        g.hi = up(up(shape->d.hi * sine_above(v.hi)) - v.hi);
    else
        g.hi = PROOF_BOUND(TOP_OF_ONE, shape->g_top.hi, larger(at_lo, at_hi));
    return g;
}

struct span tilt_rise(const struct shape *shape, struct span v)
{
    /* dh/dtheta = d cos theta - sin theta, which decreases on [0, pi/2]. */
    return (struct span){down(down(shape->d.lo * least_0(down(1 - v.hi))) - sine_above(v.hi)),
                         up(up(shape->d.hi * up(1 - v.lo)) - sine_below(v.lo))};
}

/* The sine X and the cosine Y of the angle theta_1 - theta, at one tilt and one growth. If v increases, X
 * decreases and Y increases. */
struct turn {
    struct span X, Y;
};

static struct turn corner_turn(const struct corner *c, double v)
{
    struct turn t;
    double less = down(c->rL.lo * v), more = up(c->rL.hi * v);
    t.X.lo = least_0(down(c->rs.lo - more)); /* X >= 0 up to theta_inf */
    t.X.hi = most_1(up(c->rs.hi - less));
    if (!(t.X.hi >= 0))
        t.X.hi = 0;
    /* Y follows from Y^2 = (1 - X) (1 + X). To avoid cancellation, 1 - X is computed as (1 - r s) + r L v. */
    t.Y.lo = least_0(down(sqrt(least_0(down(down(c->short_of.lo + less) * down(1 + t.X.lo))))));
    t.Y.hi = most_1(up(sqrt(up(up(c->short_of.hi + more) * up(1 + t.X.hi)))));
    return t;
}

/*
 * turned_below and turned_above return a lower and an upper bound on v of the follower. The formula is a sum
 * of terms that are not negative:
 *
 *     1 - cos(theta + asin X) = X^2/(1 + Y) + Y v + X sin theta.
 */
static double turned_below(struct turn t, double v)
{
    double square = down(down(t.X.lo * t.X.lo) / up(1 + t.Y.hi));
    return least_0(down(down(square + down(t.Y.lo * v)) + down(t.X.lo * sine_below(v))));
}

static double turned_above(struct turn t, double v)
{
    double square = up(up(t.X.hi * t.X.hi) / down(1 + t.Y.lo));
    return most_1(up(up(square + up(t.Y.hi * v)) + up(t.X.hi * sine_above(v))));
}

/* Returns a lower bound on v of the follower, computed at the lower corner of a box. The tilt of the follower
 * is F(theta), the maximum of theta_1(t) over all t <= theta (chain.h). So for any t <= theta, the v of the
 * tilt theta_1(t) is such a lower bound. */
static double follow_below(const struct corner *c, double v)
{
    double t = smaller(v, c->leave.lo);
    return turned_below(corner_turn(c, t), t);
}

/* Returns an upper bound on v of the follower, computed at the upper corner of a box. */
static double follow_above(const struct corner *c, double v)
{
    if (v >= c->leave.lo)
        return PROOF_BOUND(DETACHED, c->last, turned_above(corner_turn(c, v), v));
    return smaller(turned_above(corner_turn(c, v), v), c->last);
}

/* ---- Powers ---- */

/* Powers, logarithms and exponentials are computed with the operations + - * / alone. Most functions of libm
 * have no guaranteed error bounds. Those that are used here (frexp, ldexp and nearbyint) are exact. */

/* Returns x^n for x >= 0 and n >= 1, by repeated squaring. */
static struct span power_whole(struct span x, int n)
{
    struct span power = span_of(1);
    for (; n > 0; n /= 2, x = span_square(x))
        if (n % 2)
            power = span_scale(power, x);
    return power;
}

/*
 * Returns 2 atanh t for 0 <= t <= 1/3, computed from the series
 *
 *     2 atanh t = 2 t (1 + t^2 (1/3 + t^2 (1/5 + ...))).
 *
 * The series is cut off after n = TERMS terms, so the innermost bracket that is computed ends with t^2 R. The
 * remainder R is at most
 *
 *     1/(2n+1) + t^2 (1/(2n+3) + ...) <= (1 + 1/9 + 1/81 + ...)/(2n+1) = (9/8)/(2n+1) < 1/n.
 *
 * So the interval [0, 1/n] takes the place of R.
 */
static struct span twice_atanh(struct span t)
{
    enum { TERMS = 18 }; /* (1/9)^18 < 2^-57 */
    struct span square = span_square(t), sum = {0, 1.0 / TERMS};
    for (int k = TERMS - 1; k >= 0; k--)
        sum = span_add(span_over(span_of(1), span_of(2 * k + 1)), span_scale(square, sum));
    return span_scale(span_add(t, t), sum);
}

static struct span log_2(void)
{
    return twice_atanh(span_over(span_of(1), span_of(3))); /* 2 atanh(1/3) = ln 2 */
}

/*
 * Returns ln x for x >= 1. The number x is split into x = 2^(n-1) m with an integer n and 1 <= m < 2, so that
 *
 *     ln x = (n - 1) ln 2 + 2 atanh((m - 1)/(m + 1)).
 */
static struct span log_of(double x)
{
    int n;
    double m = 2 * frexp(x, &n);                                                 /* exact */
    struct span t = span_over(span_of(m - 1), span_add(span_of(m), span_of(1))); /* m - 1 is also exact */
    return span_add(span_scale(span_of(n - 1), log_2()), twice_atanh(t));
}

/*
 * Returns e^x for 0 <= x <= 700. The argument is split into x = n ln 2 + y with an integer n and |y| < 1/2,
 * so that e^x = 2^n e^y.
 *
 * The series of e^y is cut off after the term y^N/N!, where N = TERMS. Each later term is less than 1/4 of
 * the term before it. So the remainder is at most
 *
 *     |y|^(N+1)/(N+1)! / (1 - 1/4) < 2 (1/2)^(N+1)/(N+1)! < 2^-63   for N = 16.
 */
static struct span exp_of(double x)
{
    enum { TERMS = 16 };
    double n = nearbyint(x / 0x1.62e42fefa39efp-1);
    struct span y = span_sub(span_of(x), span_scale(span_of(n), log_2())), sum = span_of(1);
    for (int k = TERMS; k >= 1; k--) /* 1 + y (1 + y/2 (1 + ...)) */
        sum = span_add(span_of(1), span_mul(span_over(y, span_of(k)), sum));
    sum = span_add(sum, (struct span){-0x1p-63, 0x1p-63});
    return (struct span){ldexp(sum.lo, (int)n), ldexp(sum.hi, (int)n)}; /* exact */
}

/* Returns x^q for x >= 1 and q > 0. Integers q up to 64 need only multiplications. */
static struct span span_power(struct span x, struct span q)
{
    if (q.lo == q.hi && q.lo == (int)q.lo && q.lo <= 64) {
        struct span least = power_whole(span_of(x.lo), (int)q.lo),
                    most = power_whole(span_of(x.hi), (int)q.lo);
        return (struct span){least.lo, most.hi};
    }
    const struct span log = {least_0(log_of(x.lo).lo), log_of(x.hi).hi}, of_power = span_scale(q, log);
    return (struct span){larger(exp_of(least_0(of_power.lo)).lo, 1), exp_of(of_power.hi).hi};
}

/* ---- The train ---- */

static struct corner corner_make(const struct shape *shape, double r)
{
    struct corner c = {.r = r};
    struct span s = shape->s, of_r = span_of(r);
    c.rs = span_scale(of_r, s);
    c.rs.hi = most_1(c.rs.hi); /* all bounds in this file hold only for r s <= 1 */
    c.rL = span_scale(of_r, shape->L);
    /* 1 - r s by fma, which rounds only once */
    c.short_of = (struct span){least_0(down(fma(-r, s.hi, 1))), least_0(up(fma(-r, s.lo, 1)))};
    /* 1 - cos theta_leave = (1 - r s) (1 + r s) / (2 d L r^2) (41; A17) */
    struct span over = span_scale(span_scale(span_add(shape->d, shape->d), shape->L), span_square(of_r));
    c.leave = span_over(span_scale(c.short_of, span_add(span_of(1), c.rs)), over);
    c.leave.lo = smaller(least_0(c.leave.lo), shape->v_inf.lo);
    c.leave.hi = smaller(c.leave.hi, shape->v_inf.hi);
    struct turn first = corner_turn(&c, c.leave.lo), second = corner_turn(&c, c.leave.hi);
    struct turn turn = {{second.X.lo, first.X.hi}, {first.Y.lo, second.Y.hi}};
    c.last = turned_above(turn, c.leave.hi);
    return c;
}

struct span chain_follow(const struct growth *growth, struct span v)
{
    return PROOF_BOUND(CORNERS,
                       ((struct span){follow_below(&growth->low, v.lo), follow_above(&growth->high, v.hi)}),
                       ((struct span){follow_below(&growth->high, v.lo), follow_above(&growth->high, v.hi)}));
}

struct growth growth_make(const struct shape *shape, double r_low, double r_high)
{
    struct growth g = {.shape = shape, .r = {r_low, r_high}};
    g.low = corner_make(shape, r_low);
    g.high = corner_make(shape, r_high);
    g.leave = (struct span){g.high.leave.lo, g.low.leave.hi}; /* theta_leave decreases with r */
    g.rq = span_power(g.r, shape->q);
    g.weight = span_over(span_of(1), g.rq);
    g.weight.hi = most_1(g.weight.hi);
    g.inertia = span_over(g.weight, g.r);
    g.v_hit = chain_follow(&g, span_of(0));
    g.hit = span_sqrt(span_add(g.v_hit, g.v_hit));
    return g;
}

struct contact chain_contact(const struct growth *growth, struct span v)
{
    struct contact c;
    /* Beyond theta_leave, F is constant, so all tilts beyond theta_leave are treated like theta_leave. The
     * derivatives of F have no jump at theta_leave, since dF/dtheta = 0 there. */
    struct span u = {smaller(v.lo, growth->leave.lo), smaller(v.hi, growth->leave.hi)};
    struct turn low = corner_turn(&growth->low, u.hi), high = corner_turn(&growth->high, u.lo);
    c.X = (struct span){low.X.lo, high.X.hi};
    c.Y = (struct span){high.Y.lo, low.Y.hi};
    c.x = tilt_sine(u);
    c.held = v.lo >= growth->leave.hi;
    c.may_hold = v.hi >= growth->leave.lo;
    /* dF/dtheta = 1 - r L sin theta / Y (14; b10), which is between 0 and 1. */
    c.slope = (struct span){least_0(down(1 - up(up(growth->high.rL.hi * c.x.hi) / c.Y.lo))),
                            most_1(least_0(up(1 - down(down(growth->low.rL.lo * c.x.lo) / c.Y.hi))))};
    if (c.held)
        c.slope = span_of(0);
    /* dF/dr = (X/r)/Y, where X/r = L cos theta - d. dF/dr decreases with theta and increases with r. */
    c.shift =
        (struct span){down(down(c.X.lo / growth->r.lo) / c.Y.hi), up(up(c.X.hi / growth->r.hi) / c.Y.lo)};
    c.shift.lo = least_0(c.shift.lo);
    return c;
}

struct domino chain_next(const struct growth *growth, const struct domino *leader,
                         const struct contact *contact)
{
    struct domino next = {.v = chain_follow(growth, leader->v)};
    next.slope = span_scale(contact->slope, leader->slope);
    next.slope.lo = least_0(next.slope.lo);
    next.shift = span_add(span_scale(contact->slope, leader->shift), contact->shift);
    next.shift.lo = least_0(next.shift.lo);
    return next;
}

struct domino chain_last(const struct growth *growth)
{
    struct span leave = growth->leave;
    struct contact at = chain_contact(growth, leave);
    /* theta_f = theta_1(theta_leave). Since dF/dtheta = 0 at theta_leave, d theta_f/dr = dF/dr. */
    return (struct domino){.v = {follow_below(&growth->low, growth->low.leave.lo), growth->high.last},
                           .shift = at.shift};
}
