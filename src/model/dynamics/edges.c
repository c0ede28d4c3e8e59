/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Rounded edges. geometry/rounded.h has the equations of one contact, and geometry/rolling.c the sums over
 * the chain. The inertia i(theta) of a rolling domino depends on its tilt. So the inertia of the chain, and
 * the angular velocity after the collision, follow from
 *
 *     J = sum r^-(q+1)i i(theta_i) theta_i'^2,
 *     J(0) omega(0) = (J(0) - i(0)) omega_1.
 */
#include "geometry/law.h"

/* Switches the effect on, with rho = value. */
KERNEL enum dom_status edges_apply(struct geometry *geometry, real value)
{
    enum dom_status status = rounded_make(geometry, value);
    const struct rounded *of = &geometry->rounded;
    /* Upright dominoes must be stable: their centre must be above the flat part of the foot. */
    bool stands = geometry->g.along == 0 ||
                  (fabs(geometry->g.along) < of->wide * geometry->g.down && geometry->h.y > 0);
    return status == DOM_OK && !stands ? DOM_NO_STAND : status;
}
