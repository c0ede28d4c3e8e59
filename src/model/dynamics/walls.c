/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Walls: a domino is a hollow box with six walls rather than a solid block of the same mass. The moment of
 * inertia of the box is larger (walls.h), and its centre of mass is the same. In a train, walls multiply all
 * moments of inertia by the same factor. tau^2 includes this factor, so in units of tau, a train moves
 * exactly as without walls. Only the force of the floor depends on the factor. In a row, two dominoes have
 * different factors if their shapes differ, or if their sizes differ but their walls are equally thick.
 */
#include "dynamics/walls.h"
#include "geometry/geometry.h"

/* Switches the effect on; value is the thickness of the walls, relative to the height. */
KERNEL enum dom_status walls_apply(struct geometry *geometry, real value)
{
    if (geometry->work)
        geometry->work->entered[DOM_EFFECT_walls]++;
    if (!walls_fit(geometry->d, value))
        return DOM_NO_ROOM;
    geometry->box = walls_box(geometry->d, WALLS_WIDTH, value).inertia;
    return DOM_OK;
}
