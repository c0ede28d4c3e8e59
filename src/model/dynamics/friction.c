/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dynamics/friction.h"

KERNEL void lean_flow(struct lean *g, struct flow *flow)
{
    g->flow = flow;
    if (g->mu > 0)
        flow->solution.panels = 0;
}

static void friction_count(const struct lean *g, size_t n)
{
    chain_count(g, n);
    if (g->work)
        g->work->entered[DOM_EFFECT_friction]++;
}

/* One domino, its S_i, and theta_i''. */
struct rubbing {
    struct link link;
    real S, bend;
};

static void rubbing_next(struct rubbing *k)
{
    struct link leader = k->link;
    k->S *= torque_ratio(&k->link);
    link_next(&k->link);
    k->bend = link_bend(&leader, k->bend, &k->link);
}

static void drive_add(const struct rubbing *k, struct series *C)
{
    const struct link *link = &k->link;
    series_add(C, link->weight * k->S * (link->tilt.x - link->lean->d * link->tilt.y) / 2);
}

/*
 * Is C known to a tolerance, and are all three sums?  Far down, dominoes pass on no more than near the end of
 * an endless train.
 */
static bool drive_done(const struct rubbing *k, struct series *C, real tol)
{
    const struct lean *g = k->link.lean;
    real ratio = fmax(g->weight * fabs(torque_ratio(&k->link)), g->decay);
    return series_done(C, k->link.weight * fabs(k->S) * g->reach, ratio, tol);
}

static bool rubbing_done(const struct rubbing *k, struct series *A, struct series *B, struct series *C)
{
    const struct link *link = &k->link;
    const struct lean *g = link->lean;
    real S = fabs(k->S), Y = link->turn.Y, bends = g->r * g->L / (Y * Y) * link->slope * link->slope;
    real ratio = fmax(g->inertia * fabs(torque_ratio(link)), fmax(g->decay, g->decay_J));
    return drive_done(k, C, g->tol) && series_done(A, link->inertia * S * link->slope, ratio, g->tol) &&
           series_done(B, link->inertia * S * (fabs(k->bend) + bends), ratio, g->tol);
}

KERNEL enum dom_status friction_law(const struct lean *g, struct tilt head, struct law *law)
{
    struct series A = {0}, B = {0}, C = {0};
    struct rubbing k = {.link = link_head(g, head), .S = 1};
    for (;;) {
        const struct link *link = &k.link;
        enum dom_status status = chain_watch(g, link->i);
        if (status != DOM_OK)
            return status;
        series_add(&A, link->inertia * k.S * link->slope);
        series_add(&B, link->inertia * k.S * k.bend);
        drive_add(&k, &C);
        if (link->i + 1 >= g->n || !link->leads || rubbing_done(&k, &A, &B, &C))
            break;
        rubbing_next(&k);
    }
    friction_count(g, k.link.i + 1);
    *law = (struct law){A.sum + A.lost, B.sum + B.lost, C.sum + C.lost, B.size, C.size};
    return isfinite(law->A) && isfinite(law->B) && isfinite(law->C) ? DOM_OK : DOM_NOT_FINITE;
}

KERNEL enum dom_status friction_drive(const struct lean *g, struct tilt head, real tol, real *drive)
{
    struct series C = {0};
    struct rubbing k = {.link = link_head(g, head), .S = 1};
    for (;;) {
        enum dom_status status = chain_watch(g, k.link.i);
        if (status != DOM_OK)
            return status;
        drive_add(&k, &C);
        if (k.link.i + 1 >= g->n || !k.link.leads || drive_done(&k, &C, tol))
            break;
        k.S *= torque_ratio(&k.link);
        link_next(&k.link);
    }
    friction_count(g, k.link.i + 1);
    *drive = C.sum + C.lost;
    return isfinite(*drive) ? DOM_OK : DOM_NOT_FINITE;
}

struct flow_context {
    const struct lean *lean;
    enum dom_status status;
};

/* dw/dtheta = -2 B / A w + 2 C / A. */
static bool flow_rate(real theta, void *context, struct num_rate *rate)
{
    struct flow_context *f = context;
    struct tilt head;
    struct law law;
    f->status = lean_tilt(f->lean, theta, &head);
    if (f->status == DOM_OK)
        f->status = friction_law(f->lean, head, &law);
    /* With A <= 0 no acceleration fits the forces (Painleve): the train is locked. */
    if (f->status == DOM_OK && law.A <= 0)
        f->status = DOM_LOCKS;
    if (f->status != DOM_OK)
        return false;
    const real units = 32 * UNIT / law.A;
    *rate = (struct num_rate){-2 * law.B / law.A, 2 * law.C / law.A, units * law.B_size, units * law.C_size};
    return true;
}

/* The hitting train has all but the head, which stands upright. */
static enum dom_status flow_collision(const struct lean *g, struct flow *flow)
{
    struct law at_c;
    struct sums sums;
    struct lean hitting = *g;
    struct link upright = link_head(g, standing);
    hitting.n = g->n == CHAIN_ENDLESS ? CHAIN_ENDLESS : g->n - 1;
    enum dom_status status = contact_arm_a(&upright) > 0 ? friction_law(&hitting, g->c, &at_c) : DOM_LOCKS;
    if (status == DOM_OK)
        status = chain_sum(&hitting, g->c, &sums);
    if (status != DOM_OK)
        return status;
    flow->T = g->inertia * torque_ratio(&upright) * at_c.A;
    flow->J0 = 1 + g->inertia * sums.J;
    flow->J_c = sums.J;
    return flow->T > 0 ? DOM_OK : DOM_LOCKS;
}

/*
 * From upright on, u moves by d^2 up to theta ~ d, and by much more behind: it is told apart there on panels
 * of its own, and so it is near the tilt sqrt(1 - r s), where followers come down.
 */
static enum dom_status flow_finely(struct flow_context *c, real tol, real *lo, real hi)
{
    const struct lean *g = c->lean;
    real finest = g->short_of > 0 ? fmin(g->d, sqrt(g->short_of)) : g->d;
    for (real to = finest; *lo < to && to < hi / 8; to *= 8) {
        enum num_status solver = num_linear_solve(flow_rate, c, *lo, to, tol / 8, &g->flow->solution);
        if (solver != NUM_OK)
            return model_status(c->status, solver);
        *lo = to;
    }
    return DOM_OK;
}

/* Over the smooth parts between the edges. */
static enum dom_status flow_solve(const struct lean *fine, real tol, const real *edge, int edges)
{
    struct flow_context c = {.lean = fine};
    for (int i = 1; i < edges; i++) {
        real lo = edge[i - 1];
        enum dom_status status = lo <= REAL_MIN ? flow_finely(&c, tol, &lo, edge[i]) : DOM_OK;
        if (status != DOM_OK)
            return status;
        enum num_status solver = num_linear_solve(flow_rate, &c, lo, edge[i], tol / 8, &fine->flow->solution);
        if (solver != NUM_OK)
            return model_status(c.status, solver);
    }
    return DOM_OK;
}

/* To a series a sum that ends elsewhere is a jump: it must stay below what the series resolves. */
static struct lean flow_begin(const struct lean *g)
{
    struct lean fine = *g;
    fine.tol = fmax(g->tol / 64, 64 * REAL_EPSILON);
    g->flow->solution.panels = 0;
    g->flow->tol = g->tol;
    return fine;
}

KERNEL enum dom_status friction_flow(const struct lean *g)
{
    struct flow *flow = g->flow;
    if (flow->solution.panels > 0 && flow->tol <= g->tol)
        return DOM_OK;
    struct lean fine = flow_begin(g);
    real edge[CHAIN_EDGES];
    int edges;
    enum dom_status status = chain_edges(g, tilt_angle(g->c), edge, &edges);
    if (status != DOM_OK)
        return status;
    status = flow_collision(&fine, flow);
    return status == DOM_OK ? flow_solve(&fine, g->tol, edge, edges) : status;
}

KERNEL enum dom_status friction_flow_piece(const struct lean *g, real J0, real lo, real hi)
{
    struct lean fine = flow_begin(g);
    real edge[] = {lo, hi};
    g->flow->J0 = J0;
    return flow_solve(&fine, g->tol, edge, 2);
}

KERNEL void friction_at(const struct lean *g, real theta, real *ln_G, real *u)
{
    num_linear_at(&g->flow->solution, theta, ln_G, u);
    *u = -*u;
}

KERNEL real friction_climb(const struct lean *g, real theta)
{
    real ln_G, u;
    friction_at(g, theta, &ln_G, &u);
    return g->flow->J0 * u;
}

KERNEL real friction_omegasq(const struct lean *g, real omegasq_0, real theta)
{
    real ln_G, u;
    friction_at(g, theta, &ln_G, &u);
    return exp(ln_G) * (omegasq_0 - u);
}

KERNEL enum dom_status friction_rate(const struct lean *g, struct tilt head, real theta, real *rate)
{
    struct law law;
    real ln_G, u;
    enum dom_status status = friction_law(g, head, &law);
    friction_at(g, theta, &ln_G, &u);
    *rate = -2 * law.C / (law.A * exp(ln_G));
    return status;
}

KERNEL enum dom_status friction_flow_spent(const struct lean *g, struct tilt from, real lo, real omegasq,
                                           real *hi)
{
    real rate = 0, ln_G, u = -1;
    enum dom_status status = friction_rate(g, from, lo, &rate);
    if (status != DOM_OK || !(rate > 0))
        return status;
    for (real close = lo + 4 * omegasq / rate; close < *hi && close > lo; close = lo + 4 * (close - lo)) {
        status = friction_flow_piece(g, g->flow->J0, lo, close);
        if (status != DOM_OK)
            return status;
        friction_at(g, close, &ln_G, &u);
        if (u >= omegasq) {
            *hi = close;
            return DOM_OK;
        }
    }
    /* It goes on for long enough to be seen in the whole. */
    return u < 0 ? DOM_OK : friction_flow_piece(g, g->flow->J0, lo, *hi);
}
