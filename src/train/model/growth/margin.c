/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The margin K - B of a train or of a pair, and a root of it. */
#include "dynamics/dynamics.h"
#include "growth/limit.h"

/* Finds the barrier by the method c->how. */
static enum dom_status margin_barrier(const struct geometry *geometry, struct margin_context *c,
                                      struct margin *m)
{
    struct barrier *b = &c->barrier;
    const real most = barrier_most(geometry), sure = 4 * geometry->tol;
    if (c->how == MARGIN_SIGN && m->kinetic * (1 - sure) > MARGIN_HIGH * most) {
        m->barrier = most;
        m->barrier_is_bound = true;
        return DOM_OK;
    }
    if (c->how != MARGIN_SURE && m->kinetic < 0) { /* the margin is negative, whatever the barrier is */
        m->barrier = 0;
        return DOM_OK;
    }
    enum dom_status status = DOM_NOT_CONVERGED;
    if (c->how != MARGIN_SURE) {
        /* Only the last steps of a root search need a fine tolerance. */
        const bool rough = c->how == MARGIN_FOLLOW && geometry->tol > c->geometry.tol;
        const real tol = rough ? TOP_TOL_ROUGH(geometry) : TOP_TOL(geometry);
        const bool top = barrier_follow(geometry, tol, b);
        m->barrier = fmax(b->height, 0); /* H(theta) - H(0) is 0 at the start */
        if (c->how == MARGIN_FOLLOW || (top && m->kinetic < b->height * (1 - sure)))
            return top ? DOM_OK : DOM_NOT_CONVERGED;
        if (top)
            status = barrier_tops(geometry, b);
    }
    if (status != DOM_OK)
        /* With friction, Newton's method is not available. The error of the tilt then affects the barrier to
         * second order instead of third order, so the tilt needs a finer tolerance. */
        status = barrier_search(geometry, tilt_angle(geometry->c),
                                geometry->conservative ? TOP_TOL(geometry) : geometry->tol / 8, b);
    m->barrier_error = status == DOM_OK ? flow_required_error(geometry) : 0;
    m->barrier = b->height;
    return status;
}

/* Equation (26; c8), corrected: the kinetic energy has the factor J(0). */
static enum dom_status train_margin(const struct geometry *geometry, struct margin_context *c,
                                    struct margin *m)
{
    struct launch launch;
    /* At r = 1 both fuel formulas agree, and the closed form is faster. */
    if (geometry->r == 1 && geometry->conservative && geometry_paper_fuel(geometry) <= 0)
        return DOM_NO_FUEL;
    enum dom_status status = dynamics_collide(geometry, c->train->fuel, &launch);
    if (status == DOM_OK && geometry->r == 1 && launch.fuel <= 0)
        return DOM_NO_FUEL;
    *m = (struct margin){.kinetic = launch.kinetic};
    return status == DOM_OK ? margin_barrier(geometry, c, m) : status;
}

/* Equation (17; b13). */
static enum dom_status pair_margin(const struct geometry *geometry, struct margin_context *c,
                                   struct margin *m)
{
    struct geometry two = *geometry;
    const bool tips = geometry_lift(geometry, geometry->c) < 0; /* (5; b0) */
    two.n = 1;                                                  /* the domino that hits has no followers */
    real J = geometry_inertia(geometry, geometry->c);
    real k = geometry->inertia * J, inertia_ratio = 0;
    enum dom_status status = dynamics_inertia_ratio(geometry, &two, geometry->c, J, &inertia_ratio);
    if (status != DOM_OK)
        return status;
    real share = collision_velocity_ratio(inertia_ratio), tipped = 0; /* (15; b11) */
    if (tips && losses_end_alone(geometry)) {
        tipped = geometry_tipped_omegasq(geometry);
    } else if (tips) {
        status = losses_tipped(geometry, &tipped);
        if (status != DOM_OK)
            return status;
        geometry->flow->solution.panels = 0; /* the flow is needed for the pair */
    }
    *m = (struct margin){.kinetic = (geometry->upright_inertia + k) * geometry->r * tipped * share * share};
    return margin_barrier(geometry, c, m);
}

KERNEL struct margin_context margin_of_train(const struct dom_train *train, const struct dom_compute *compute)
{
    struct margin_context c = {.train = train, .s = (real)train->s, .margin = train_margin};
    c.status = dynamics_read(train, compute, &c.geometry);
    if (c.status == DOM_OK && train->fuel == DOM_FUEL_PAPER && !energy_paper_holds(&c.geometry))
        c.status = DOM_NO_METHOD;
    return c;
}

KERNEL struct margin_context margin_of_pair(const struct dom_train *train, const struct dom_compute *compute)
{
    struct margin_context c = margin_of_train(train, compute);
    /* the pair does not depend on the fuel formula */
    c.status = c.status == DOM_NO_METHOD ? DOM_OK : c.status;
    c.geometry.n = 2;
    c.margin = pair_margin;
    return c;
}

/* Margins below this fraction of K + B are too small to give the slope at a root. */
#define MARGIN_BESIDE ((real)1e-5)

static enum dom_status margin_to(struct margin_context *c, real r, real tol, struct margin *m)
{
    struct geometry geometry = c->geometry;
    geometry.tol = tol;
    c->status = geometry_set(&geometry, c->s, r);
    if (c->status == DOM_OK)
        far_make(&geometry, c->how == MARGIN_SIGN ? 1 : 2);
    if (c->status == DOM_OK)
        c->status = dynamics_begin(&geometry);
    if (c->status == DOM_OK)
        c->status = c->margin(&geometry, c, m);
    dynamics_end(&geometry);
    c->locked = c->status == DOM_LOCKS;
    /* If a train locks, its energy tends to 0, so the train stops. The margin is then negative. Its size does
     * not matter. */
    if (c->locked) {
        c->status = DOM_OK;
        *m = (struct margin){.kinetic = -1};
    }
    if (c->status == DOM_OK && fabs(margin_share(m)) > MARGIN_BESIDE)
        c->beside = (struct margin_point){r, margin_value(m)};
    return c->status;
}

KERNEL real margin_at(real r, void *context)
{
    struct margin_context *c = context;
    const struct margin m = margin_within(c, r, c->geometry.tol);
    c->nearest = c->barrier;
    return c->status == DOM_OK ? margin_value(&m) : REAL_NAN;
}

KERNEL real margin_error(const struct margin_context *c, const struct margin *m, real tol)
{
    /* near a root, |K| + barrier_most is of the size of the terms whose difference the margin is */
    return 4 * tol * (fabs(m->kinetic) + m->barrier) +
           16 * REAL_EPSILON * (fabs(m->kinetic) + barrier_most(&c->geometry)) + 2 * m->barrier_error;
}

KERNEL real margin_finest(const struct margin_context *c)
{
    return fmin(c->geometry.tol, 4 * REAL_EPSILON);
}

KERNEL struct margin margin_within(struct margin_context *c, real r, real tol)
{
    struct margin m = {.kinetic = REAL_NAN};
    c->how = MARGIN_SURE;
    if (margin_to(c, r, fmax(tol, margin_finest(c)), &m) == DOM_NOT_CONVERGED)
        margin_to(c, r, c->geometry.tol, &m);
    return m;
}

#define MARGIN_ROUGH ((real)1e-3)

KERNEL struct margin margin_sign(struct margin_context *c, real r, bool bound)
{
    struct margin m = {.kinetic = REAL_NAN};
    real tol = fmax(MARGIN_ROUGH, c->geometry.tol);
    c->how = bound && c->geometry.conservative ? MARGIN_SIGN : MARGIN_SURE;
    for (;; tol = fmax(tol * MARGIN_ROUGH, margin_finest(c))) {
        struct margin finer = {.kinetic = REAL_NAN};
        const enum dom_status status = margin_to(c, r, tol, &finer);
        /* if the arithmetic allows no finer tolerance, keep the last result */
        if (status == DOM_NOT_CONVERGED && !isnan(m.kinetic)) {
            c->status = DOM_OK;
            return m;
        }
        m = finer;
        if (status != DOM_OK || tol <= margin_finest(c) || fabs(margin_value(&m)) > margin_error(c, &m, tol))
            return m;
        c->how = tol <= c->geometry.tol ? MARGIN_SURE : c->how;
    }
}

/* ---- Its roots ---- */

/*
 * margin_follow returns margin_share at r, for the next step of a root search. Without losses, it follows one
 * maximum of H from growth to growth by Newton's method, and computes only as many digits as this step needs.
 * This takes a third of the time of a search for the barrier at each growth. Call margin_follow_begin before
 * the first call, with an estimate of margin_share there.
 */
static void margin_follow_begin(struct margin_context *c, real share)
{
    c->how = c->geometry.conservative ? MARGIN_FOLLOW : MARGIN_SURE;
    c->share = share;
}

static real margin_follow(real r, void *context)
{
    struct margin_context *c = context;
    struct margin m = {0};
    real tol = c->geometry.tol, next = fmax(tol, MARGIN_ROUGH * c->share * c->share), rough, share;
    do {
        rough = next;
        if (margin_to(c, r, rough, &m) != DOM_OK)
            return REAL_NAN;
        share = margin_share(&m);
        next = fmax(tol, MARGIN_ROUGH * share * share);
    } while (rough > tol && fabs(share) < 8 * rough);
    c->followed_value = margin_value(&m);
    c->followed_tol = rough;
    if (fabs(share) <= fmax(tol / 64, 4 * REAL_EPSILON)) /* finer sums could not show the sign either */
        share = 0;
    if (fabs(share) <= c->share) {
        c->share = fabs(share);
        c->nearest = c->barrier;
    }
    return share;
}

/* Returns true if the maximum of H that margin_follow has tracked is the highest maximum at the root r. */
static bool margin_highest(const struct margin_context *c, real r)
{
    struct geometry geometry = c->geometry;
    struct barrier b = c->nearest;
    if (geometry_set(&geometry, c->s, r) != DOM_OK)
        return false;
    return barrier_tops(&geometry, &b) == DOM_OK &&
           b.height <= c->nearest.height * (1 + fmax(geometry.tol, 4 * REAL_EPSILON));
}

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
