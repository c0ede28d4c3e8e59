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
#include "geometry/law.h"

/* Switches the effect on, with alpha = value in radians. */
KERNEL enum dom_status slope_apply(struct geometry *geometry, real value)
{
    geometry_gravity(geometry, sin(value), cos(value));
    if (geometry->work)
        geometry->work->entered[DOM_EFFECT_slope]++;
    /* An upright domino must not tip over by itself, forwards or backwards, so tan |alpha| must be less than
     * d. A falling domino must reach its balance point theta_u before it lies flat. This requires
     * theta_u < 90 degrees, so h.y must be positive. */
    bool stands = tan(fabs(value)) < geometry->d && geometry->h.y > 0;
    return stands ? DOM_OK : DOM_NO_STAND;
}
