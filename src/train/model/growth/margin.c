/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dynamics/dynamics.h"
#include "geometry/far.h"
#include "growth/limit.h"

/* The series for the far tail is built once for each growth. About this many passes then use it. */
#define FAR_PASSES 2

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
    real sine, cosine;
    geometry_tips(geometry, &sine, &cosine);
    two.n = 1; /* the domino that hits has no followers */
    real J = geometry_inertia(geometry, geometry->c);
    real k = geometry->inertia * J, inertia_ratio = 0;
    enum dom_status status = dynamics_inertia_ratio(geometry, &two, geometry->c, J, &inertia_ratio);
    if (status != DOM_OK)
        return status;
    real share = collision_velocity_ratio(inertia_ratio); /* (15; b11) */
    real tipped = 0;
    if (!losses_end_alone(geometry) && sine > 0) {
        status = losses_tipped(geometry, &tipped);
        geometry->flow->solution.panels = 0; /* the flow is needed for the pair */
    } else
        tipped = geometry_tipped_omegasq(geometry);
    if (status != DOM_OK)
        return status;
    real kinetic = (geometry->upright_inertia + k) * geometry->r * tipped * share * share;
    *m = (struct margin){.kinetic = sine > 0 ? kinetic : 0};
    two.n = c->dominoes;
    return margin_barrier(&two, c, m);
}

KERNEL struct margin_context margin_of_train(const struct request *train)
{
    struct margin_context c = {.train = train,
                               .s = (real)train->s,
                               .near = (real)train->near,
                               .dominoes = CHAIN_ENDLESS,
                               .margin = train_margin};
    c.status = dynamics_read(train, &c.geometry);
    if (c.status == DOM_OK && train->fuel == DOM_FUEL_PAPER && !energy_paper_holds(&c.geometry))
        c.status = DOM_NO_METHOD;
    return c;
}

KERNEL struct margin_context margin_of_pair(const struct request *train)
{
    struct margin_context c = margin_of_train(train);
    /* the pair does not depend on the fuel formula */
    c.status = c.status == DOM_NO_METHOD ? DOM_OK : c.status;
    c.dominoes = 2;
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
    if (c->status == DOM_OK && c->dominoes == CHAIN_ENDLESS && geometry.conservative)
        far_make(&geometry, c->how == MARGIN_SIGN ? 1 : FAR_PASSES);
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

KERNEL void margin_follow_begin(struct margin_context *c, real share)
{
    c->how = c->geometry.conservative ? MARGIN_FOLLOW : MARGIN_SURE;
    c->share = share;
}

KERNEL real margin_follow(real r, void *context)
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

KERNEL bool margin_highest(const struct margin_context *c, real r)
{
    struct geometry geometry = c->geometry;
    struct barrier b = c->nearest;
    if (geometry_set(&geometry, c->s, r) != DOM_OK)
        return false;
    geometry.n = c->dominoes;
    return barrier_tops(&geometry, &b) == DOM_OK &&
           b.height <= c->nearest.height * (1 + fmax(geometry.tol, 4 * REAL_EPSILON));
}
