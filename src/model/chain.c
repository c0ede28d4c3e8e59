/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "chain.h"
#include <float.h>

/* A pass of this many dominoes takes tens of milliseconds; at r = 1 only sqrt(s (s + 2 d)) < 2e-5 has more.
 */
#define LINKS_MAX ((size_t)2000000)

/* The tail of a sum may be this part of the tolerance, so that a result of several sums keeps it. */
#define TAIL_SHARE 0.125

static void link_lean(const struct lean *g, struct link *k)
{
    /* Upright is leaned on in any case: it has just been hit, even in the limit theta_leave = 0. */
    k->leads = !g->falls_off || k->tilt.v < g->leave.v || k->tilt.x == 0;
    if (k->leads) {
        k->turn = lean_turn(g, k->tilt);
        k->step = lean_slope(g, k->tilt, k->turn);
    }
}

struct link link_head(const struct lean *g, struct tilt head)
{
    struct link k = {.i = 0, .tilt = head, .slope = 1, .weight = 1, .inertia = 1};
    link_lean(g, &k);
    return k;
}

void link_next(const struct lean *g, struct link *k)
{
    k->i++;
    k->tilt = tilt_turn(k->tilt, k->turn);
    k->slope *= k->step;
    k->weight *= g->weight;
    k->inertia *= g->inertia;
    link_lean(g, k);
}

/* A sum with a bound on the terms that have not been added yet. */
struct series {
    double sum, size; /* of the terms, and of their absolute values */
};

static void series_add(struct series *s, double term)
{
    s->sum += term;
    s->size += fabs(term);
}

/*
 * Does the tail matter?  The next terms are at most `term` times ratio, ratio^2, ...; below the unit
 * roundoff of what was added no tolerance needs them.
 */
static bool series_done(const struct series *s, double term, double ratio, double tol)
{
    double tail = term * ratio;
    return tail <= (1 - ratio) * fmax(TAIL_SHARE * tol * fabs(s->sum), DBL_EPSILON / 4 * s->size);
}

/* Every few thousand dominoes: has somebody asked to stop, is the train too long? */
static enum dom_status chain_watch(const struct lean *g, size_t i)
{
    if (i % 4096 != 0)
        return DOM_OK;
    if (g->interrupt && *g->interrupt)
        return DOM_INTERRUPTED;
    return i < LINKS_MAX ? DOM_OK : DOM_TOO_LONG;
}

struct sum_state {
    struct series J, H1, dH;
};

static void sum_add(const struct lean *g, struct sum_state *a, const struct link *k)
{
    series_add(&a->J, k->inertia * k->slope * k->slope);
    series_add(&a->H1, k->weight * k->slope * (g->d * k->tilt.y - k->tilt.x));
}

static bool sum_done(const struct lean *g, const struct sum_state *a, const struct link *k)
{
    double J_ratio = g->inertia * k->step * k->step, H_ratio = fmax(g->weight * k->step, g->decay);
    return series_done(&a->J, k->inertia * k->slope * k->slope, J_ratio, g->tol) &&
           series_done(&a->H1, k->weight * k->slope * hypot(1, g->d), H_ratio, g->tol);
}

static enum dom_status sum_result(const struct sum_state *a, size_t n, struct sums *sums)
{
    *sums = (struct sums){.J = a->J.sum, .H1 = a->H1.sum, .dH = a->dH.sum, .n = n};
    return isfinite(sums->J) && isfinite(sums->H1) && isfinite(sums->dH) ? DOM_OK : DOM_NOT_FINITE;
}

enum dom_status chain_sum(const struct lean *g, struct tilt head, size_t n, struct sums *sums)
{
    struct sum_state a = {0};
    struct link k = link_head(g, head);
    for (;;) {
        enum dom_status status = chain_watch(g, k.i);
        if (status != DOM_OK)
            return status;
        sum_add(g, &a, &k);
        if (k.i + 1 >= n || !k.leads || sum_done(g, &a, &k))
            return sum_result(&a, k.i + 1, sums);
        link_next(g, &k);
    }
}

/*
 * h(A) - h(B) of one domino at the tilts a and b, h = cos + d sin, from t = tan((A - B)/2): the product
 * form of 2 sin((A-B)/2) (d cos((A+B)/2) - sin((A+B)/2)), free of cancellation.
 */
static double rise(const struct lean *g, struct tilt a, struct tilt b, double t)
{
    return t * (g->d * (a.y + b.y) - (a.x + b.x));
}

/*
 * Two chains run side by side: a from the head's tilt, b from upright.  With t = tan((theta_a - theta_b)/2)
 * of one domino, its follower has, exactly, t (1 - G) / (1 + t^2 G), G = r L (x_a + x_b) / (Y_a + Y_b),
 * because X_a - X_b = r L (y_a - y_b).  G is the slope's r L x / Y (b10) between the two tilts; so the
 * smallest differences keep their digits.
 */
enum dom_status chain_rise(const struct lean *g, struct tilt head, size_t n, struct sums *sums)
{
    struct sum_state state = {0};
    struct link a = link_head(g, head), b = link_head(g, (struct tilt){0, 1, 0});
    double t = head.x / (1 + head.y);
    for (;;) {
        enum dom_status status = chain_watch(g, a.i);
        if (status != DOM_OK)
            return status;
        sum_add(g, &state, &a);
        series_add(&state.dH, a.weight * rise(g, a.tilt, b.tilt, t));
        if (a.i + 1 >= n || !b.leads)
            break;
        if (!a.leads) {
            /* The follower has left during this cycle: it keeps the energy of theta_f. */
            link_next(g, &b);
            double sine = g->f.x * b.tilt.y - g->f.y * b.tilt.x;
            double t_f = sine / (1 + g->f.x * b.tilt.x + g->f.y * b.tilt.y);
            series_add(&state.dH, b.weight * rise(g, g->f, b.tilt, t_f));
            break;
        }
        double G = t == 0 ? 0 : g->r * g->L * (a.tilt.x + b.tilt.x) / (a.turn.Y + b.turn.Y);
        double ratio = fmax(g->weight * (1 - G), g->decay);
        if (series_done(&state.dH, a.weight * 2 * t * hypot(1, g->d), ratio, g->tol) &&
            sum_done(g, &state, &a))
            break;
        t *= (1 - G) / (1 + t * t * G);
        link_next(g, &a);
        link_next(g, &b);
    }
    return sum_result(&state, a.i + 1, sums);
}

enum dom_status chain_leave(const struct lean *g, size_t n, bool *leaves, struct tilt *head)
{
    *leaves = false;
    if (!g->falls_off)
        return DOM_OK;
    struct link b = link_head(g, (struct tilt){0, 1, 0});
    while (b.leads) {
        enum dom_status status = chain_watch(g, b.i);
        if (status != DOM_OK)
            return status;
        /* Whether a domino falls off that carries less than rounding changes nothing. */
        if (b.i + 1 >= n || b.weight * b.slope < DBL_EPSILON * DBL_EPSILON)
            return DOM_OK;
        link_next(g, &b);
    }
    /* Domino b.i has no follower at 0: it falls off when domino b.i - 1 comes to theta_leave. */
    *head = g->leave;
    for (size_t i = b.i; i > 1; i--)
        *head = lean_leader(g, *head);
    *leaves = true;
    return DOM_OK;
}

/* ---- Public ---- */

static struct dom_link link_public(const struct lean *g, const struct link *k)
{
    double b = k->leads ? k->turn.Y / g->r : DOM_NAN; /* (table 1) */
    return (struct dom_link){
        .i = k->i,
        .theta = tilt_angle(k->tilt),
        .slope = k->slope,
        .arm_a = b - g->L * k->tilt.x,
        .arm_b = b,
        .weight = k->weight,
    };
}

enum dom_status dom_chain_walk(const struct dom_train *train, double theta,
                               bool (*visit)(const struct dom_link *, void *), void *context)
{
    struct lean g;
    struct tilt head;
    enum dom_status status = lean_make_tilted(train, theta, &g, &head);
    if (status != DOM_OK)
        return status;
    struct sums sums = {0};
    status = chain_sum(&g, head, CHAIN_ENDLESS, &sums);
    if (status != DOM_OK)
        return status;
    struct link k = link_head(&g, head);
    for (;;) {
        struct dom_link link = link_public(&g, &k);
        if (!visit(&link, context) || !k.leads || k.i + 1 >= sums.n)
            return DOM_OK;
        link_next(&g, &k);
    }
}

enum dom_status dom_contact_find(const struct dom_train *train, double theta, struct dom_contact *contact)
{
    struct lean g;
    struct tilt head;
    enum dom_status status = lean_make_tilted(train, theta, &g, &head);
    if (status != DOM_OK)
        return status;
    struct link k = link_head(&g, head);
    struct dom_link link = link_public(&g, &k);
    *contact = (struct dom_contact){
        .theta_1 = tilt_angle(k.leads ? tilt_turn(head, k.turn) : g.f),
        .slope = k.leads ? k.step : 0,
        .arm_a = link.arm_a,
        .arm_b = link.arm_b,
    };
    return DOM_OK;
}
