/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Rounded edges. geometry/rounded.h has the equations of one contact, and geometry/rolling.c the sums over
 * the chain. The law of motion is still that of energy_balance.c or friction.c. The inertia of a rolling
 * domino changes with its tilt, so J = sum r^-(q+1)i i(theta_i) theta_i'^2, and in the collision J(0)
 * omega(0) = (J(0) - i(0)) omega_1.
 */
#include "geometry/law.h"

/* Switches the effect on, with rho = value. */
KERNEL enum dom_status edges_apply(struct geometry *geometry, real value)
{
    enum dom_status status = rounded_make(geometry, value);
    const struct rounded *of = &geometry->rounded;
    /* As in slope.c, upright dominoes must be stable, but with rounded edges the centre of the block must be
     * above the flat part of the foot. */
    bool stands = geometry->g.along == 0 ||
                  (fabs(geometry->g.along) < of->wide * geometry->g.down && geometry->h.y > 0);
    return status == DOM_OK && !stands ? DOM_NO_STAND : status;
}
