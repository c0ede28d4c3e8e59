/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Slope: the floor falls by the angle alpha in the direction of the train, alpha > 0 downhill. Tilts are
 * measured from the normal of the floor. Contacts and inertia are as on a level floor; only gravity turns.
 * The potential energy of a domino is
 *
 *     h(theta) = cos(theta + alpha) + d sin(theta + alpha) = h.y cos theta + h.x sin theta,
 *     h.y = cos alpha + d sin alpha,   h.x = d cos alpha - sin alpha.
 *
 * A domino tips over at tan theta_u = h.x / h.y, alpha earlier than on a level floor. Upright dominoes are
 * stable only if |alpha| is less than theta_u of a level floor, tan theta_u = d.
 */
#include "geometry/geometry.h"

#ifdef KERNEL_TEXTS
const struct dom_effect dom_effect_slope = {
    .name = "slope",
    .synonyms = "alpha hill incline ramp tilt downhill uphill",
    .adds = "a floor that slopes, downhill where ALPHA > 0",
    .help = "An upright domino stands only where |ALPHA| is below theta_u, the angle at which it tips over, "
            "tan theta_u = d. One degree changes r_max by 5 to 8 %. Tilts are measured from the normal of "
            "the floor. The potential energy of a domino is then h(theta) = cos(theta + alpha) + d sin(theta "
            "+ alpha), in H, in the fuel P, in the barrier and in the forces; with friction C = 1/2 sum "
            "r^-qi S_i (sin(theta_i + alpha) - d cos(theta_i + alpha)). 'fuel paper' cannot be combined with "
            "a slope: there is no closed form of the fuel.",
    .source = "the potential energy of a block on an inclined plane",
    .plan = "the potential energy turned by alpha",
    .argument = {{.name = "ALPHA",
                  .unit = "rad",
                  .meaning = "angle by which the floor falls in the direction of the train",
                  .lowest = (dom_real)-1.5,
                  .highest = (dom_real)1.5,
                  .usual = (dom_real)0.0174532925199432957692}},
};
#endif

/* Turns the effect on: alpha = value, in radians. */
KERNEL enum dom_status slope_apply(struct geometry *geometry, real value)
{
    geometry_gravity(geometry, sin(value), cos(value));
    if (geometry->work)
        geometry->work->entered[DOM_EFFECT_slope]++;
    /* The domino must stand on the slope and on the opposite one, and tip over before it lies. */
    bool stands = tan(fabs(value)) < geometry->d && geometry->h.y > 0;
    return stands ? DOM_OK : DOM_NO_STAND;
}
