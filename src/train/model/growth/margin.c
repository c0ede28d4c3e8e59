/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The margin K - B of a train or of a pair, and a root of it. */
#include "dynamics/dynamics.h"
#include "growth/limit.h"

/* Finds the barrier. Only the last steps of a root search need a fine tolerance. */
static enum dom_status margin_barrier(const struct geometry *geometry, struct growth *g, enum margin_how how,
                                      struct margin *m)
{
    struct barrier *b = &g->barrier;
    const real most = barrier_most(geometry), sure = 4 * geometry->tol;
    if (how == MARGIN_SIGN && geometry->conservative && m->kinetic * (1 - sure) > most) {
        m->barrier = most;
        m->is_bound = true;
        return DOM_OK;
    }
    if (how != MARGIN_SURE && m->kinetic < 0) /* the margin is negative, whatever the barrier is */
        return DOM_OK;
    enum dom_status status = DOM_NOT_CONVERGED;
    if (how != MARGIN_SURE && geometry->conservative) {
        const bool rough = how == MARGIN_FOLLOW && geometry->tol > g->geometry.tol,
                   top = barrier_follow(geometry, rough ? TOP_TOL_ROUGH(geometry) : TOP_TOL(geometry), b);
        m->barrier = fmax(b->height, 0); /* H(theta) - H(0) is 0 at the start */
        if (how == MARGIN_FOLLOW || (top && m->kinetic < b->height * (1 - sure)))
            return top ? DOM_OK : DOM_NOT_CONVERGED;
        if (top)
            status = barrier_search(geometry, true, TOP_TOL(geometry), b);
    }
    if (status != DOM_OK)
        /* With losses, Newton's method is not available. The error of the tilt then affects the barrier to
         * second order instead of third order, so the tilt needs a finer tolerance. */
        status = barrier_search(geometry, false,
                                geometry->conservative ? TOP_TOL(geometry) : geometry->tol / 8, b);
    m->barrier_error = status == DOM_OK ? flow_required_error(geometry) : 0;
    m->barrier = b->height;
    return status;
}

/* Finds K of a train by equation (26; c8), corrected: the kinetic energy has the factor J(0). */
static enum dom_status train_kinetic(const struct geometry *geometry, enum dom_fuel fuel, real *kinetic)
{
    struct launch launch = {.kinetic = REAL_NAN};
    /* At r = 1 both fuel formulas agree, and the closed form is faster. */
    if (geometry->r == 1 && geometry->conservative && geometry_paper_fuel(geometry) <= 0)
        return DOM_NO_FUEL;
    const enum dom_status status = dynamics_launch(geometry, fuel, &launch);
    *kinetic = launch.kinetic;
    return status == DOM_OK && geometry->r == 1 && launch.fuel <= 0 ? DOM_NO_FUEL : status;
}

/* Finds K of a pair by equation (17; b13). */
static enum dom_status pair_kinetic(const struct geometry *geometry, real *kinetic)
{
    struct geometry one = *geometry;
    one.n = 1; /* the domino that hits has no followers */
    real J = geometry_inertia(geometry, geometry->c);
    real k = geometry->inertia * J, inertia_ratio = 0, tipped = 0;
    enum dom_status status = dynamics_inertia_ratio(geometry, &one, geometry->c, J, &inertia_ratio);
    if (status == DOM_OK)
        status = dynamics_tipped(geometry, &tipped);
    geometry->flow->solution.panels = 0;                        /* the flow is needed for the pair */
    const real share = collision_velocity_ratio(inertia_ratio); /* (15; b11) */
    *kinetic = (geometry->upright_inertia + k) * geometry->r * tipped * share * share;
    return status;
}

KERNEL void growth_begin(const struct dom_train *train, const struct dom_compute *compute, bool pair,
                         real near, struct growth *g)
{
    struct dom_train checked = *train;
    checked.r = 1; /* the search chooses r, so train->r need not be valid */
    *g = (struct growth){.train = train, .s = (real)train->s, .near = near};
    g->status = train_check(&checked, compute);
    if (g->status == DOM_OK)
        g->status = dynamics_read(train, compute, &g->geometry);
    if (pair)
        g->geometry.n = 2; /* H is then that of equation (16; b12) */
    /* the pair does not depend on the fuel formula */
    if (g->status == DOM_OK && !pair && train->fuel == DOM_FUEL_PAPER && !dynamics_paper_holds(&g->geometry))
        g->status = DOM_NO_METHOD;
    g->geometry.effort = &g->effort;
    /* The maximum number of visits to dominoes. In double, they take a second or two. */
    g->geometry.effort_most = g->geometry.rolls ? 7000000 : 60000000;
}

static enum dom_status margin_find(struct growth *g, enum margin_how how, real r, real tol, struct margin *m)
{
    struct geometry geometry = g->geometry;
    struct flow flow = {.tol = 0};
    const bool pair = geometry.n == 2;
    geometry.flow = &flow;
    geometry.tol = tol;
    *m = (struct margin){.r = r, .tol = tol};
    g->status = geometry_set(&geometry, g->s, r);
    if (g->status == DOM_OK)
        far_make(&geometry, how == MARGIN_SIGN ? 1 : 2);
    if (g->status == DOM_OK)
        g->status = pair ? pair_kinetic(&geometry, &m->kinetic)
                         : train_kinetic(&geometry, g->train->fuel, &m->kinetic);
    if (g->status == DOM_OK)
        g->status = margin_barrier(&geometry, g, how, m);
    num_linear_free(&flow.solution);
    g->locked = g->status == DOM_LOCKS;
    /* If a train locks, its energy tends to 0, so the train stops. The margin is then negative. Its size does
     * not matter. */
    if (g->locked) {
        g->status = DOM_OK;
        *m = (struct margin){.r = r, .tol = tol, .kinetic = -1};
    }
    if (g->status != DOM_OK)
        m->kinetic = REAL_NAN;
    return g->status;
}

KERNEL real margin_error(const struct growth *g, const struct margin *m, real tol)
{
    /* near a root, |K| + barrier_most is of the size of the terms whose difference the margin is */
    return 4 * tol * (fabs(m->kinetic) + m->barrier) +
           16 * REAL_EPSILON * (fabs(m->kinetic) + barrier_most(&g->geometry)) + 2 * m->barrier_error;
}

KERNEL real margin_finest(const struct growth *g)
{
    return fmin(g->geometry.tol, 4 * REAL_EPSILON);
}

KERNEL struct margin margin_within(struct growth *g, real r, real tol)
{
    struct margin m;
    if (margin_find(g, MARGIN_SURE, r, fmax(tol, margin_finest(g)), &m) == DOM_NOT_CONVERGED)
        margin_find(g, MARGIN_SURE, r, g->geometry.tol, &m);
    return m;
}

KERNEL struct margin margin_signed(struct growth *g, enum margin_how how, real r, real tol)
{
    const real finest = how == MARGIN_FOLLOW ? g->geometry.tol : margin_finest(g);
    struct margin m = {.kinetic = REAL_NAN};
    for (tol = fmax(tol, g->geometry.tol);; tol = fmax(tol * MARGIN_ROUGH, finest)) {
        struct margin finer;
        const enum dom_status status = margin_find(g, how, r, tol, &finer);
        /* if the arithmetic allows no finer tolerance, keep the last result */
        if (status == DOM_NOT_CONVERGED && !isnan(m.kinetic)) {
            g->status = DOM_OK;
            return m;
        }
        m = finer;
        if (status != DOM_OK || tol <= finest || fabs(margin_value(&m)) > margin_error(g, &m, tol))
            return m;
        how = tol <= g->geometry.tol ? MARGIN_SURE : how;
    }
}

/* ---- Its roots ---- */

/* Returns (K - B) / (|K| + B), a number between -1 and 1. */
static real margin_share(const struct margin *m)
{
    return margin_value(m) / (fabs(m->kinetic) + m->barrier + REAL_MIN);
}

/* Returns true if the maximum of H that the search has followed to the root r is the highest maximum. */
static bool margin_highest(const struct growth *g, real r)
{
    struct geometry geometry = g->geometry;
    struct barrier b = g->barrier;
    if (!geometry.conservative) /* then no maximum was followed */
        return true;
    if (geometry_set(&geometry, g->s, r) != DOM_OK)
        return false;
    return barrier_search(&geometry, true, TOP_TOL(&geometry), &b) == DOM_OK &&
           b.height <= g->barrier.height * (1 + fmax(geometry.tol, 4 * REAL_EPSILON));
}

/* Returns how far the root of the line through two margins is from b->r. The line is one in the variable x
 * = -sqrt(1 - r/reach), of which the margin is a smooth function. */
static real root_line(const struct growth *g, const struct margin *a, const struct margin *b)
{
    /* Close to the root, margin_share is less curved than the margin. Far from the root, margin_share is
     * almost constant, so the line goes through values of the margin. */
    const real reach = g->geometry.span / g->s, x_a = x_of(g, a->r), x_b = x_of(g, b->r);
    real f_a = margin_share(a), f_b = margin_share(b);
    if (fabs(f_a) + fabs(f_b) >= 1) {
        f_a = margin_value(a);
        f_b = margin_value(b);
    }
    const real by = f_b / (f_b - f_a) * (b->r - a->r) / (reach * (x_a + x_b)); /* x of the root - x_b */
    return -reach * by * (2 * x_b + by);
}

enum { ROOT_STEPS = 12 };

/*
 * Finds a root between the growths lo and hi, beginning with the margins a and b. Follows one maximum of H
 * from growth to growth. Returns false if it does not find a root.
 *
 * The method is the secant method: the next growth is the root of the line through the last two margins. Near
 * the root it is inverse interpolation through the last three margins, by Neville's scheme: the roots of the
 * last two lines are extrapolated to a margin of 0, which moves the root of the last line by `bend`. Then the
 * next margin is about as small as the cube of the one before, so it is only computed to that tolerance.
 *
 * The search ends where the root of the line is precise enough by itself. The error of the margin before
 * changes the slope of the line, and thus the last step, by the fraction tol / |margin|.
 */
static bool root_secant(struct growth *g, const struct margin *a, const struct margin *b, real lo, real hi,
                        struct limit *limit)
{
    struct margin at[3] = {[1] = *a, [2] = *b};
    const real tol = g->geometry.tol;
    real next = b->r + root_line(g, a, b);
    for (int k = 0; k < ROOT_STEPS; k++) {
        if (!(next > lo && next < hi))
            next = (lo + hi) / 2;
        at[0] = at[1];
        at[1] = at[2];
        const real before = margin_share(&at[1]), r = next;
        at[2] = margin_signed(g, MARGIN_FOLLOW, next, MARGIN_ROUGH * fabs(before * before * before));
        if (g->status != DOM_OK)
            return false;
        const real f = margin_share(&at[2]), far = margin_share(&at[0]);
        *(f > 0 ? &lo : &hi) = r;
        real bend = (real)INFINITY; /* how far the root of the line is from the root */
        next = r + root_line(g, &at[1], &at[2]);
        if (fabs(f) < fabs(before) / 2 && fabs(f) < fabs(far) && fabs(before) + fabs(far) < 1) {
            bend = (next - at[1].r - root_line(g, &at[0], &at[1])) * f / (far - f);
            next += bend;
        }
        /* With losses no maximum of H is followed, so the margin may have a kink. Where the line bends as
         * much as at a kink, it has to end closer to the root. */
        const real kink = g->geometry.conservative ? 0 : f / (before - f) * (next - r);
        if (fabs(bend) <= tol / 16 * r && fabs(kink) <= tol / 16 * r && at[2].tol <= tol &&
            fabs(next - r) * at[1].tol <= tol / 16 * r * fabs(before)) {
            limit->r_max = next;
            limit->barrier = g->barrier.height;
            limit->beside = at[1];
            return true;
        }
    }
    return false;
}

static real margin_at(real r, void *context)
{
    struct growth *g = context;
    const struct margin m = margin_within(g, r, g->geometry.tol);
    return margin_value(&m);
}

KERNEL enum dom_status root_between(struct growth *g, const struct margin *lo, const struct margin *hi,
                                    bool follow, struct limit *limit)
{
    const bool nearer = fabs(margin_share(hi)) < fabs(margin_share(lo));
    g->hard = follow && !(root_secant(g, nearer ? lo : hi, nearer ? hi : lo, lo->r, hi->r, limit) &&
                          margin_highest(g, limit->r_max));
    if (follow && !g->hard)
        return DOM_OK;
    if (growth_ends(g->status))
        return g->status;
    g->status = DOM_OK;
    const enum num_status solver = num_root_between(margin_at, g, lo->r, margin_value(lo), hi->r,
                                                    margin_value(hi), g->geometry.tol / 8, &limit->r_max);
    limit->barrier = g->barrier.height;
    if (g->status == DOM_OK && solver == NUM_OK) {
        const real step = fmin(cbrt(REAL_EPSILON) / 8 * limit->r_max, (limit->r_max - lo->r) / 2);
        limit->beside = margin_within(g, limit->r_max - step, 0);
    }
    return model_status(g->status, solver);
}

/* Ends a search that began beside a root. It may have failed, but then another search follows. */
static bool root_sure(struct growth *g, bool found, const struct limit *limit)
{
    const bool highest = found && margin_highest(g, limit->r_max);
    if (!growth_ends(g->status))
        g->status = DOM_OK;
    return highest && g->status == DOM_OK;
}

/* Estimates the root by a fitted formula. For ordinary dominoes, the logarithm of the estimate is correct to
 * a few percent. Also estimates the slope at the root: minus the derivative of the margin with respect to
 * ln r. */
static real root_guess(const struct growth *g, real *slope)
{
    /* A rounded domino has nearly the same r_max as a sharp one with the proportions of its flat part. */
    const real flat = g->geometry.rounded.wide / g->geometry.rounded.tall, d = fmin(flat, (real)0.35),
               q = g->geometry.q, s = g->s / (1 - g->geometry.rounded.rho);
    /* With sharp edges on a level floor, equal dominoes have fuel only if u is positive. */
    const real u = fmax(s / flat - 2 * flat * flat / (1 - flat * flat), 0), x = fmin(log(u + (real)0.1), 2);
    const real share = (real)1.132 - (real)0.886 * d +
                       x * ((real)0.072 - (real)0.043 * d - (real)0.0244 * (q - (real)3.5) -
                            x * ((real)0.0701 + (real)0.0195 * x));
    const real room = fmax(u, (real)0.1);
    *slope = barrier_most(&g->geometry) * fmax(q - (real)1.2, (real)0.5) * (1 + 1 / (room * room));
    return exp((real)2.4 / (q - (real)0.6) * share * log1p((real)0.4 * u));
}

KERNEL bool root_guessed(struct growth *g, real from, struct limit *limit)
{
    real slope;
    const real r = root_guess(g, &slope), reach = g->geometry.span / g->s;
    struct limit root = *limit;
    if (!(r > from && r < reach))
        return false;
    const struct margin at = margin_signed(g, MARGIN_FOLLOW, r, MARGIN_ROUGH);
    /* a margin that would make the line fall by `slope` */
    const struct margin aside = {
        .r = r * exp(margin_value(&at) / slope), .kinetic = at.barrier, .barrier = at.barrier, .tol = at.tol};
    const bool found = g->status == DOM_OK && root_secant(g, &aside, &at, from, reach, &root);
    /* Near the bottom of a shallow dip, the search may end where there is no root. */
    const struct margin top = {.kinetic = root.barrier, .barrier = root.barrier};
    const real error = fmax(g->geometry.tol * root.barrier, margin_error(g, &top, margin_finest(g))),
               falls = margin_value(&root.beside) / (root.r_max - root.beside.r);
    if (!root_sure(g, found && falls * root.r_max > 100 * sqrt(error * root.barrier), &root))
        return false;
    *limit = root;
    return true;
}

/* The root that a coarser kernel has found is correct to about ROOT_NEAR. A margin with a few digits at the
 * relative distance ROOT_ASIDE gives the slope there. */
#define ROOT_NEAR  ((real)1e-10)
#define ROOT_ASIDE ((real)1e-5)

KERNEL bool root_near(struct growth *g, struct limit *limit)
{
    const real near = g->near, width = ROOT_NEAR * near, tol = g->geometry.tol;
    g->geometry.tol = fmin(tol, ROOT_ASIDE * ROOT_NEAR); /* a coarser margin tells nothing so close */
    const struct margin aside = margin_signed(g, MARGIN_FOLLOW, near * (1 - ROOT_ASIDE), 0);
    const struct margin at = g->status == DOM_OK ? margin_signed(g, MARGIN_FOLLOW, near, 0) : aside;
    const bool found = g->status == DOM_OK && root_secant(g, &aside, &at, near - width, near + width, limit);
    const bool sure = root_sure(g, found, limit);
    g->geometry.tol = tol;
    return sure;
}
