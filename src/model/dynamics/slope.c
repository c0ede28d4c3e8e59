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
#include "geometry/law.h"

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
