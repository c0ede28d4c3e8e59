/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Walls: a domino is a hollow box with six walls. Its moment of inertia is larger than that of a solid block
 * with the same mass (walls.h), and its centre of mass is the same.
 *
 * In a train, walls multiply all moments of inertia by the same factor. The time scale tau contains this
 * factor: tau^2 is proportional to it. So in units of tau, a train moves just as it would without walls, and
 * only the force of the floor changes. In a row, the factor may differ from domino to domino.
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
    geometry->inertia_factor = walls_box(geometry->d, geometry->width, value).inertia;
    return DOM_OK;
}
