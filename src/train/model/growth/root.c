/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Finds a root of the margin. Without friction, the search follows one maximum of H from growth to growth by
 * Newton's method, and computes only as many digits as the next step needs. It takes a third of the time of a
 * search for the barrier at each growth.
 */
#include "growth/limit.h"

/* ---- From a bracket ---- */

/* Finds the root in a bracket: one function gives the margin or a number of the same sign. The slope is that
 * of the line to the last growth at which the margin was not almost 0. */
static enum dom_status root_of(struct margin_context *c, num_function *f, const struct margin_sample *lo,
                               const struct margin_sample *hi, struct root *root)
{
    const struct margin *at_lo = &lo->margin, *at_hi = &hi->margin;
    const bool follows = f == margin_follow;
    c->beside = (struct margin_point){.r = 0};
    margin_follow_begin(c, 1);
    const enum num_status solver =
        num_root_between(f, c, lo->r, follows ? margin_share(at_lo) : margin_value(at_lo), hi->r,
                         follows ? margin_share(at_hi) : margin_value(at_hi), c->geometry.tol / 8, &root->r);
    root->barrier = c->nearest.height;
    root->beside = c->beside.r;
    root->falls = c->beside.r > 0 && c->beside.r != root->r ? c->beside.value / (root->r - c->beside.r) : 0;
    return model_status(c->status, solver);
}

KERNEL enum dom_status root_between(struct margin_context *c, const struct margin_sample *lo,
                                    const struct margin_sample *hi, bool follow, struct root *root)
{
    if (follow) {
        const enum dom_status status = root_of(c, margin_follow, lo, hi, root);
        if (status == DOM_INTERRUPTED || status == DOM_TOO_LONG)
            return status;
        c->status = DOM_OK;
        if (status == DOM_OK && margin_highest(c, root->r))
            return DOM_OK;
    }
    return root_of(c, margin_at, lo, hi, root);
}

/* ---- From a guess ---- */

/* A point of the secant method: the growth r, margin_share at r, the margin itself, and its relative
 * tolerance. */
struct root_point {
    real r, share, value, tol;
};

/* Returns the root of the line through two points. */
static real root_line(const struct root_point *a, const struct root_point *b)
{
    /* Close to the root, margin_share is less curved than the margin. Far from the root, margin_share is
     * almost constant, so the line goes through values of the margin. */
    bool near = fabs(a->share) + fabs(b->share) < 1;
    real f_a = near ? a->share : a->value, f_b = near ? b->share : b->value;
    return b->r - f_b * (b->r - a->r) / (f_b - f_a);
}

enum { ROOT_STEPS = 12 };

/* Follows one maximum of H from the growth r to a root between `from` and the reach, by the secant method,
 * and by inverse interpolation through the last three points near the root. `slope` is about -d margin / d ln
 * r. If it is accurate, `exact` is true. Returns false if the method does not find a root. */
static bool root_secant(struct margin_context *c, real from, real r, real slope, bool exact,
                        struct root *root)
{
    struct root_point at[3] = {{0}};
    const real tol = c->geometry.tol, reach = c->geometry.span / c->s;
    for (int known = 1; known <= ROOT_STEPS && r > from && r < reach; known++) {
        at[0] = at[1];
        at[1] = at[2];
        at[2].r = r;
        at[2].share = margin_follow(r, c);
        at[2].value = c->followed_value;
        at[2].tol = c->followed_tol;
        if (c->status != DOM_OK)
            return false;
        const real f = at[2].share;
        /* if the first growth is a root, a step aside gives the slope */
        real next = known > 1 ? root_line(&at[1], &at[2])
                    : f == 0  ? r * (1 - (real)1e-5)
                              : r * exp(at[2].value / slope);
        if (known > 2 && fabs(f) < fabs(at[1].share) / 2 && fabs(at[1].share) + fabs(at[0].share) < 1)
            next += (next - root_line(&at[0], &at[1])) * f / (at[0].share - f);
        const real step = fabs(next - r), before = known == 1 ? r : fabs(r - at[1].r);
        *root = (struct root){.r = next,
                              .barrier = c->nearest.height,
                              .falls = known > 1 ? (at[1].value - at[2].value) / (r - at[1].r) : 0,
                              .beside = at[1].r};
        /* The error after the next step is about the product of the last two errors, divided by a length.
         * With an exact slope, the steps do not show this length, which is about r. The step has the relative
         * error of the share at the point before. */
        const bool last =
            exact ? 16 * step * before <= tol * r * r : 16 * step * step <= tol / 8 * r * before;
        if (known > 1 && last && at[2].tol <= tol && step * at[1].tol <= tol / 2 * r * fabs(at[1].share))
            return next > from && next < reach;
        r = next;
    }
    return false;
}

/* The root that a coarser kernel has found is correct to about ROOT_NEAR. With losses, a margin is expensive,
 * so the slope there comes from a margin with a few digits, at the relative distance ROOT_ASIDE. */
#define ROOT_NEAR  ((real)1e-10)
#define ROOT_ASIDE ((real)1e-5)

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

KERNEL enum dom_status root_any(struct margin_context *c, real from, real near, struct root *root)
{
    real slope, start = root_guess(c, &slope);
    struct root at = {.r = 0};
    *root = (struct root){.r = (real)INFINITY};
    const bool exact = near > 0 && !c->geometry.conservative;
    margin_follow_begin(c, near > 0 ? ROOT_NEAR : 1);
    if (exact) {
        const real tol = c->geometry.tol;
        c->geometry.tol = fmax(tol, ROOT_ASIDE * ROOT_NEAR);
        margin_follow(near * (1 - ROOT_ASIDE), c);
        slope = c->followed_value / ROOT_ASIDE;
        c->geometry.tol = tol;
    }
    const bool found = root_secant(c, from, near > 0 ? near : start, slope, exact, &at);
    if (c->status == DOM_INTERRUPTED || c->status == DOM_TOO_LONG)
        return c->status;
    c->status = DOM_OK;
    /* Near the bottom of a shallow dip, the search may end where there is no root. */
    const struct margin m = {.kinetic = at.barrier, .barrier = at.barrier};
    const real error = fmax(c->geometry.tol * at.barrier, margin_error(c, &m, margin_finest(c)));
    const bool sure =
        near > 0 ? fabs(at.r - near) <= ROOT_NEAR * near : at.falls * at.r > 100 * sqrt(error * at.barrier);
    if (found && sure && (!c->geometry.conservative || margin_highest(c, at.r)))
        *root = at;
    return DOM_OK;
}
