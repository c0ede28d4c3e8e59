/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "collision.h"

enum dom_status collision_launch(const struct lean *g, enum dom_fuel fuel, struct dom_launch *launch)
{
    struct dom_fuels fuels;
    double T;
    enum dom_status status = energy_fuel(g, &fuels, &T);
    if (status != DOM_OK)
        return status;
    double P = fuel == DOM_FUEL_PAPER ? fuels.paper : fuels.exact;
    double J0 = 1 + T;
    /* (c6) with r^q J(0) - J(0) + 1 = r^q + T (r^q - 1): terms of one sign. */
    double kinetic = P * T / (g->rq + T * g->rq_1);
    *launch = (struct dom_launch){.fuel = P, .J0 = J0, .omegasq = kinetic / J0, .kinetic = kinetic};
    return isfinite(kinetic) ? DOM_OK : DOM_NOT_FINITE;
}

enum dom_status dom_launch_find(const struct dom_train *train, struct dom_launch *launch)
{
    struct lean g;
    enum dom_status status = lean_make(train, &g);
    if (status == DOM_OK)
        status = collision_launch(&g, train->fuel, launch);
    if (status != DOM_OK || launch->fuel > 0)
        return status;
    launch->omegasq = launch->kinetic = DOM_NAN;
    return DOM_NO_FUEL;
}
