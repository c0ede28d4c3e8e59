/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The barrier is a global maximum: H may fall first and rise later, when a pushing follower has left.
 * H and H' are continuous, H'' jumps where a domino falls off; so each smooth piece of the cycle is
 * scanned for sign changes of H', and every maximum found is compared.
 */
#include "barrier.h"

/*
 * Over 50,000 random trains (s, d, q, r log-uniform) 16 samples a piece found the barrier that 600 found;
 * tests/unit/test_barrier.c repeats the comparison.
 */
#define BARRIER_SAMPLES 16

struct slope_context {
    const struct lean *lean;
    struct tilt from; /* heights are over that of the train there */
    enum dom_status status;
};

/* With friction it is u that rises and falls: C in the place of -H'/2. */
static enum dom_status rubbing_slope(const struct lean *g, struct tilt head, real tol, real *slope)
{
    enum dom_status status = friction_drive(g, head, tol, slope);
    *slope *= -2;
    return status;
}

static real slope_of_H(real theta, void *context)
{
    struct slope_context *c = context;
    struct tilt head;
    struct sums sums = {0};
    c->status = lean_tilt(c->lean, theta, &head);
    if (c->status == DOM_OK && c->lean->mu > 0)
        c->status = rubbing_slope(c->lean, head, c->lean->tol, &sums.H1);
    else if (c->status == DOM_OK)
        c->status = chain_sum(c->lean, head, &sums);
    return c->status == DOM_OK ? sums.H1 : REAL_NAN;
}

/* Its sign, from as short a train as shows it. */
static real rises(real theta, struct slope_context *c)
{
    struct tilt head;
    real H1 = 0;
    c->status = lean_tilt(c->lean, theta, &head);
    if (c->status == DOM_OK)
        c->status = c->lean->mu > 0 ? rubbing_slope(c->lean, head, 1, &H1) : chain_sign(c->lean, head, &H1);
    return H1;
}

/* Keeps theta as theta_m if H is higher there. */
static enum dom_status barrier_try(const struct slope_context *c, real theta, struct barrier *b)
{
    struct tilt head;
    struct sums sums = {0};
    enum dom_status status = lean_tilt(c->lean, theta, &head);
    if (status == DOM_OK && c->lean->mu > 0)
        sums.dH = friction_climb(c->lean, theta);
    else if (status == DOM_OK)
        status = c->from.x > 0 ? chain_rise_from(c->lean, c->from, head, &sums)
                               : chain_rise(c->lean, head, &sums, NULL);
    if (status == DOM_OK && sums.dH > b->height) {
        b->height = sums.dH;
        b->theta_m = theta;
    }
    return status;
}

/* From sample to sample: a maximum of H lies between two where it rises and falls. */
struct sample {
    real theta, slope;
};

static void barrier_sample(struct slope_context *c, real theta, struct sample *last, struct barrier *b)
{
    if (c->status != DOM_OK)
        return;
    struct sample next = {theta, rises(theta, c)};
    if (c->status == DOM_OK && last->slope > 0 && next.slope <= 0) {
        real top;
        enum num_status status = num_root(slope_of_H, c, last->theta, theta, c->lean->tol / 8, &top);
        c->status = model_status(c->status, status);
        if (c->status == DOM_OK)
            c->status = barrier_try(c, top, b);
    }
    *last = next;
}

/*
 * All maxima of H inside one smooth piece.  Chebyshev spacing: the structure sits near the ends, where
 * dominoes leave; from upright on also at the tilts d and sqrt(1 - r s), however small they are.
 */
static enum dom_status barrier_scan(struct slope_context *c, real lo, real hi, bool upright,
                                    struct barrier *b)
{
    const struct lean *g = c->lean;
    struct sample last = {lo, rises(lo, c)};
    real first = (1 - cos(PI / BARRIER_SAMPLES)) / 2 * (hi - lo);
    real finest = g->short_of > 0 ? fmin(g->d, sqrt(g->short_of)) / 16 : g->d / 16;
    for (real theta = finest; upright && theta < first && theta > lo; theta *= 4)
        barrier_sample(c, lo + theta, &last, b);
    for (int k = 1; k <= BARRIER_SAMPLES; k++) {
        real u = (1 - cos(PI * (real)k / BARRIER_SAMPLES)) / 2;
        barrier_sample(c, k < BARRIER_SAMPLES ? lo + u * (hi - lo) : hi, &last, b);
    }
    if (c->status == DOM_OK && last.slope > 0)
        c->status = barrier_try(c, hi, b); /* H still rises at the end of the piece */
    return c->status;
}

KERNEL enum dom_status barrier_piece(const struct lean *g, struct tilt from, real lo, real hi,
                                     struct barrier *b)
{
    struct slope_context c = {.lean = g, .from = from};
    *b = (struct barrier){.theta_m = lo, .edge = {lo, hi}, .edges = 2};
    return barrier_scan(&c, lo, hi, lo == 0, b);
}

KERNEL enum dom_status barrier_search(const struct lean *g, real end, struct barrier *barrier)
{
    struct barrier b = {.theta_m = 0, .height = 0};
    enum dom_status status = chain_edges(g, end, b.edge, &b.edges);
    if (status == DOM_OK && g->mu > 0)
        status = friction_flow(g);
    if (status != DOM_OK)
        return status;
    struct slope_context c = {.lean = g};
    for (int i = 1; status == DOM_OK && i < b.edges; i++)
        status = barrier_scan(&c, b.edge[i - 1], b.edge[i], i == 1, &b);
    if (status == DOM_OK)
        *barrier = b;
    return status;
}

KERNEL real balance_tol(real tol, real left, real whole)
{
    return left > whole / 4 ? tol : fmin(tol, fmax(tol * left / whole, 4 * REAL_EPSILON));
}

KERNEL enum dom_status barrier_balance(struct lean *g, enum dom_fuel fuel, real end, struct launch *launch,
                                       struct launch *error, struct barrier *b)
{
    real asked;
    do {
        enum dom_status status = collision_launch(g, fuel, launch, error);
        if (status == DOM_OK)
            status = barrier_search(g, end, b);
        if (status != DOM_OK || launch->fuel <= 0)
            return status;
        asked = g->tol;
        g->tol = balance_tol(asked, fabs(launch->kinetic - b->height), launch->kinetic);
    } while (g->tol < asked / 4);
    return DOM_OK;
}

/* H''(theta) by a difference that stays inside the cycle; for error bounds its size is enough. */
static real curvature(struct slope_context *c, real theta, real end)
{
    real h = sqrt(REAL_EPSILON) * 64 * theta, lo = fmax(theta - h, 0), hi = fmin(theta + h, end);
    real below = slope_of_H(lo, c), above = c->status == DOM_OK ? slope_of_H(hi, c) : 0;
    return (above - below) / (hi - lo);
}

KERNEL enum dom_status barrier_error(const struct lean *g, const struct barrier *b, struct barrier *error)
{
    struct tilt head;
    struct sums at, e;
    struct slope_context c = {.lean = g};
    *error = (struct barrier){.theta_m = 0, .height = 0};
    if (g->mu > 0)
        error->theta_m = error->height = REAL_NAN;
    if (b->theta_m == 0 || g->mu > 0)
        return DOM_OK;
    enum dom_status status = lean_tilt(g, b->theta_m, &head);
    if (status == DOM_OK)
        status = chain_rise(g, head, &at, &e);
    real bend = status == DOM_OK ? fabs(curvature(&c, b->theta_m, b->edge[b->edges - 1])) : 0;
    if (status != DOM_OK || c.status != DOM_OK)
        return status != DOM_OK ? status : c.status;
    /* At an inner top H' vanishes; where it does not, the top is an end of a piece, known as an angle. */
    real off = (fabs(at.H1) + e.H1) / bend;
    bool inner = off < (real)0.01 * b->theta_m;
    error->theta_m = (inner ? 2 * off : 0) + 8 * UNIT * b->theta_m;
    error->height = e.dH + (fabs(at.H1) + bend * error->theta_m) * error->theta_m;
    return DOM_OK;
}

KERNEL enum dom_status barrier_find(const struct dom_train *train, struct dom_barrier *barrier,
                                    struct dom_barrier *error)
{
    struct lean g;
    struct barrier b, b_error;
    struct launch l, l_error;
    struct flow flow;
    enum dom_status status = lean_make(train, &g);
    if (status == DOM_OK)
        lean_flow(&g, &flow);
    if (status == DOM_OK)
        status = barrier_balance(&g, train->fuel, tilt_angle(g.c), &l, error ? &l_error : NULL, &b);
    if (status == DOM_OK && error)
        status = barrier_error(&g, &b, &b_error);
    if (status != DOM_OK)
        return status;
    bool fuelled = l.fuel > 0;
    real margin = l.kinetic - b.height;
    *barrier = (struct dom_barrier){
        .theta_m = b.theta_m,
        .barrier = b.height,
        .kinetic = fuelled ? l.kinetic : REAL_NAN,
        .margin = fuelled ? margin : REAL_NAN,
    };
    if (error)
        *error = (struct dom_barrier){
            .theta_m = b_error.theta_m,
            .barrier = b_error.height,
            .kinetic = l_error.kinetic,
            .margin = l_error.kinetic + b_error.height + UNIT * fabs(margin),
        };
    return !fuelled ? DOM_NO_FUEL : margin >= 0 ? DOM_OK : DOM_STOPS;
}
