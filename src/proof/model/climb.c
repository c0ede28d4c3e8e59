/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Computes the energy D = H(theta) - H(0) that a train must climb. */
#include "proof/model/energy.h"
#include "proof/model/rest.h"

static struct span everything(void)
{
    return (struct span){-INFINITY, INFINITY};
}

/*
 * Adds the contribution of domino n and all later dominoes to D. These dominoes are not computed one by one,
 * so the contribution is known only within bounds. They are all beyond theta_u, where h decreases. Let
 * theta_i0 be the tilt of domino i while the head is upright.
 *
 * Upper bound: domino i is at theta_i0 or beyond, so h is at most what it was with an upright head. So the
 * contribution to D is at most 0.
 *
 * Lower bound: for theta <= theta_c, the tilt of domino i is at most theta_(i+1)0, the tilt that domino i + 1
 * has with an upright head. With these tilts, the sum telescopes as in rest_of_fuel. So the contribution is
 * at least
 *
 *     -r^(-q n) (h(theta_n0) - h(theta_last)).
 */
static void climb_rest(const struct upright *u, const struct domino *domino, struct contact contact,
                       struct climb *climb)
{
    const struct growth *g = &u->growth;
    const struct link *link = &u->link[u->n];
    double fall = least_0(up(link->g.value.hi - u->g_last)), power = link->weight.value.hi;
    struct rest rest = rest_find(g, domino, &contact, power, fall, u->n);
    climb->height.lo =
        PROOF_BOUND(REST_OF_HEIGHT, down(climb->height.lo - up(power * fall)), climb->height.lo);
    climb->by_tilt.lo = down(climb->by_tilt.lo - rest.tilts);
    climb->by_r.lo = down(climb->by_r.lo - rest.slides);
    climb->by_r.hi = up(climb->by_r.hi + up(u->slide_rest + u->drop_rest));
}

struct climb climb_find(const struct upright *u, double low, double high, bool derivatives)
{
    const struct growth *g = &u->growth;
    const struct shape *shape = g->shape;
    /* The arguments `low` and `high` are values of sigma = 2 sin(theta/2). It follows that v = sigma^2/2, and
     * that dtheta/dsigma = 1/sqrt(1 - sigma^2/4). */
    struct domino domino = {.v = {least_0(down(low * low / 2)), most_1(up(high * high / 2))},
                            .slope = {1, 1}};
    struct dual height = {{0, 0}, {0, 0}};
    struct span by_tilt = {0, 0};
    bool bounded = derivatives && u->by_r;
    struct contact contact = {.held = false};
    if (u->n == 0)
        return (struct climb){everything(), everything(), everything()};
    for (int i = 0; i < u->n; i++) {
        const struct link *link = &u->link[i];
        struct dual h = dual_of(tilt_height(shape, domino.v));
        if (!derivatives) {
            height.value =
                span_add(height.value, span_scale(link->weight.value, span_sub(h.value, link->g.value)));
            domino.v = chain_follow(g, domino.v);
            continue;
        }
        struct span rise = tilt_rise(shape, domino.v);
        h.by_r = span_mul(rise, domino.shift);
        height = dual_add(height, dual_scale(link->weight, dual_sub(h, link->g)));
        by_tilt = span_add(by_tilt, span_scale(link->weight.value, span_mul(rise, domino.slope)));
        contact = chain_contact(g, domino.v);
        bounded = bounded && contact.Y.lo > 0 && isfinite(contact.shift.hi);
        domino = chain_next(g, &domino, &contact);
    }
    struct climb climb = {height.value, by_tilt, height.by_r};
    if (!u->exact_end)
        climb_rest(u, &domino, derivatives ? chain_contact(g, domino.v) : contact, &climb);
    struct span quarter = {down(low * low / 4), up(high * high / 4)};
    climb.by_tilt = span_over(climb.by_tilt, span_sqrt(span_sub(span_of(1), quarter)));
    if (!derivatives || !span_finite(climb.by_tilt))
        climb.by_tilt = everything();
    if (!bounded || !span_finite(climb.by_r))
        climb.by_r = everything();
    return climb;
}
