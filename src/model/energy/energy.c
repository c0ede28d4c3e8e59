/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "energy/energy.h"

KERNEL real energy_fuel_paper(const struct lean *g)
{
    real s = g->s, d = g->d;
    /* 1 - h(theta_f) = sin theta_f (tan(theta_f / 2) - d). */
    if (g->falls_off)
        return g->f.x * (g->f.x / (1 + g->f.y) - d);
    /* 1 - h(theta_inf), rationalized: it keeps its digits near P = 0, s = 2 d^3 / (1 - d^2). */
    return s * fma(s, (1 - d) * (1 + d), -2 * d * d * d) / (g->L * (s + d * g->L * g->inf.x));
}

/* Of the above: the roundings of the two terms whose difference it is, and the error of theta_f. */
static real fuel_paper_error(const struct lean *g)
{
    real s = g->s, d = g->d;
    if (g->falls_off) {
        real rises = d * g->f.y + g->f.x, half = g->f.x / (1 + g->f.y);
        return rises * lean_error_f(g) + 12 * UNIT * g->f.x * (half + d);
    }
    real made_of = s * fabs((1 - d) * (1 + d)) + 2 * d * d * d;
    return 4 * UNIT * s * made_of / (g->L * (s + d * g->L * g->inf.x)) +
           10 * UNIT * fabs(energy_fuel_paper(g));
}

KERNEL struct fuel fuel_of(const struct lean *g, const struct sums *at_c)
{
    return (struct fuel){.exact = -at_c->dH, .paper = energy_fuel_paper(g), .T = g->inertia * at_c->J};
}

KERNEL enum dom_status energy_fuel(const struct lean *g, struct fuel *fuel, struct fuel *error)
{
    struct sums at_c, e;
    enum dom_status status = chain_fall(g, &at_c, error ? &e : NULL);
    if (status != DOM_OK)
        return status;
    *fuel = fuel_of(g, &at_c);
    if (error) {
        *error = (struct fuel){e.dH, fuel_paper_error(g), g->inertia * e.J + 4 * UNIT * fuel->T};
    }
    return DOM_OK;
}

/* ---- Public ---- */

KERNEL enum dom_status fuel_find(const struct dom_train *train, struct dom_fuels *fuels,
                                 struct dom_fuels *error)
{
    struct lean g;
    struct fuel fuel, e;
    enum dom_status status = lean_make(train, &g);
    if (status == DOM_OK)
        status = energy_fuel(&g, &fuel, error ? &e : NULL);
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
    struct lean g;
    struct tilt head;
    struct sums at, e;
    struct fuel fuel, fuel_error;
    enum dom_status status = lean_make_tilted(train, theta, &g, &head);
    if (status == DOM_OK)
        status = chain_rise(&g, head, &at, error ? &e : NULL);
    if (status == DOM_OK)
        status = energy_fuel(&g, &fuel, error ? &fuel_error : NULL);
    if (status != DOM_OK)
        return status;
    *energy = (struct dom_energy){.dH = at.dH, .J = at.J, .J0 = 1 + fuel.T};
    if (error)
        *error = (struct dom_energy){.dH = e.dH, .J = e.J, .J0 = fuel_error.T + UNIT * (1 + fuel.T)};
    return DOM_OK;
}
