/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The passes down a chain of dominoes with rounded edges; see rounded.h. No error bounds are known. */
#include "geometry/rounded.h"

KERNEL void rounded_count(const struct geometry *geometry)
{
    if (geometry->work)
        geometry->work->entered[DOM_EFFECT_edges]++;
}

static enum dom_status rolling_result(const struct geometry *geometry, const struct sum_state *a, real H2,
                                      size_t n, struct sums *sums)
{
    rounded_count(geometry);
    return sum_result(geometry, a, H2, n, sums);
}

static void roller_add_J(struct sum_state *a, const struct link *k)
{
    series_add(&a->J, k->inertia * k->slope * k->slope * geometry_inertia(k->geometry, k->tilt));
}

static void roller_add_H1(struct sum_state *a, const struct link *k)
{
    series_add(&a->H1, k->weight * k->slope * geometry_lift(k->geometry, k->tilt));
}

/* Return true when a tail can be left out. The inertia of a domino is at most that of a sharp one, so that
 * done_J holds. */
static bool rolling_done_H1(struct sum_state *a, const struct link *k, real tol)
{
    const struct geometry *geometry = k->geometry;
    return series_done(&a->H1, k->weight * k->slope * (geometry->reach + fabs(geometry->rounded.roll)),
                       fmax(geometry->weight * k->step, geometry->decay), tol);
}

KERNEL enum dom_status rolling_sum(const struct geometry *geometry, struct tilt head, bool sign,
                                   struct sums *sums)
{
    struct sum_state a = {0};
    struct roller k = roller_head(geometry, head);
    const real tol = sign ? (real)0.75 / TAIL_SHARE : geometry->tol;
    for (;;) {
        enum dom_status status = chain_watch(geometry, k.link.i);
        if (status != DOM_OK)
            return status;
        roller_add_J(&a, &k.link);
        roller_add_H1(&a, &k.link);
        if (k.link.i + 1 >= geometry->n || !k.link.leads ||
            ((sign || done_J(&a, &k.link)) && rolling_done_H1(&a, &k.link, tol)))
            return rolling_result(geometry, &a, 0, k.link.i + 1, sums);
        roller_next(&k);
    }
}

KERNEL enum dom_status rolling_rates(const struct geometry *geometry, struct tilt head, struct sums *sums,
                                     real *half_J1)
{
    struct sum_state a = {0};
    struct roller k = roller_head(geometry, head);
    *half_J1 = 0;
    for (;;) {
        const struct link *link = &k.link;
        enum dom_status status = chain_watch(geometry, link->i);
        if (status != DOM_OK)
            return status;
        roller_add_J(&a, link);
        roller_add_H1(&a, link);
        *half_J1 += link->inertia * link->slope *
                    (k.second_derivative * geometry_inertia(link->geometry, link->tilt) +
                     link->slope * link->slope * geometry_inertia_slope(link->geometry, link->tilt) / 2);
        if (link->i + 1 >= geometry->n || !link->leads ||
            (done_J(&a, link) && rolling_done_H1(&a, link, geometry->tol)))
            return rolling_result(geometry, &a, 0, link->i + 1, sums);
        roller_next(&k);
    }
}

/* ---- Differences ---- */

/* Returns tan(by / 2) for the tilts a and b, `by` apart. */
static real half_of_turn(struct tilt a, struct tilt b, real by)
{
    if (fabs(by) < (real)0.25)
        return tan(by / 2);
    return (a.x * b.y - a.y * b.x) / (1 + a.y * b.y + a.x * b.x);
}

/* Returns h(A) - h(B) of one domino, as energy_change in energy_change.c. */
static real rolling_rise(const struct geometry *geometry, struct tilt a, struct tilt b, real by)
{
    return half_of_turn(a, b, by) * (geometry->h.x * (a.y + b.y) - geometry->h.y * (a.x + b.x)) +
           geometry->rounded.roll * by;
}

KERNEL real rounded_fall(const struct geometry *geometry, struct tilt t)
{
    return -rolling_rise(geometry, t, standing, tilt_angle(t));
}

/*
 * Returns the difference of the tilts of two followers whose leaders are `by` apart. The difference D of the
 * two turns obeys the difference of two contacts,
 *
 *     l_1 (Y_a + Y_b) tan(D/2) + rho_1 D cos theta_a = R,
 *
 * where every term of R has the small factor `by`. The first estimate of D fixes only tan(D/2) / D.
 */
static real difference_next(const struct roller *a, const struct roller *b, real by)
{
    const struct geometry *geometry = a->link.geometry;
    const struct rounded *of = &geometry->rounded;
    struct tilt A = a->link.tilt, B = b->link.tilt;
    real t = half_of_turn(A, B, by), sines = t * (A.x + B.x), cosines = t * (A.y + B.y);
    real more = of->rho - of->rho_1, rough = a->rolling.turn - b->rolling.turn;
    real R = more * (sines - cosines + by * A.y - b->theta * sines) +
             sines * (of->rho_1 * b->rolling.turn - geometry->L);
    real half = rough == 0 ? (real)0.5 : tan(rough / 2) / rough;
    real D = R / (of->tall_1 * (a->link.contact.Y + b->link.contact.Y) * half + of->rho_1 * A.y);
    return by + D;
}

KERNEL enum dom_status rolling_change(const struct geometry *geometry, struct tilt from, struct tilt head,
                                      real by, struct sums *sums)
{
    struct sum_state state = {0};
    struct roller a = roller_head(geometry, head), b = roller_head(geometry, from);
    real H2 = 0;
    for (;;) {
        const struct link *link = &a.link;
        enum dom_status status = chain_watch(geometry, link->i);
        if (status != DOM_OK)
            return status;
        roller_add_J(&state, link);
        roller_add_H1(&state, link);
        series_add(&state.dH, link->weight * rolling_rise(link->geometry, link->tilt, b.link.tilt, by));
        H2 += link->weight * (a.second_derivative * geometry_lift(link->geometry, link->tilt) -
                              link->slope * link->slope * geometry_height(link->geometry, link->tilt));
        if (link->i + 1 >= geometry->n || !b.link.leads)
            break;
        if (!link->leads) { /* The follower has detached during this cycle: it keeps the energy of theta_f. */
            roller_next(&b);
            state.left = b.link.weight *
                         rolling_rise(geometry, geometry->f, b.link.tilt, tilt_angle(geometry->f) - b.theta);
            series_add(&state.dH, state.left);
            break;
        }
        real next = difference_next(&a, &b, by), shrinks = by == 0 ? 1 : fabs(next / by);
        const struct geometry *own = link->geometry;
        bool done = series_done(&state.dH, link->weight * fabs(by) * (own->reach + fabs(own->rounded.roll)),
                                fmax(own->weight * shrinks, own->decay), geometry->tol);
        if (done && done_J(&state, link) && rolling_done_H1(&state, link, geometry->tol))
            break;
        by = next;
        roller_next(&a);
        roller_next(&b);
    }
    return rolling_result(geometry, &state, H2, a.link.i + 1, sums);
}
