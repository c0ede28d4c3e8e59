/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Finds a root of the margin, and then proves that it is the first root. Both steps are fast: the secant
 * method needs only a few passes to find the root from a guess, and the proof needs only a few strips of
 * growths below the root. The proof shows that the margin has no other root in the strip that ends at the
 * root, and that the margin is positive over all lower strips.
 */
#include "growth/limit.h"

/* Returns -d ln K / d ln r, approximately: how fast the kinetic energy K falls with the growth. By equation
 * (24; c6), K is roughly proportional to r^(-(2q+1)) times the fuel. The fuel usually falls with r, too. */
KERNEL real margin_falls(const struct margin_context *c, real r)
{
    real q = c->geometry.q, s = c->s;
    real matter = 1 / (q * log(r) + r * sqrt(s * (s + 2 * c->geometry.d)));
    return 2 * q + 1 + q * fmin(matter, 1 / s);
}

/* ---- The root ---- */

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
        next = r * exp((f > 0 ? log1p(2 * f / (1 - f)) : -log1p(-2 * f / (1 + f))) / 2 / margin_falls(c, r));
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
static enum dom_status root_search(struct margin_context *c, struct root_search *s, real r, real *root)
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
        if (share == 0) {
            *root = r;
            return DOM_OK;
        }
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
            *root = close ? next : s->known > 1 && fabs(s->at[1].share) < fabs(share) ? s->at[1].r : r;
            return DOM_OK;
        }
        r = next;
    }
    return DOM_NOT_CONVERGED;
}

KERNEL enum dom_status root_between(struct margin_context *c, const struct margin_sample *lo,
                                    const struct margin_sample *hi, real *r)
{
    real up = margin_share(&lo->margin), down = margin_share(&hi->margin);
    struct root_search s = {.lo = lo->r, .hi = hi->r};
    bool both = !lo->margin.barrier_is_bound && !hi->margin.barrier_is_bound && up < 1 && down > -1;
    real first = both ? up / (up - down) : (real)0.5;
    margin_follow_begin(c);
    return root_search(c, &s, lo->r + fmin(fmax(first, (real)0.1), (real)0.9) * (hi->r - lo->r), r);
}

/* To get the slope, the margin is evaluated at this relative distance below an approximate root. The relative
 * error of the approximate root may be at most ROOT_ASIDE^2. */
#define ROOT_ASIDE ((real)1e-5)

/* Finds the root close to `near`. Evaluates the margin slightly below `near` first, to get the slope. */
static enum dom_status root_followed(struct margin_context *c, real near, real *root)
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

KERNEL enum dom_status root_near(struct margin_context *c, real near, real *root, bool *found)
{
    const real tol = c->geometry.tol, aside = ROOT_ASIDE * ROOT_ASIDE;
    const bool follows = c->geometry.dynamics->conservative;
    /* With a coarser tolerance, the root could be rejected as too far from `near`. */
    c->geometry.tol = fmin(tol, aside);
    enum dom_status status =
        follows ? root_followed(c, near, root)
                : model_status(c->status, num_root(margin_at, c, near * (1 - aside), near * (1 + aside),
                                                   c->geometry.tol / 8, root));
    c->geometry.tol = tol;
    *found = status == DOM_OK && fabs(*root - near) <= aside * near && (!follows || margin_highest(c, *root));
    if (status != DOM_INTERRUPTED && status != DOM_TOO_LONG)
        status = c->status = DOM_OK;
    return status;
}

/* ---- The proof ---- */

/* The last barrier that the search for the root computes is at a growth close to the root. The barrier at the
 * root itself is assumed to be larger by at most this fraction. */
#define DOWN_SLACK ((real)8e-3)

/* Returns thickness / height of the flat part of a domino, without the rounded edges. Sharp-edged dominoes
 * with these proportions have nearly the same r_max. */
static real flat_thickness(const struct geometry *geometry)
{
    return geometry->rounded.wide / geometry->rounded.tall;
}

/* Returns max(s / d - 2 d^2 / (1 - d^2), 0). With sharp edges on a level floor, a train of equal dominoes
 * (r = 1) has fuel only if this number is positive. */
static real root_room(const struct margin_context *c)
{
    const real d = flat_thickness(&c->geometry), s = c->s / (1 - c->geometry.rounded.rho);
    return fmax(s / d - 2 * d * d / (1 - d * d), 0);
}

/* Estimates the root by a fitted formula. For ordinary dominoes, the logarithm of the estimate is correct to
 * a few percent. */
static real root_guess(const struct margin_context *c)
{
    const real d = fmin(flat_thickness(&c->geometry), (real)0.35), q = c->geometry.q, u = root_room(c),
               x = fmin(log(u + (real)0.1), 2);
    const real share = (real)1.132 - (real)0.886 * d +
                       x * ((real)0.072 - (real)0.043 * d - (real)0.0244 * (q - (real)3.5) -
                            x * ((real)0.0701 + (real)0.0195 * x));
    return exp((real)2.4 / (q - (real)0.6) * share * log1p((real)0.4 * u));
}

/* Estimates how fast the margin falls at the root: minus its derivative with respect to ln r. */
static real root_slope(const struct margin_context *c)
{
    const real u = fmax(root_room(c), (real)0.1);
    return barrier_most(&c->geometry) * fmax(c->geometry.q - (real)1.2, (real)0.5) * (1 + 1 / (u * u));
}

/* If root_guess exceeds this fraction of the reach, root_near_reach replaces it. */
#define REACH_NEAR ((real)0.96)

/*
 * Estimates a root close to the reach, from the kinetic energy K at the reach. At such growths, all followers
 * detach before the head reaches theta_u. By then only domino 1 has moved: from theta_c to theta_f. Its fall
 * lowers the barrier. To first order in sqrt(1 - r s), the barrier is
 *
 *     barrier_most - r^(-q) sqrt(2 (1 - r s)) (1 - sqrt(d / L)).
 *
 * *start receives the estimate, or 0 if there is none. Returns true if K at the reach exceeds every possible
 * barrier.
 */
static bool root_near_reach(struct margin_context *c, real reach, real *start, real *slope)
{
    const real d = c->geometry.d, most = barrier_most(&c->geometry);
    const struct margin at = margin_sign(c, reach);
    const real lacks = sqrt((real)2) * (1 - sqrt(d / (c->s + d))) / pow(reach, c->geometry.q);
    const real root = fmin(fmax(most - at.kinetic, 0) / lacks, (real)0.3);
    *start = c->status == DOM_OK && margin_value(&at) < 0 ? reach * (1 - root * root) : 0;
    *slope = lacks / (2 * root);
    c->nearest.height = at.barrier;
    c->share = margin_share(&at);
    return c->status == DOM_OK && at.barrier_is_bound;
}

KERNEL enum dom_status root_any(struct margin_context *c, const struct margin_sample *from, real *root,
                                real *falls)
{
    const real reach = c->geometry.span / c->s, start = root_guess(c);
    struct root_search s = {.lo = from->r, .hi = reach, .slope = root_slope(c)};
    real at = 0;
    *root = (real)INFINITY;
    if (!(start > from->r && start < reach))
        return DOM_OK;
    margin_follow_begin(c);
    const enum dom_status status = root_search(c, &s, start, &at);
    if (status == DOM_INTERRUPTED || status == DOM_TOO_LONG)
        return status;
    c->status = DOM_OK;
    if (status == DOM_OK && s.known > 1 && at < reach && margin_highest(c, at)) {
        *root = at;
        *falls = (s.at[1].value - s.at[2].value) / (s.at[2].r - s.at[1].r);
    }
    return DOM_OK;
}

enum { DOWN_STRIPS = 32, DOWN_FAILS = 8 };

/* Returns the width in ln r of the first strip below the root. `whole` is the width of all strips
 * together. */
static real down_first(real whole)
{
    real width = whole < (real)0.15 ? (real)0.035 : fmin(fmax(whole / (real)7.5, (real)0.029), (real)0.1);
    return whole < (real)0.03 ? whole : fmin(width, whole / 2);
}

/* Returns a width in ln r for the strip just below a growth r near the reach. A strip of this width is
 * usually narrow enough for the bounds to show that the margin decreases over it. */
static real down_near(const struct margin_context *c, real r)
{
    return fmin(1000 * log(1 / (c->s * r)), (real)1e-2);
}

/* Tries to show that the margin is positive between `from` and `root`, strip by strip, beginning at `root`
 * and going down. Stores in *down how far it gets: the margin is positive between *down and `root`. If
 * nothing can be shown, *down is `root`. If the margin is positive even at the reach, the caller passes the
 * reach as `root`. */
static enum dom_status positive_below(struct margin_context *c, real root, real from, real *down)
{
    const real most = barrier_most(&c->geometry);
    /* at *down: an upper bound on the barrier, and a lower bound on the margin */
    real barrier = c->nearest.height * (1 + DOWN_SLACK), margin = 0, width = down_first(log(root / from));
    /* Near the reach the margin changes like sqrt(1 - r s), so the first strip must be narrow. */
    const bool reaches = root == 1 / c->s;
    width = reaches ? c->share * c->share : fmin(width, fmax(down_near(c, root), log(1 / (c->s * root))));
    *down = root;
    for (int k = 0, fails = 0; k < DOWN_STRIPS && fails < DOWN_FAILS; k++) {
        if (*down <= from)
            break;
        struct strip strip;
        const real whole = log(*down / from);
        const bool last = width >= whole * (real)0.75;
        const real lo = last ? from : *down * exp(-width);
        width = last ? whole : width;
        enum dom_status status = scan_bounds(c, lo, *down, &strip);
        if (status != DOM_OK)
            return status;
        const real highest = strip.clear ? most : strip_barrier_most(&strip, barrier, most, width);
        const real over = strip.kinetic_least - highest,
                   left = strip.clear ? 0 : margin - strip.margin_slope * width;
        const bool falls = !strip.clear && (strip.root_slope < 0 || (margin > 0 && left > 0));
        if (!falls && ((*down == root && !reaches) || !(over > 0))) {
            width /= 2;
            fails++;
            continue;
        }
        margin = fmax(fmax(over, left), 0);
        barrier = highest;
        *down = lo;
        width = fmax(2 * width, down_near(c, lo));
        fails = 0;
    }
    return DOM_OK;
}

enum { PROOF_STRIPS = 8, PROOF_DEPTH = 4 };

/* Raises *lo, where the margin is positive, towards the growth `to`. Tries a few strips, one after the other.
 * If bounds show that the margin is positive over the strip that begins at *lo, the upper end of this strip
 * becomes the new *lo. */
static enum dom_status positive_to(struct margin_context *c, struct margin_sample *lo, real to)
{
    struct margin_sample ahead[PROOF_DEPTH] = {{.r = to, .margin = {.kinetic = REAL_NAN}}};
    int depth = 1;
    for (int k = 0; k < PROOF_STRIPS && depth > 0; k++) {
        enum known known;
        struct margin_sample *hi = &ahead[depth - 1];
        enum dom_status status = scan_strip(c, lo, hi, &known);
        if (status != DOM_OK)
            return status;
        /* Try again with the barrier at hi itself instead of an upper bound. */
        if (known == KNOWN_NOTHING && hi->margin.barrier_is_bound) {
            hi->margin = margin_tops(c, hi->r);
            status = c->status == DOM_OK ? scan_strip(c, lo, hi, &known) : c->status;
        }
        if (status != DOM_OK)
            return status;
        if (known == KNOWN_POSITIVE) {
            *lo = *hi;
            depth--;
            continue;
        }
        if (depth == PROOF_DEPTH || margin_value(&hi->margin) < 0)
            return DOM_OK;
        ahead[depth++] = (struct margin_sample){.r = lo->r * pow(hi->r / lo->r, (real)0.62),
                                                .margin = {.kinetic = REAL_NAN}};
    }
    return DOM_OK;
}

KERNEL enum dom_status root_first(struct margin_context *c, struct margin_sample *from, real *root,
                                  bool *found)
{
    const real reach = 1 / c->s;
    real start = root_guess(c);
    struct root_search s = {.lo = from->r, .hi = reach, .slope = root_slope(c)};
    const bool reaches = start > REACH_NEAR * reach && root_near_reach(c, reach, &start, &s.slope);
    enum dom_status status = c->status;
    bool known = reaches && from->r < reach;
    *found = false;
    *root = reach;
    if (status == DOM_OK && start > from->r && start < reach) {
        margin_follow_begin(c);
        status = root_search(c, &s, start, root);
        known = status == DOM_OK && *root < reach && margin_highest(c, *root);
    }
    if (status == DOM_INTERRUPTED || status == DOM_TOO_LONG)
        return status;
    c->status = DOM_OK;
    if (!known)
        return DOM_OK;
    real falls = *root;
    status = positive_below(c, *root, from->r, &falls);
    if (status == DOM_OK && falls < *root && falls > from->r)
        status = positive_to(c, from, falls);
    *found = status == DOM_OK && falls < *root && from->r >= falls;
    return status;
}
