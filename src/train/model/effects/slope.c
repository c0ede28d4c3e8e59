/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Slope: the floor slopes down at the angle alpha in the direction of the train. If alpha is negative, the
 * train goes uphill. Tilts are measured from the normal to the floor. So the only difference from a level
 * floor is the direction of gravity. The potential energy of a domino is
 *
 *     h(theta) = cos(theta + alpha) + d sin(theta + alpha) = h.y cos theta + h.x sin theta,
 *     h.y = cos alpha + d sin alpha,   h.x = d cos alpha - sin alpha.
 *
 * A domino tips over at the tilt theta_u, where tan theta_u = h.x / h.y. The tilt theta_u is smaller by alpha
 * than on a level floor. Upright dominoes are stable only if |alpha| < atan d.
 */
#include "effects/effects.h"
#include "geometry/chain.h"

/* Switches the effect on, with alpha = value in radians. */
KERNEL enum dom_status slope_apply(struct geometry *geometry, real value)
{
    geometry_gravity(geometry, sin(value), cos(value));
    /* An upright domino must not tip over by itself, forwards or backwards, so tan |alpha| must be less than
     * d. A falling domino must reach its balance point theta_u before it lies flat. This requires
     * theta_u < 90 degrees, so h.y must be positive. */
    bool stands = tan(fabs(value)) < geometry->d && geometry->h.y > 0;
    return stands ? DOM_OK : DOM_NO_STAND;
}

const struct dom_effect dom_effect_slope = {
    .name = "slope",
    .synonyms = "alpha hill incline ramp tilt downhill uphill",
    .adds = "a sloping floor, downhill if ALPHA > 0",
    .help = "A domino can stand upright only if |ALPHA| is less than theta_u, the angle at which it tips "
            "over (tan theta_u = d with sharp edges). At separations from 0.2 to 0.4, one degree downhill "
            "raises r_max by 4 to 8 %, and one degree uphill lowers it by 3 to 6 %. Tilts are measured from "
            "the normal to the floor, so the slope changes only the potential energy h of a domino, and with "
            "it H, the fuel P, the barrier and the forces.",
    .source = "the potential energy of a block on an inclined plane",
    .equations = (const char *const[]){"h(theta) = cos(theta + alpha) + d sin(theta + alpha)",
                                       "x_i = sin(theta_i + alpha), y_i = cos(theta_i + alpha) in C", NULL},
    .argument = {{.name = "ALPHA",
                  .unit = "rad",
                  .meaning = "angle of the floor, positive if it slopes down in the direction of the train",
                  .lowest = (dom_real)-1.5,
                  .highest = (dom_real)1.5,
                  .usual = (dom_real)0.0174532925199432957692}},
};
