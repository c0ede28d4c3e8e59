/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Computes the angles, the energies, the fuel and the launch of a train. */
#include "dynamics/choose.h"

KERNEL enum dom_status angles_find(const struct request *train, struct dom_angles *angles)
{
    struct geometry geometry;
    enum dom_status status = dynamics_make(train, &geometry);
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
    if (train->errors) /* the inverse trigonometric functions add relative errors of up to 2 ROUNDOFF */
        angles->error = (struct dom_angles_error){
            .theta_c = geometry_error_head(geometry.c) + 2 * ROUNDOFF * angles->theta_c,
            .theta_u = geometry_error_u(&geometry) + 2 * ROUNDOFF * angles->theta_u,
            .theta_inf = tilt_error(geometry.inf, 6) + 2 * ROUNDOFF * angles->theta_inf,
            .theta_f = geometry_error_f(&geometry) + 2 * ROUNDOFF * angles->theta_f,
            .theta_leave = geometry.detaches
                               ? geometry_error_leave(&geometry) + 2 * ROUNDOFF * angles->theta_leave
                               : DOM_NAN,
        };
    return DOM_OK;
}

KERNEL enum dom_status fuel_find(const struct request *train, struct dom_fuels *fuels)
{
    struct geometry geometry;
    struct fuel fuel, e;
    enum dom_status status = dynamics_make(train, &geometry);
    if (status == DOM_OK)
        status = energy_fuel(&geometry, &fuel, train->errors ? &e : NULL);
    if (status != DOM_OK)
        return status;
    *fuels = (struct dom_fuels){.exact = fuel.exact, .paper = fuel.paper};
    if (train->errors)
        fuels->error = (struct dom_fuels_error){.exact = e.exact, .paper = e.paper};
    return DOM_OK;
}

KERNEL enum dom_status energy_find(const struct request *train, dom_real theta, struct dom_energy *energy)
{
    struct geometry geometry;
    struct sums at, e;
    struct fuel fuel, fuel_error;
    enum dom_status status = dynamics_make(train, &geometry);
    if (status == DOM_OK)
        status = chain_energy_at(&geometry, (real)theta, &at, train->errors ? &e : NULL);
    if (status == DOM_OK)
        status = energy_fuel(&geometry, &fuel, train->errors ? &fuel_error : NULL);
    if (status != DOM_OK)
        return status;
    *energy = (struct dom_energy){
        .dH = at.dH, .J = at.J, .J0 = geometry.upright_inertia * (1 + fuel.inertia_ratio)};
    if (train->errors)
        energy->error = (struct dom_energy_error){
            .dH = e.dH, .J = e.J, .J0 = fuel_error.inertia_ratio + ROUNDOFF * (1 + fuel.inertia_ratio)};
    return DOM_OK;
}

KERNEL enum dom_status launch_find(const struct request *train, struct dom_launch *launch)
{
    struct geometry geometry;
    struct launch l, e;
    enum dom_status status = dynamics_make(train, &geometry);
    if (status == DOM_OK)
        status = dynamics_begin(&geometry);
    if (status == DOM_OK)
        status = geometry.dynamics->collide(&geometry, train->fuel, &l, train->errors ? &e : NULL);
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
    if (train->errors)
        launch->error = (struct dom_launch_error){.fuel = e.fuel,
                                                  .J0 = e.J0,
                                                  .velocity_ratio = e.velocity_ratio,
                                                  .omegasq = e.omegasq,
                                                  .kinetic = e.kinetic};
    return fuelled ? DOM_OK : DOM_NO_FUEL;
}
