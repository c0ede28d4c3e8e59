/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "geometry/chain.h"

KERNEL enum dom_status chain_energy_at(const struct geometry *geometry, real theta, struct sums *sums)
{
    struct tilt head;
    enum dom_status status = geometry_tilt(geometry, theta, &head);
    return status == DOM_OK ? chain_change(geometry, standing, head, PASS_PLAIN, sums) : status;
}

KERNEL enum dom_status chain_leave(const struct geometry *geometry, bool *leaves, struct tilt *head,
                                   size_t *domino)
{
    *leaves = false;
    if (!geometry->detaches)
        return DOM_OK;
    struct link b = link_head(geometry, standing, geometry->rolls);
    /* The part of the torque on domino b.i that reaches the head. Without friction, this is theta_i'. */
    real passed = 1;
    while (b.leads) {
        enum dom_status status = chain_watch(geometry, b.i);
        if (status != DOM_OK)
            return status;
        /* A domino that contributes less than the rounding errors does not matter, even if it detaches. */
        if (b.i + 1 >= geometry->n || b.weight * fmax(b.slope, passed) < REAL_EPSILON * REAL_EPSILON)
            return DOM_OK;
        const struct arms arms = link_arms(&b, geometry->rolls);
        passed *= fabs(arms.a / arms.b);
        link_on(&b);
    }
    /* When the head is upright, the follower of domino b.i is already detached. The next domino to detach is
     * b.i itself. This happens when the leader of b.i reaches theta_leave. */
    *head = geometry->leave;
    for (size_t i = b.i; i > 1; i--)
        *head = geometry_leader(geometry, *head);
    if (domino)
        *domino = b.i;
    *leaves = true;
    return DOM_OK;
}

KERNEL enum dom_status chain_edges(const struct geometry *geometry, real end, real edge[CHAIN_EDGES],
                                   int *edges, size_t *moving)
{
    bool leaves;
    struct tilt leave;
    size_t domino = 0;
    enum dom_status status = chain_leave(geometry, &leaves, &leave, &domino);
    if (status != DOM_OK)
        return status;
    /* With sharp edges and r s = 1, the follower detaches as soon as the head moves, so H' jumps at the tilt
     * 0. Start just after the jump. */
    edge[0] = geometry->short_of == 0 ? fmin(REAL_MIN, end) : 0;
    *edges = 1;
    real theta_leave = leaves ? tilt_angle(leave) : 0;
    if (theta_leave > edge[0] && theta_leave < end)
        edge[(*edges)++] = theta_leave;
    edge[(*edges)++] = end;
    if (moving)
        *moving = !leaves ? CHAIN_ENDLESS : theta_leave > edge[0] ? domino + 1 : domino;
    return DOM_OK;
}

/* ---- Public ---- */

/* Makes the geometry of a train and converts the angle theta of its head to a tilt. */
static enum dom_status train_tilted(const struct dom_train *train, const struct dom_compute *compute,
                                    dom_real theta, struct geometry *geometry, struct tilt *head)
{
    enum dom_status status = train_check(train, compute);
    *geometry = geometry_read(train, compute);
    if (status == DOM_OK && train->rho != 0)
        status = rounded_make(geometry, (real)train->rho);
    if (status == DOM_OK)
        status = geometry_set(geometry, geometry->s, geometry->r);
    return status == DOM_OK ? geometry_tilt(geometry, (real)theta, head) : status;
}

static struct dom_link link_public(const struct geometry *geometry, const struct link *k)
{
    return (struct dom_link){
        .i = k->i,
        .theta = tilt_angle(k->tilt),
        .slope = k->slope,
        .arm_a = k->leads ? k->contact.arm / geometry->r : REAL_NAN, /* (table 1) */
        .arm_b = k->leads ? link_arms(k, geometry->rolls).b / geometry->r : REAL_NAN,
        .weight = k->weight,
    };
}

enum dom_status dom_chain_walk(const struct dom_train *train, const struct dom_compute *compute,
                               dom_real theta, dom_visit *visit, void *context)
{
    struct geometry geometry;
    struct tilt head;
    enum dom_status status = train_tilted(train, compute, theta, &geometry, &head);
    struct sums sums = {0};
    if (status == DOM_OK)
        status = chain_sum(&geometry, head, false, &sums);
    if (status != DOM_OK)
        return status;
    struct link k = link_head(&geometry, head, geometry.rolls);
    for (;;) {
        if (dom_interrupted(geometry.interrupt)) /* checked at every domino, since the callback may be slow */
            return DOM_INTERRUPTED;
        struct dom_link link = link_public(&geometry, &k);
        if (!visit(&link, context) || !k.leads || k.i + 1 >= sums.n)
            return DOM_OK;
        link_on(&k);
    }
}

enum dom_status dom_contact_find(const struct dom_train *train, const struct dom_compute *compute,
                                 dom_real theta, struct dom_contact *contact)
{
    struct geometry geometry;
    struct tilt head;
    enum dom_status status = train_tilted(train, compute, theta, &geometry, &head);
    if (status != DOM_OK)
        return status;
    struct link k = link_head(&geometry, head, geometry.rolls);
    struct dom_link link = link_public(&geometry, &k);
    *contact =
        (struct dom_contact){.theta_1 = tilt_angle(geometry.f), .arm_a = link.arm_a, .arm_b = link.arm_b};
    if (k.leads) {
        link_on(&k);
        contact->theta_1 = tilt_angle(k.tilt);
        contact->slope = k.slope;
    }
    return DOM_OK;
}
