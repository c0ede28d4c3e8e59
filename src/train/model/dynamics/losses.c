/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dynamics/losses.h"
#include "dynamics/energy_balance.h"
#include "dynamics/flow.h"
#include <stdlib.h>

/* ---- The collision ---- */

static enum dom_status losses_inertia_ratio(const struct geometry *next, const struct geometry *hitting,
                                            struct tilt at, real J, real *inertia_ratio)
{
    (void)J;
    struct equation_of_motion at_hit;
    const struct link rest = next->law->begin(next, geometry_rest(next)).link;
    const struct arms arms = next->law->arms(&rest);
    *inertia_ratio = 0;
    if (next->mu != 0 && !(arms.a > 0))
        return DOM_LOCKS;
    enum dom_status status = chain_equation(hitting, at, &at_hit);
    if (status == DOM_OK)
        *inertia_ratio = next->inertia * rest.contact.slope * at_hit.A * arms.ratio / next->upright_inertia;
    return status != DOM_OK || *inertia_ratio > 0 ? status : DOM_LOCKS;
}

/* ---- The law ---- */

/* Sets *slope to a number that has the sign of the derivative of the required energy. The number is du/dtheta
 * if `rough` is true, and -2 C otherwise. */
static enum dom_status losses_slope(const struct geometry *geometry, struct tilt head, bool rough,
                                    real *slope)
{
    struct equation_of_motion equation = {.C = 0};
    if (rough) {
        *slope = flow_solved_slope(geometry, tilt_angle(head));
        return DOM_OK;
    }
    enum dom_status status = chain_equation(geometry, head, &equation);
    *slope = -2 * equation.C;
    return status;
}

KERNEL enum dom_status losses_tipped(const struct geometry *geometry, real *omegasq)
{
    struct geometry alone = *geometry;
    alone.n = 1;
    real hi = tilt_angle(geometry->c), ln_G, u;
    enum dom_status status = flow_solve_piece(&alone, REAL_NAN, geometry_theta_u(geometry), &hi);
    if (status != DOM_OK)
        return status;
    flow_at(&alone, hi, &ln_G, &u);
    *omegasq = fmax(-exp(ln_G) * u, 0);
    return DOM_OK;
}

static enum dom_status losses_begin(struct geometry *geometry)
{
    geometry->flow = calloc(1, sizeof *geometry->flow);
    return geometry->flow ? DOM_OK : DOM_NO_MEMORY;
}

static void losses_end(struct geometry *geometry)
{
    flow_free(geometry->flow);
    geometry->flow = NULL;
}

static const struct dynamics losses = {
    .begin = losses_begin,
    .end = losses_end,
    .solve = flow_solve,
    .solve_piece = flow_solve_piece,
    .spent = flow_spent,
    .braked = flow_braked,
    .collide = flow_collide,
    .inertia_ratio = losses_inertia_ratio,
    .slope = losses_slope,
    .required_energy = flow_required,
    .required_energy_error = flow_required_error,
    .speed = flow_speed,
    .near_rest = flow_near_rest,
    .acceleration = equation_acceleration,
    .gain = flow_gain,
};
