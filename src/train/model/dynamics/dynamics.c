/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dynamics/dynamics.h"

KERNEL enum dom_status energy_fuel(const struct geometry *geometry, struct fuel *fuel)
{
    struct sums at_c = {0};
    enum dom_status status =
        chain_change_by(geometry, standing, geometry->c, half_of_tilt(geometry->c), PASS_FUEL, &at_c);
    *fuel = (struct fuel){.exact = -at_c.dH,
                          .paper = geometry_paper_fuel(geometry),
                          .inertia_ratio = geometry->inertia * at_c.J / geometry->upright_inertia};
    return status;
}

/* ---- Collision ---- */

KERNEL enum dom_status dynamics_inertia_ratio(const struct geometry *next, const struct geometry *hitting,
                                              struct tilt at, real J, real *inertia_ratio)
{
    if (next->conservative) {
        const real slope = geometry_hit_slope(next);
        *inertia_ratio = next->inertia * slope * slope * J / next->upright_inertia;
        return *inertia_ratio > 0 ? DOM_OK : DOM_UNDERFLOW;
    }
    struct equation_of_motion at_hit;
    const struct link rest = link_head(next, geometry_rest(next), next->rolls);
    const struct arms arms = link_arms(&rest, next->rolls);
    *inertia_ratio = 0;
    if (next->mu != 0 && !(arms.a > 0))
        return DOM_LOCKS;
    enum dom_status status = chain_equation(hitting, at, &at_hit);
    if (status == DOM_OK)
        *inertia_ratio = next->inertia * rest.contact.slope * at_hit.A * arms.ratio / next->upright_inertia;
    return status != DOM_OK || *inertia_ratio > 0 ? status : DOM_LOCKS;
}

KERNEL enum dom_status dynamics_collide(const struct geometry *geometry, enum dom_fuel fuel,
                                        struct launch *launch)
{
    struct fuel f;
    if (fuel == DOM_FUEL_PAPER && !(geometry->conservative && energy_paper_holds(geometry)))
        return DOM_NO_METHOD;
    if (!geometry->conservative)
        return flow_collide(geometry, launch);
    enum dom_status status = energy_fuel(geometry, &f);
    if (status != DOM_OK)
        return status;
    /* This is equation (24; c6). With the inertia ratio T = J(0) - 1, its denominator, r^q J(0) - J(0) + 1,
     * is written as r^q + T (r^q - 1). In this form, no digits cancel if r >= 1. */
    const real T = f.inertia_ratio, P = fuel == DOM_FUEL_PAPER ? f.paper : f.exact,
               J0 = geometry->upright_inertia * (1 + T),
               kinetic = P * T / (geometry->rq + T * geometry->rq_1);
    *launch = (struct launch){.fuel = P,
                              .J0 = J0,
                              .inertia_ratio = T,
                              .velocity_ratio = collision_velocity_ratio(T),
                              .omegasq = kinetic / J0,
                              .kinetic = kinetic,
                              .kinetic_at_hit = kinetic + f.exact};
    return isfinite(kinetic) ? DOM_OK : DOM_NOT_FINITE;
}

/* ---- Motion ---- */

KERNEL enum dom_status dynamics_slope(const struct geometry *geometry, struct tilt head, bool rough,
                                      real *slope)
{
    if (geometry->conservative)
        return chain_slope(geometry, head, rough, slope);
    struct equation_of_motion equation = {.C = 0};
    if (rough) {
        *slope = flow_solved_slope(geometry, tilt_angle(head));
        return DOM_OK;
    }
    enum dom_status status = chain_equation(geometry, head, &equation);
    *slope = -2 * equation.C;
    return status;
}

KERNEL enum dom_status dynamics_required(const struct geometry *geometry, struct tilt from, real p,
                                         real *energy)
{
    if (!geometry->conservative) {
        real ln_G, u;
        flow_at(geometry, 2 * atan(p), &ln_G, &u);
        *energy = geometry->flow->J0 * u;
        return DOM_OK;
    }
    struct sums sums;
    enum dom_status status = chain_change(geometry, from, tilt_half(p), PASS_PLAIN, &sums);
    *energy = sums.dH;
    return status;
}

KERNEL enum dom_status dynamics_speed(const struct geometry *geometry, const struct start *start, real theta,
                                      real *omegasq)
{
    struct tilt head;
    struct sums at = {0};
    enum dom_status status = geometry_tilt(geometry, theta, &head);
    if (status == DOM_OK && !geometry->conservative) {
        real ln_G, u;
        flow_at(geometry, theta, &ln_G, &u);
        *omegasq = exp(ln_G) * (start->omegasq - u);
        return DOM_OK;
    }
    if (status == DOM_OK)
        status = chain_change(geometry, start->from, head, PASS_PLAIN, &at);
    if (status == DOM_OK)
        *omegasq = (start->kinetic - at.dH) / at.J; /* (21; c3) */
    return status;
}

KERNEL enum dom_status dynamics_near_rest(const struct geometry *geometry, real end, real by, real *slowness)
{
    struct tilt head, rest;
    struct sums at;
    if (!geometry->conservative)
        return flow_near_rest(geometry, end, by, slowness);
    /* At the start, rounding may put `end - by` slightly below the initial tilt. */
    enum dom_status status = geometry_tilt(geometry, fmax(end - by, geometry->lean), &head);
    if (status == DOM_OK)
        status = geometry_tilt(geometry, end, &rest);
    if (status == DOM_OK)
        status = chain_change_by(geometry, rest, head, tan(-by / 2), PASS_PLAIN, &at);
    if (status == DOM_OK)
        *slowness = at.dH < 0 ? at.J / -at.dH : REAL_NAN;
    return status;
}

KERNEL real dynamics_gain(const struct geometry *geometry, const struct start *start, real gain, real theta,
                          real J_at)
{
    real ln_G, u;
    if (geometry->conservative)
        return gain * start->J / J_at;
    flow_at(geometry, theta, &ln_G, &u);
    return gain * exp(ln_G);
}
