/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Rounded edges: geometry/rounded.h has the equations of one contact, geometry/rolling.c the sums over the
 * chain. The law of motion is the energy balance, or friction. The inertia of a domino changes with its tilt:
 * J = sum r^-(q+1)i i(theta_i) theta_i'^2, and in the collision J(0) omega(0) = (J(0) - i(0)) omega_1.
 */
#include "dynamics/energy_balance.h"
#include "geometry/rounded.h"

#ifdef KERNEL_TEXTS
const struct dom_effect dom_effect_edges = {
    .name = "edges",
    .synonyms = "rho rounded round radius corner bevel rolling foot",
    .adds = "edges rounded with a radius, which roll on the floor",
    .help = "The radius of the edges is RADIUS times the height, the same share for each domino of a train; "
            "a file of a row may give each domino a radius of its own. It is at most half of the thickness. "
            "Edges rounded by 1 % of the height, as dominoes on sale have them, raise r_max by about 7 %. "
            "The foot rolls on the floor without slipping, and the round upper edge of a follower slides "
            "down the flat back of its leader. With l = 1 - 2 rho the potential energy of a domino is "
            "h(theta) = 2 rho + l cos theta + (d - 2 rho) sin theta. The inertia is that about the line of "
            "contact with the floor: J = sum r^-(q+1)i i(theta_i) theta_i'^2, and the collision keeps (J(0) "
            "- i(0))/J(0) of the angular velocity. The head hits the next domino where rho theta_c + l sin "
            "theta_c = r s. No error bounds are known, and growths are sampled, as with friction. 'fuel "
            "paper' cannot be combined with rounded edges: there is no closed form of the fuel.",
    .source = "rigid bodies that roll and slide, after J. M. J. van Leeuwen, Domino Magnification",
    .plan = "contacts by Newton's method, inertia i(theta)",
    .argument = {{.name = "RADIUS",
                  .unit = "h",
                  .meaning = "radius of the edges over the height",
                  .lowest = 0,
                  .highest = (dom_real)0.49,
                  .usual = (dom_real)0.01}},
};
#endif

/* Turns the effect on: rho = value. */
KERNEL enum dom_status edges_apply(struct geometry *geometry, real value)
{
    enum dom_status status = rounded_edges(geometry, value);
    const struct rounded *of = &geometry->rounded;
    if (geometry->dynamics->conservative)
        geometry->dynamics = &rounded_balance;
    /* As in slope.c; the flat part of the foot must hold the centre of the block. */
    bool stands = geometry->g.along == 0 ||
                  (fabs(geometry->g.along) < of->wide * geometry->g.down && geometry->h.y > 0);
    return status == DOM_OK && !stands ? DOM_NO_STAND : status;
}
