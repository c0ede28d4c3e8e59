/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Rounded edges: geometry/rounded.h has the equations of one contact, geometry/rolling.c the sums over the
 * chain. The law of motion is the energy balance, or friction. The inertia of a domino changes with its tilt:
 * J = sum r^-(q+1)i i(theta_i) theta_i'^2, and in the collision J(0) omega(0) = (J(0) - i(0)) omega_1.
 */
#include "geometry/law.h"

/* Turns the effect on: rho = value. */
KERNEL enum dom_status edges_apply(struct geometry *geometry, real value)
{
    enum dom_status status = rounded_make(geometry, value);
    const struct rounded *of = &geometry->rounded;
    /* As in slope.c; the flat part of the foot must hold the centre of the block. */
    bool stands = geometry->g.along == 0 ||
                  (fabs(geometry->g.along) < of->wide * geometry->g.down && geometry->h.y > 0);
    return status == DOM_OK && !stands ? DOM_NO_STAND : status;
}
