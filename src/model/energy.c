/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "energy.h"

double energy_fuel_paper(const struct lean *g)
{
    double s = g->s, d = g->d;
    /* 1 - h(theta_f) = sin theta_f (tan(theta_f / 2) - d). */
    if (g->falls_off)
        return g->f.x * (g->f.x / (1 + g->f.y) - d);
    /* 1 - h(theta_inf), rationalized: it keeps its digits near P = 0, s = 2 d^3 / (1 - d^2). */
    return s * fma(s, (1 - d) * (1 + d), -2 * d * d * d) / (g->L * (s + d * g->L * g->inf.x));
}

enum dom_status energy_fuel(const struct lean *g, struct dom_fuels *fuels, double *T)
{
    struct sums at_c;
    enum dom_status status = chain_rise(g, g->c, CHAIN_ENDLESS, &at_c);
    if (status != DOM_OK)
        return status;
    *T = g->inertia * at_c.J;
    *fuels = (struct dom_fuels){.exact = -at_c.dH, .paper = energy_fuel_paper(g)};
    return DOM_OK;
}

enum dom_status dom_fuel_find(const struct dom_train *train, struct dom_fuels *fuels)
{
    struct lean g;
    double T;
    enum dom_status status = lean_make(train, &g);
    return status == DOM_OK ? energy_fuel(&g, fuels, &T) : status;
}

enum dom_status dom_energy_find(const struct dom_train *train, double theta, struct dom_energy *energy)
{
    struct lean g;
    struct tilt head;
    struct sums at, at_c;
    enum dom_status status = lean_make_tilted(train, theta, &g, &head);
    if (status == DOM_OK)
        status = chain_rise(&g, head, CHAIN_ENDLESS, &at);
    if (status == DOM_OK)
        status = chain_sum(&g, g.c, CHAIN_ENDLESS, &at_c);
    if (status == DOM_OK)
        *energy = (struct dom_energy){.dH = at.dH, .J = at.J, .J0 = 1 + g.inertia * at_c.J};
    return status;
}
