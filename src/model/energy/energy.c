/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The energies of a train at one tilt, and how its cycle begins. */
#include "dynamics/energy_balance.h"

KERNEL enum dom_status fuel_find(const struct dom_train *train, struct dom_fuels *fuels,
                                 struct dom_fuels *error)
{
    struct geometry geometry;
    struct fuel fuel, e;
    enum dom_status status = dynamics_make(train, &geometry);
    if (status == DOM_OK)
        status = energy_fuel(&geometry, &fuel, error ? &e : NULL);
    if (status != DOM_OK)
        return status;
    *fuels = (struct dom_fuels){.exact = fuel.exact, .paper = fuel.paper};
    if (error)
        *error = (struct dom_fuels){.exact = e.exact, .paper = e.paper};
    return DOM_OK;
}

KERNEL enum dom_status energy_find(const struct dom_train *train, dom_real theta, struct dom_energy *energy,
                                   struct dom_energy *error)
{
    struct geometry geometry;
    struct tilt head;
    struct sums at, e;
    struct fuel fuel, fuel_error;
    enum dom_status status = dynamics_make(train, &geometry);
    if (status == DOM_OK)
        status = geometry_tilt(&geometry, (real)theta, &head);
    if (status == DOM_OK)
        status = chain_energy_change(&geometry, head, &at, error ? &e : NULL);
    if (status == DOM_OK)
        status = energy_fuel(&geometry, &fuel, error ? &fuel_error : NULL);
    if (status != DOM_OK)
        return status;
    *energy = (struct dom_energy){.dH = at.dH, .J = at.J, .J0 = 1 + fuel.inertia_ratio};
    if (error)
        *error = (struct dom_energy){
            .dH = e.dH, .J = e.J, .J0 = fuel_error.inertia_ratio + UNIT * (1 + fuel.inertia_ratio)};
    return DOM_OK;
}

KERNEL enum dom_status launch_find(const struct dom_train *train, struct dom_launch *launch,
                                   struct dom_launch *error)
{
    struct geometry geometry;
    struct launch l, e;
    enum dom_status status = dynamics_make(train, &geometry);
    if (status != DOM_OK)
        return status;
    status = dynamics_begin(&geometry);
    if (status == DOM_OK)
        status = geometry.dynamics->collide(&geometry, train->fuel, &l, error ? &e : NULL);
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
    if (error)
        *error = (struct dom_launch){.fuel = e.fuel,
                                     .J0 = e.J0,
                                     .velocity_ratio = e.velocity_ratio,
                                     .omegasq = e.omegasq,
                                     .kinetic = e.kinetic};
    return fuelled ? DOM_OK : DOM_NO_FUEL;
}
