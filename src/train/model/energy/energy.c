/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Computes the angles, the energies, the fuel and the launch of a train. */
#include "effects/effects.h"

enum dom_status dom_angles_find(const struct dom_train *train, const struct dom_compute *compute,
                                struct dom_angles *angles)
{
    struct geometry geometry;
    enum dom_status status = train_make(train, compute, 0, &geometry);
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
    struct fuel fuel;
    enum dom_status status = train_make(train, compute, 0, &geometry);
    if (status == DOM_OK)
        status = energy_fuel(&geometry, &fuel);
    if (status != DOM_OK)
        return status;
    *fuels = (struct dom_fuels){.exact = fuel.exact, .paper = fuel.paper};
    return DOM_OK;
}

enum dom_status dom_energy_find(const struct dom_train *train, const struct dom_compute *compute,
                                dom_real theta, struct dom_energy *energy)
{
    struct geometry geometry;
    struct sums at;
    struct fuel fuel;
    enum dom_status status = train_make(train, compute, 0, &geometry);
    if (status == DOM_OK)
        status = chain_energy_at(&geometry, (real)theta, &at);
    if (status == DOM_OK)
        status = energy_fuel(&geometry, &fuel);
    if (status != DOM_OK)
        return status;
    *energy = (struct dom_energy){
        .dH = at.dH, .J = at.J, .J0 = geometry.upright_inertia * (1 + fuel.inertia_ratio)};
    return DOM_OK;
}

enum dom_status dom_launch_find(const struct dom_train *train, const struct dom_compute *compute,
                                struct dom_launch *launch)
{
    struct geometry geometry;
    struct launch l;
    enum dom_status status = train_make(train, compute, 0, &geometry);
    if (status == DOM_OK)
        status = dynamics_begin(&geometry);
    if (status == DOM_OK)
        status = dynamics_collide(&geometry, train->fuel, &l);
    dynamics_end(&geometry);
    if (status != DOM_OK)
        return status;
    bool fuelled = l.fuel > 0;
    *launch = (struct dom_launch){
        .fuel = l.fuel,
        .J0 = l.J0,
        .velocity_ratio = l.velocity_ratio,
        .omegasq = fuelled ? l.omegasq : REAL_NAN,
        .kinetic = fuelled ? l.kinetic : REAL_NAN,
    };
    return fuelled ? DOM_OK : DOM_NO_FUEL;
}
