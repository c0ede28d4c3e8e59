/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Walls: a domino is a hollow box with six walls and the mass of a solid block. Its moment of inertia is
 * larger (walls.h), and its centre of mass is the same.
 *
 * In a train, walls multiply all moments of inertia by the same factor. tau^2 includes this factor, so in
 * units of tau, a train moves just as it would without walls. Only the force of the floor changes. In a row,
 * the factors of two dominoes may differ.
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
    geometry->inertia_factor = walls_box(geometry->d, WALLS_WIDTH, value).inertia;
    return DOM_OK;
}
