/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Rounded edges. The equations of one contact are in geometry/rounded.h, and the sums over the chain are in
 * geometry/pass.c. A domino with rounded edges rolls, so its moment of inertia depends on its tilt. Let
 * I(theta) be the moment of inertia at the tilt theta. Then the inertia J of the chain, and the angular
 * velocity omega(0) of the head after the collision, follow from
 *
 *     J = sum over i of r^(-(q+1) i) I(theta_i) theta_i'^2,
 *     J(0) omega(0) = (J(0) - I(0)) omega_1.
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
