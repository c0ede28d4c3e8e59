/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The barrier is a global maximum: H may fall first and rise later, when a pushing follower has left.
 * H and H' are continuous, H'' jumps where a domino falls off; so each smooth piece of the cycle is
 * scanned for sign changes of H', and every maximum found is compared.
 */
#include "barrier.h"
#include <float.h>

/*
 * Over 50,000 random trains (s, d, q, r log-uniform) 16 samples a piece found the barrier that 600 found;
 * tests/unit/barrier.c repeats the comparison.
 */
#define BARRIER_SAMPLES 16

struct slope_context {
    const struct lean *lean;
    size_t n;
    enum dom_status status;
};

static double slope_of_H(double theta, void *context)
{
    struct slope_context *c = context;
    struct tilt head;
    struct sums sums = {0};
    c->status = lean_tilt(c->lean, theta, &head);
    if (c->status == DOM_OK)
        c->status = chain_sum(c->lean, head, c->n, &sums);
    return c->status == DOM_OK ? sums.H1 : DOM_NAN;
}

/* Keeps theta as theta_m if H is higher there. */
static enum dom_status barrier_try(const struct slope_context *c, double theta, struct barrier *b)
{
    struct tilt head;
    struct sums sums = {0};
    enum dom_status status = lean_tilt(c->lean, theta, &head);
    if (status == DOM_OK)
        status = chain_rise(c->lean, head, c->n, &sums);
    if (status == DOM_OK && sums.dH > b->height) {
        b->height = sums.dH;
        b->theta_m = theta;
    }
    return status;
}

/* All maxima of H inside one smooth piece. */
static enum dom_status barrier_scan(struct slope_context *c, double lo, double hi, struct barrier *b)
{
    double left = lo, slope_left = slope_of_H(lo, c);
    for (int k = 1; k <= BARRIER_SAMPLES && c->status == DOM_OK; k++) {
        /* Chebyshev spacing: the structure sits near the ends, where dominoes leave. */
        double u = 0.5 * (1 - cos(3.14159265358979323846 * k / BARRIER_SAMPLES));
        double right = k < BARRIER_SAMPLES ? lo + u * (hi - lo) : hi, slope_right = slope_of_H(right, c);
        if (slope_left > 0 && slope_right <= 0) {
            double top;
            enum num_status status = num_root(slope_of_H, c, left, right, c->lean->tol / 8, &top);
            c->status = model_status(c->status, status);
            if (c->status == DOM_OK)
                c->status = barrier_try(c, top, b);
        }
        left = right;
        slope_left = slope_right;
    }
    if (c->status == DOM_OK && slope_left > 0)
        c->status = barrier_try(c, hi, b); /* H still rises at the end of the piece */
    return c->status;
}

enum dom_status barrier_search(const struct lean *g, size_t n, double end, struct barrier *barrier)
{
    struct barrier b = {.theta_m = 0, .height = 0, .edge = {0}, .edges = 1};
    /* At r s = 1 the follower is gone for every theta > 0: H' jumps at 0, and its right limit counts. */
    if (g->short_of == 0)
        b.edge[0] = fmin(DBL_MIN, end);
    bool leaves;
    struct tilt leave;
    enum dom_status status = chain_leave(g, n, &leaves, &leave);
    double theta_leave = leaves ? tilt_angle(leave) : 0;
    if (theta_leave > b.edge[0] && theta_leave < end)
        b.edge[b.edges++] = theta_leave;
    b.edge[b.edges++] = end;
    struct slope_context c = {.lean = g, .n = n};
    for (int i = 1; status == DOM_OK && i < b.edges; i++)
        status = barrier_scan(&c, b.edge[i - 1], b.edge[i], &b);
    if (status == DOM_OK)
        *barrier = b;
    return status;
}

enum dom_status dom_barrier_find(const struct dom_train *train, struct dom_barrier *barrier)
{
    struct lean g;
    struct barrier b;
    struct dom_launch launch;
    enum dom_status status = lean_make(train, &g);
    if (status == DOM_OK)
        status = barrier_search(&g, CHAIN_ENDLESS, tilt_angle(g.c), &b);
    if (status == DOM_OK)
        status = collision_launch(&g, train->fuel, &launch);
    if (status != DOM_OK)
        return status;
    bool fuelled = launch.fuel > 0;
    *barrier = (struct dom_barrier){
        .theta_m = b.theta_m,
        .barrier = b.height,
        .kinetic = fuelled ? launch.kinetic : DOM_NAN,
        .margin = fuelled ? launch.kinetic - b.height : DOM_NAN,
    };
    return !fuelled ? DOM_NO_FUEL : barrier->margin >= 0 ? DOM_OK : DOM_STOPS;
}
