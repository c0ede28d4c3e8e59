/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The public functions for the angles, the energies, the fuel, the launch and the dominoes of a train. H and
 * J are sums of geometry/chain.c, and the fuel and the launch are in dynamics/dynamics.c. */
#include "effects/effects.h"

enum dom_status dom_angles_find(const struct dom_train *train, const struct dom_compute *compute,
                                struct dom_angles *angles)
{
    struct geometry geometry;
    enum dom_status status = train_make(train, compute, false, &geometry);
    if (status != DOM_OK)
        return status;
    *angles = (struct dom_angles){
        .theta_c = tilt_angle(geometry.c),
        .theta_u = geometry_theta_u(&geometry),
        .theta_inf = tilt_angle(geometry.inf),
        .theta_f = tilt_angle(geometry.f),
        .theta_leave = geometry.detaches ? tilt_angle(geometry.leave) : REAL_NAN,
        .detaches = geometry.detaches,
    };
    return DOM_OK;
}

enum dom_status dom_fuel_find(const struct dom_train *train, const struct dom_compute *compute,
                              struct dom_fuels *fuels)
{
    struct geometry geometry;
    real exact;
    enum dom_status status = train_make(train, compute, true, &geometry);
    if (status == DOM_OK)
        status = dynamics_fuel(&geometry, &exact, NULL);
    if (status == DOM_OK)
        *fuels = (struct dom_fuels){.exact = exact, .paper = geometry_paper_fuel(&geometry)};
    return status;
}

enum dom_status dom_energy_find(const struct dom_train *train, const struct dom_compute *compute,
                                dom_real theta, struct dom_energy *energy)
{
    struct geometry geometry;
    struct tilt head;
    struct sums at;
    real fuel, inertia_ratio;
    enum dom_status status = train_make(train, compute, true, &geometry);
    if (status == DOM_OK)
        status = geometry_tilt(&geometry, (real)theta, &head);
    if (status == DOM_OK)
        status = chain_change(&geometry, standing, head, PASS_PLAIN, &at);
    if (status == DOM_OK)
        status = dynamics_fuel(&geometry, &fuel, &inertia_ratio);
    if (status == DOM_OK)
        *energy = (struct dom_energy){at.dH, at.J, .J0 = geometry.upright_inertia * (1 + inertia_ratio)};
    return status;
}

enum dom_status dom_launch_find(const struct dom_train *train, const struct dom_compute *compute,
                                struct dom_launch *launch)
{
    struct geometry geometry;
    struct flow flow = {.tol = 0};
    struct launch l;
    enum dom_status status = train_make(train, compute, true, &geometry);
    geometry.flow = &flow;
    if (status == DOM_OK)
        status = dynamics_launch(&geometry, train->fuel, &l);
    num_linear_free(&flow.solution);
    if (status != DOM_OK)
        return status;
    bool fuelled = l.fuel > 0;
    *launch = (struct dom_launch){
        .fuel = l.fuel,
        .J0 = l.J0,
        .velocity_ratio = collision_velocity_ratio(l.inertia_ratio),
        .omegasq = fuelled ? l.omegasq : REAL_NAN,
        .kinetic = fuelled ? l.kinetic : REAL_NAN,
    };
    return fuelled ? DOM_OK : DOM_NO_FUEL;
}

/* ---- The dominoes at one tilt ---- */

static struct dom_link link_public(const struct geometry *geometry, const struct link *k)
{
    return (struct dom_link){
        .i = k->i,
        .theta = tilt_angle(k->tilt),
        .slope = k->slope,
        .arm_a = k->leads ? k->contact.arm / geometry->r : REAL_NAN, /* (table 1) */
        .arm_b = k->leads ? link_arms(k, geometry->rolls).b_plain / geometry->r : REAL_NAN,
        .weight = k->weight,
    };
}

enum dom_status dom_chain_walk(const struct dom_train *train, const struct dom_compute *compute,
                               dom_real theta, dom_visit *visit, void *context)
{
    struct geometry geometry;
    struct tilt head;
    struct sums sums = {0};
    enum dom_status status = train_make(train, compute, false, &geometry);
    if (status == DOM_OK)
        status = geometry_tilt(&geometry, (real)theta, &head);
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
    enum dom_status status = train_make(train, compute, false, &geometry);
    if (status == DOM_OK)
        status = geometry_tilt(&geometry, (real)theta, &head);
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
