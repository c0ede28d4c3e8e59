/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dynamics/energy_balance.h"

/* ---- Fuel ---- */

KERNEL struct fuel fuel_of(const struct geometry *geometry, const struct sums *at_c)
{
    return (struct fuel){.exact = -at_c->dH,
                         .paper = geometry->law->paper_fuel(geometry),
                         .inertia_ratio = geometry->inertia * at_c->J / geometry->upright_inertia};
}

KERNEL enum dom_status energy_fuel(const struct geometry *geometry, struct fuel *fuel)
{
    struct sums at_c;
    enum dom_status status = chain_fuel(geometry, &at_c);
    if (status == DOM_OK)
        *fuel = fuel_of(geometry, &at_c);
    return status;
}

/* ---- Collision ---- */

KERNEL struct launch launch_of(const struct geometry *geometry, enum dom_fuel fuel, const struct fuel *f)
{
    real P = fuel == DOM_FUEL_PAPER ? f->paper : f->exact,
         J0 = geometry->upright_inertia * (1 + f->inertia_ratio);
    /* This is equation (24; c6). With the inertia ratio T = J(0) - 1, its denominator, r^q J(0) - J(0) + 1,
     * is written as r^q + T (r^q - 1). In this form, no digits cancel if r >= 1. */
    real kinetic = P * f->inertia_ratio / (geometry->rq + f->inertia_ratio * geometry->rq_1);
    return (struct launch){.fuel = P,
                           .J0 = J0,
                           .inertia_ratio = f->inertia_ratio,
                           .velocity_ratio = collision_velocity_ratio(f->inertia_ratio),
                           .omegasq = kinetic / J0,
                           .kinetic = kinetic,
                           .kinetic_at_hit = kinetic + f->exact};
}

static enum dom_status energy_collide(const struct geometry *geometry, enum dom_fuel fuel,
                                      struct launch *launch)
{
    struct fuel f;
    if (fuel == DOM_FUEL_PAPER && !energy_paper_holds(geometry))
        return DOM_NO_METHOD;
    enum dom_status status = energy_fuel(geometry, &f);
    if (status != DOM_OK)
        return status;
    *launch = launch_of(geometry, fuel, &f);
    return isfinite(launch->kinetic) ? DOM_OK : DOM_NOT_FINITE;
}

static enum dom_status energy_inertia_ratio(const struct geometry *next, const struct geometry *hitting,
                                            struct tilt at, real J, real *inertia_ratio)
{
    (void)hitting, (void)at;
    const real slope = geometry_hit_slope(next);
    *inertia_ratio = next->inertia * slope * slope * J / next->upright_inertia;
    return *inertia_ratio > 0 ? DOM_OK : DOM_UNDERFLOW;
}

/* ---- Motion ---- */

static enum dom_status energy_slope(const struct geometry *geometry, struct tilt head, bool rough,
                                    real *slope)
{
    return chain_slope(geometry, head, rough, slope);
}

static enum dom_status energy_required(const struct geometry *geometry, struct tilt from, real p,
                                       real *energy)
{
    struct sums sums;
    enum dom_status status = chain_change(geometry, from, tilt_half(p), PASS_PLAIN, &sums);
    *energy = sums.dH;
    return status;
}

/* Solves (21; c3) for tau^2 omega(theta)^2. */
static enum dom_status energy_speed(const struct geometry *geometry, const struct start *start, real theta,
                                    real *omegasq)
{
    struct tilt head;
    struct sums at = {0};
    enum dom_status status = geometry_tilt(geometry, theta, &head);
    if (status == DOM_OK)
        status = chain_change(geometry, start->from, head, PASS_PLAIN, &at);
    if (status != DOM_OK)
        return status;
    *omegasq = (start->kinetic - at.dH) / at.J;
    return DOM_OK;
}

static enum dom_status energy_near_rest(const struct geometry *geometry, real end, real by, real *slowness)
{
    struct tilt head, rest;
    struct sums at;
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

KERNEL enum dom_status equation_acceleration(const struct geometry *geometry, struct tilt head, real w,
                                             real *acceleration, size_t *n)
{
    struct equation_of_motion at = {.n = 0};
    enum dom_status status = chain_equation(geometry, head, &at);
    if (n)
        *n = at.n;
    *acceleration = (at.C - at.B * w) / at.A;
    return status;
}

static real energy_gain(const struct geometry *geometry, const struct start *start, real gain, real theta,
                        real J_at)
{
    (void)geometry, (void)theta;
    return gain * start->J / J_at;
}

static const struct dynamics energy_balance = {
    .conservative = true,
    .collide = energy_collide,
    .inertia_ratio = energy_inertia_ratio,
    .slope = energy_slope,
    .required_energy = energy_required,
    .speed = energy_speed,
    .near_rest = energy_near_rest,
    .acceleration = equation_acceleration,
    .gain = energy_gain,
};
