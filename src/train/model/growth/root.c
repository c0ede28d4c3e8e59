/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Finds a root of the margin by the secant method. The search follows one maximum of H from growth to growth
 * by Newton's method, and computes only as many digits as the next step needs. It takes a third of the time
 * of a root finder that searches for the barrier at each growth.
 */
#include "growth/limit.h"

/* Returns -d ln K / d ln r, approximately: how fast the kinetic energy K falls with the growth. By equation
 * (24; c6), K is roughly proportional to r^(-(2q+1)) times the fuel. The fuel usually falls with r, too. */
static real kinetic_falls(const struct margin_context *c, real r)
{
    real q = c->geometry.q, s = c->s;
    real matter = 1 / (q * log(r) + r * sqrt(s * (s + 2 * c->geometry.d)));
    return 2 * q + 1 + q * fmin(matter, 1 / s);
}

/* A point of the search: the growth r, margin_share at r, the margin itself (`value`), and the relative
 * tolerance of the margin. */
struct root_point {
    real r, share, value, tol;
};

struct root_search {
    real lo, hi;             /* the bracket: the margin is positive at lo and negative at hi */
    struct root_point at[3]; /* the newest points, with the newest of all in at[2] */
    int known;               /* the number of points so far; at[] holds the last three */
    real slope;              /* roughly -d margin / d ln r, or 0 if unknown */
};

static void root_add(struct root_search *s, struct root_point point)
{
    if (point.share >= 0)
        s->lo = fmax(s->lo, point.r);
    if (point.share <= 0)
        s->hi = fmin(s->hi, point.r);
    /* true if `point` repeats the newest point, with a finer tolerance */
    bool again = s->known > 0 && s->at[2].r == point.r;
    for (int k = 0; k < 2 && !again; k++)
        s->at[k] = s->at[k + 1];
    s->at[2] = point;
    s->known += !again;
}

/* Returns the root of the line through two points. */
static real root_line(const struct root_point *a, const struct root_point *b)
{
    /* Close to the root, margin_share is less curved than the margin. Far from the root, margin_share is
     * almost constant, so the line goes through values of the margin. */
    bool near = fabs(a->share) + fabs(b->share) < 1;
    real f_a = near ? a->share : a->value, f_b = near ? b->share : b->value;
    return b->r - f_b * (b->r - a->r) / (f_b - f_a);
}

/* If |margin_share| > 1 - ROOT_FLAT, the root may be far away. The next step then multiplies or divides r by
 * at least r^ROOT_STEP. */
#define ROOT_FLAT ((real)0.02)
#define ROOT_STEP ((real)0.06)

/* Returns r, or the middle of the bracket if r is outside the bracket. */
static real root_inside(const struct root_search *s, real r)
{
    return r >= s->lo && r <= s->hi ? r : s->lo + (s->hi - s->lo) / 2;
}

/* Returns the next growth inside the bracket, by inverse interpolation through the newest points. */
static real root_next(const struct root_search *s, const struct margin_context *c)
{
    const struct root_point *at = s->at;
    real r = at[2].r, f = at[2].share, next = s->lo;
    if (s->known == 1 && s->slope > 0)
        return root_inside(s, r * exp(at[2].value / s->slope));
    bool high = f<-1 + ROOT_FLAT, low = f> 1 - ROOT_FLAT;
    if (s->known == 1 && !high && !low)
        /* f, the margin_share, is tanh(ln(K / B) / 2), so it gives ln(K / B) */
        next = r * exp((f > 0 ? log1p(2 * f / (1 - f)) : -log1p(-2 * f / (1 + f))) / 2 / kinetic_falls(c, r));
    if (s->known > 1)
        next = root_line(&at[1], &at[2]);
    if (s->known > 2 && fabs(f) < fabs(at[1].share) / 2 && fabs(at[1].share) + fabs(at[0].share) < 1)
        next += (next - root_line(&at[0], &at[1])) * f / (at[0].share - f);
    if (high || low) { /* K or B is almost 0: the root is several steps away */
        real step = exp((high ? -1 : 1) * ROOT_STEP * log(r));
        next = s->known == 1 ? r * step : high ? fmin(next, r * step) : fmax(next, r * step);
    }
    return root_inside(s, next);
}

#define ROOT_STEPS 40

/* Finds a root inside the bracket, starting at the growth r. */
static enum dom_status root_search(struct margin_context *c, struct root_search *s, real r, struct root *root)
{
    const real tol = c->geometry.tol / 8;
    for (int i = 0; i < ROOT_STEPS; i++) {
        real share = margin_follow(r, c);
        bool none = c->status == DOM_NOT_CONVERGED; /* H has no maximum, so the barrier is 0 */
        if (c->status != DOM_OK && !none)
            return c->status;
        c->status = DOM_OK;
        if (none) {
            s->lo = r;
            s->known = 0;
            r += fmin((s->hi - r) / 4, r * ROOT_STEP * log(r));
            continue;
        }
        root_add(s, (struct root_point){r, share, c->followed_value, c->followed_tol});
        root->falls = s->known > 1 ? (s->at[1].value - s->at[2].value) / (s->at[2].r - s->at[1].r) : 0;
        root->beside = s->at[1].r;
        root->r = r;
        root->barrier = c->nearest.height;
        if (share == 0)
            return DOM_OK;
        real next = root_next(s, c), step = fabs(next - r);
        /* The error after the next step is approximately the product of the last two errors, divided by a
         * length. In the first two steps, this length is estimated as min(r, reach - r) / 16. */
        real before = s->known == 1 ? r : fabs(s->at[1].r - s->at[s->known > 2 ? 0 : 2].r),
             length = fmin(r, c->geometry.span / c->s - r);
        bool close = 16 * step * (s->known > 2 ? step : before) <= tol * r * (s->known > 2 ? before : length);
        /* The step has the same relative error as margin_share at the previous point. */
        close = close && (s->known == 1 || step * s->at[1].tol <= 4 * tol * r * fabs(s->at[1].share));
        bool narrow = s->hi - s->lo <= tol * r;
        if (c->followed_tol <= c->geometry.tol && (close || narrow)) {
            root->r = close ? next : s->known > 1 && fabs(s->at[1].share) < fabs(share) ? s->at[1].r : r;
            return DOM_OK;
        }
        r = next;
    }
    return DOM_NOT_CONVERGED;
}

KERNEL enum dom_status root_between(struct margin_context *c, const struct margin_sample *lo,
                                    const struct margin_sample *hi, struct root *root)
{
    real up = margin_share(&lo->margin), down = margin_share(&hi->margin);
    struct root_search s = {.lo = lo->r, .hi = hi->r};
    bool both = !lo->margin.barrier_is_bound && !hi->margin.barrier_is_bound && up < 1 && down > -1;
    real first = both ? up / (up - down) : (real)0.5;
    margin_follow_begin(c);
    return root_search(c, &s, lo->r + fmin(fmax(first, (real)0.1), (real)0.9) * (hi->r - lo->r), root);
}

/* To get the slope, the margin is evaluated at this relative distance below an approximate root. The relative
 * error of the approximate root may be at most ROOT_ASIDE^2. */
#define ROOT_ASIDE ((real)1e-5)

/* Finds the root close to `near`. Evaluates the margin slightly below `near` first, to get the slope. */
static enum dom_status root_followed(struct margin_context *c, real near, struct root *root)
{
    struct root_search s = {.lo = near * (1 - 2 * ROOT_ASIDE),
                            .hi = fmin(near * (1 + ROOT_ASIDE), c->geometry.span / c->s)};
    const real aside = near * (1 - ROOT_ASIDE);
    margin_follow_begin(c);
    c->share = cbrt(ROOT_ASIDE); /* only a few digits of the slope are needed */
    const real share = margin_follow(aside, c);
    if (c->status != DOM_OK)
        return c->status;
    root_add(&s, (struct root_point){aside, share, c->followed_value, c->followed_tol});
    c->share = ROOT_ASIDE * ROOT_ASIDE * ROOT_ASIDE; /* from here on, all digits are needed */
    return root_search(c, &s, near, root);
}

KERNEL enum dom_status root_near(struct margin_context *c, real near, struct root *root, bool *found)
{
    const real tol = c->geometry.tol, aside = ROOT_ASIDE * ROOT_ASIDE;
    const bool follows = c->geometry.dynamics->conservative;
    /* With a coarser tolerance, the root could be rejected as too far from `near`. */
    c->geometry.tol = fmin(tol, aside);
    *root = (struct root){.falls = 0};
    enum dom_status status =
        follows ? root_followed(c, near, root)
                : model_status(c->status, num_root(margin_at, c, near * (1 - aside), near * (1 + aside),
                                                   c->geometry.tol / 8, &root->r));
    c->geometry.tol = tol;
    root->barrier = follows ? root->barrier : c->barrier.height;
    *found =
        status == DOM_OK && fabs(root->r - near) <= aside * near && (!follows || margin_highest(c, root->r));
    if (status != DOM_INTERRUPTED && status != DOM_TOO_LONG)
        status = c->status = DOM_OK;
    return status;
}

/* Estimates the root by a fitted formula. For ordinary dominoes, the logarithm of the estimate is correct to
 * a few percent. Also estimates the slope at the root: minus the derivative of the margin with respect to
 * ln r. */
static real root_guess(const struct margin_context *c, real *slope)
{
    /* A rounded domino has nearly the same r_max as a sharp one with the proportions of its flat part. */
    const real flat = c->geometry.rounded.wide / c->geometry.rounded.tall, d = fmin(flat, (real)0.35),
               q = c->geometry.q, s = c->s / (1 - c->geometry.rounded.rho);
    /* With sharp edges on a level floor, equal dominoes have fuel only if u is positive. */
    const real u = fmax(s / flat - 2 * flat * flat / (1 - flat * flat), 0), x = fmin(log(u + (real)0.1), 2);
    const real share = (real)1.132 - (real)0.886 * d +
                       x * ((real)0.072 - (real)0.043 * d - (real)0.0244 * (q - (real)3.5) -
                            x * ((real)0.0701 + (real)0.0195 * x));
    const real room = fmax(u, (real)0.1);
    *slope = barrier_most(&c->geometry) * fmax(q - (real)1.2, (real)0.5) * (1 + 1 / (room * room));
    return exp((real)2.4 / (q - (real)0.6) * share * log1p((real)0.4 * u));
}

KERNEL enum dom_status root_any(struct margin_context *c, real from, struct root *root)
{
    struct root_search s = {.lo = from, .hi = c->geometry.span / c->s};
    const real reach = s.hi, start = root_guess(c, &s.slope);
    struct root at;
    *root = (struct root){.r = (real)INFINITY};
    if (!(start > from && start < reach))
        return DOM_OK;
    margin_follow_begin(c);
    const enum dom_status status = root_search(c, &s, start, &at);
    if (status == DOM_INTERRUPTED || status == DOM_TOO_LONG)
        return status;
    c->status = DOM_OK;
    /* Near the bottom of a shallow dip, the search may end where there is no root. */
    const struct margin m = {.kinetic = at.barrier, .barrier = at.barrier};
    const real error = fmax(c->geometry.tol * at.barrier, margin_error(c, &m, margin_finest(c)));
    if (status == DOM_OK && at.r < reach && at.falls * at.r > 100 * sqrt(error * at.barrier) &&
        margin_highest(c, at.r))
        *root = at;
    return DOM_OK;
}
