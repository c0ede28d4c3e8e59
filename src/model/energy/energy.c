/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "energy/energy.h"

KERNEL real energy_fuel_paper(const struct geometry *geometry)
{
    real s = geometry->s, d = geometry->d;
    /* 1 - h(theta_f) = sin theta_f (tan(theta_f / 2) - d). */
    if (geometry->detaches)
        return geometry->f.x * (geometry->f.x / (1 + geometry->f.y) - d);
    /* 1 - h(theta_inf), rationalized: it keeps its digits near P = 0, s = 2 d^3 / (1 - d^2). */
    return s * fma(s, (1 - d) * (1 + d), -2 * d * d * d) /
           (geometry->L * (s + d * geometry->L * geometry->inf.x));
}

/* Of the above: the roundings of the two terms whose difference it is, and the error of theta_f. */
static real fuel_paper_error(const struct geometry *geometry)
{
    real s = geometry->s, d = geometry->d;
    if (geometry->detaches) {
        real rises = d * geometry->f.y + geometry->f.x, half = geometry->f.x / (1 + geometry->f.y);
        return rises * geometry_error_f(geometry) + 12 * UNIT * geometry->f.x * (half + d);
    }
    real made_of = s * fabs((1 - d) * (1 + d)) + 2 * d * d * d;
    return 4 * UNIT * s * made_of / (geometry->L * (s + d * geometry->L * geometry->inf.x)) +
           10 * UNIT * fabs(energy_fuel_paper(geometry));
}

KERNEL struct fuel fuel_of(const struct geometry *geometry, const struct sums *at_c)
{
    return (struct fuel){.exact = -at_c->dH,
                         .paper = energy_fuel_paper(geometry),
                         .inertia_ratio = geometry->inertia * at_c->J};
}

KERNEL enum dom_status energy_fuel(const struct geometry *geometry, struct fuel *fuel, struct fuel *error)
{
    struct sums at_c, e;
    enum dom_status status = chain_fall(geometry, &at_c, error ? &e : NULL);
    if (status != DOM_OK)
        return status;
    *fuel = fuel_of(geometry, &at_c);
    if (error) {
        *error = (struct fuel){e.dH, fuel_paper_error(geometry),
                               geometry->inertia * e.J + 4 * UNIT * fuel->inertia_ratio};
    }
    return DOM_OK;
}

/* ---- Public ---- */

KERNEL enum dom_status fuel_find(const struct request *train, struct dom_fuels *fuels,
                                 struct dom_fuels_error *error)
{
    struct geometry geometry;
    struct fuel fuel, e;
    enum dom_status status = geometry_make(train, &geometry);
    if (status == DOM_OK)
        status = energy_fuel(&geometry, &fuel, error ? &e : NULL);
    if (status != DOM_OK)
        return status;
    *fuels = (struct dom_fuels){.exact = fuel.exact, .paper = fuel.paper};
    if (error)
        *error = (struct dom_fuels_error){.exact = e.exact, .paper = e.paper};
    return DOM_OK;
}

KERNEL enum dom_status energy_find(const struct request *train, dom_real theta, struct dom_energy *energy,
                                   struct dom_energy_error *error)
{
    struct geometry geometry;
    struct tilt head;
    struct sums at, e;
    struct fuel fuel, fuel_error;
    enum dom_status status = geometry_make_tilted(train, theta, &geometry, &head);
    if (status == DOM_OK)
        status = chain_energy_change(&geometry, head, &at, error ? &e : NULL);
    if (status == DOM_OK)
        status = energy_fuel(&geometry, &fuel, error ? &fuel_error : NULL);
    if (status != DOM_OK)
        return status;
    *energy = (struct dom_energy){.dH = at.dH, .J = at.J, .J0 = 1 + fuel.inertia_ratio};
    if (error)
        *error = (struct dom_energy_error){
            .dH = e.dH, .J = e.J, .J0 = fuel_error.inertia_ratio + UNIT * (1 + fuel.inertia_ratio)};
    return DOM_OK;
}
