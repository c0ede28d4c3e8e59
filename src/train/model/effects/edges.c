/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Rounded edges. The equations of one contact are in geometry/rounded.c, and the sums over the chain are in
 * geometry/chain.c. A domino with rounded edges rolls, so its moment of inertia depends on its tilt. Let
 * I(theta) be the moment of inertia at the tilt theta. Then the inertia J of the chain, and the angular
 * velocity omega(0) of the head after the collision, follow from
 *
 *     J = sum over i of r^(-(q+1) i) I(theta_i) theta_i'^2,
 *     J(0) omega(0) = (J(0) - I(0)) omega_1.
 */
#include "effects/effects.h"
#include "geometry/chain.h"

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

const struct dom_effect dom_effect_edges = {
    .name = "edges",
    .synonyms = "rho rounded round radius corner bevel rolling foot",
    .adds = "rounded edges, on which dominoes roll as they tip over",
    .help =
        "The radius of the edges is RADIUS times the height; a length is the radius of domino 1. In a row "
        "from a file, each domino can have its own radius. The radius is at most half of the thickness. "
        "Edges rounded by 1 % of the height, like those of shop-bought dominoes, raise r_max by 4 to 8 % "
        "at separations from 0.2 to 0.4. The foot rolls on the floor without slipping, and the round upper "
        "edge of a follower slides down the flat back of its leader. The moment of inertia i is taken "
        "about the line of contact with the floor.",
    .source = "rigid bodies that roll and slide, after J. M. J. van Leeuwen, Domino Magnification",
    .equations =
        (const char *const[]){"l = 1 - 2 rho", "h(theta) = 2 rho + l cos theta + (d - 2 rho) sin theta",
                              "J = sum r^(-(q+1) i) i(theta_i) theta_i'^2",
                              "omega(0) = omega_1(theta_c) (J(0) - i(0))/J(0) in the collision",
                              "rho theta_c + l sin theta_c = r s", NULL},
    .argument = {{.name = "RADIUS",
                  .unit = "h",
                  .meaning = "radius of the edges divided by the height",
                  .lowest = 0,
                  .highest = (dom_real)49 / 100,
                  .usual = (dom_real)0.01}},
};
