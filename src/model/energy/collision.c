/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "energy/collision.h"

/*
 * With friction: a cycle that begins with w(0) ends with w(theta_c) = G (w(0) - u), and the collision makes
 * r keeps^2 of it, w(0) again.
 */
static enum dom_status collision_rubbing(const struct geometry *geometry, enum dom_fuel fuel,
                                         struct launch *launch, struct launch *error)
{
    real ln_G, u;
    if (fuel == DOM_FUEL_PAPER || !geometry->flow) /* no room: who compares with us knows no friction */
        return DOM_NO_METHOD;
    enum dom_status status = friction_flow(geometry);
    if (status != DOM_OK)
        return status;
    const struct flow *flow = geometry->flow;
    friction_at(geometry, tilt_angle(geometry->c), &ln_G, &u);
    real G = exp(ln_G), velocity_ratio = flow->inertia_ratio / (1 + flow->inertia_ratio),
         kappa = geometry->r * velocity_ratio * velocity_ratio;
    real omegasq = -kappa * G * u / (1 - kappa * G);
    *launch = (struct launch){
        .fuel = -flow->J_c * G * u,
        .J0 = flow->J0,
        .velocity_ratio = velocity_ratio,
        .omegasq = omegasq,
        .kinetic = flow->J0 * omegasq,
    };
    if (error)
        *error = (struct launch){REAL_NAN, REAL_NAN, REAL_NAN, REAL_NAN, REAL_NAN};
    return isfinite(omegasq) ? DOM_OK : DOM_NOT_FINITE;
}

KERNEL struct launch launch_of(const struct geometry *geometry, enum dom_fuel fuel, const struct fuel *f)
{
    real P = fuel == DOM_FUEL_PAPER ? f->paper : f->exact, J0 = 1 + f->inertia_ratio;
    /* (c6) with r^q J(0) - J(0) + 1 = r^q + T (r^q - 1): terms of one sign. */
    real kinetic = P * f->inertia_ratio / (geometry->rq + f->inertia_ratio * geometry->rq_1);
    return (struct launch){.fuel = P,
                           .J0 = J0,
                           .velocity_ratio = f->inertia_ratio / J0,
                           .omegasq = kinetic / J0,
                           .kinetic = kinetic};
}

KERNEL enum dom_status collision_launch(const struct geometry *geometry, enum dom_fuel fuel,
                                        struct launch *launch, struct launch *error)
{
    struct fuel f, e;
    if (geometry->mu > 0)
        return collision_rubbing(geometry, fuel, launch, error);
    enum dom_status status = energy_fuel(geometry, &f, error ? &e : NULL);
    if (status != DOM_OK)
        return status;
    *launch = launch_of(geometry, fuel, &f);
    real J0 = launch->J0, kinetic = launch->kinetic;
    if (error) {
        real size = fabs(kinetic), P_error = fuel == DOM_FUEL_PAPER ? e.paper : e.exact;
        real powers = 12 * UNIT; /* of the denominator, and of what is left to do */
        real of_kinetic = P_error * f.inertia_ratio / (geometry->rq + f.inertia_ratio * geometry->rq_1) +
                          size * (e.inertia_ratio / f.inertia_ratio + powers);
        real of_J0 = e.inertia_ratio + UNIT * J0;
        *error = (struct launch){
            .fuel = P_error,
            .J0 = of_J0,
            .velocity_ratio =
                (e.inertia_ratio + of_J0 * f.inertia_ratio / J0) / J0 + UNIT * f.inertia_ratio / J0,
            .omegasq = (of_kinetic + size * (of_J0 / J0 + UNIT)) / J0,
            .kinetic = of_kinetic,
        };
    }
    return isfinite(kinetic) ? DOM_OK : DOM_NOT_FINITE;
}

KERNEL enum dom_status launch_find(const struct request *train, struct dom_launch *launch,
                                   struct dom_launch_error *error)
{
    struct geometry geometry;
    FLOW(flow);
    struct launch l, e;
    enum dom_status status = geometry_make(train, &geometry);
    if (status == DOM_OK)
        geometry_flow(&geometry, &flow);
    if (status == DOM_OK)
        status = collision_launch(&geometry, train->fuel, &l, error ? &e : NULL);
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
        *error = (struct dom_launch_error){.fuel = e.fuel,
                                           .J0 = e.J0,
                                           .velocity_ratio = e.velocity_ratio,
                                           .omegasq = e.omegasq,
                                           .kinetic = e.kinetic};
    return fuelled ? DOM_OK : DOM_NO_FUEL;
}
