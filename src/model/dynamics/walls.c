/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Walls: a domino is a box of six walls, not a solid block of the same mass. Its moment of inertia is larger
 * (walls.h), its centre is the same. In a train all are larger by one factor, which is a part of tau^2 and so
 * of the unit of time: in units of tau a train moves as without walls. Only the force of the floor, mass
 * times the acceleration of the centre, sees the factor. In a row, dominoes of unequal shape, or of the same
 * boards, have factors of their own.
 */
#include "dynamics/walls.h"
#include "geometry/geometry.h"

/* Turns the effect on: walls = value, over the height. */
KERNEL enum dom_status walls_apply(struct geometry *geometry, real value)
{
    if (geometry->work)
        geometry->work->entered[DOM_EFFECT_walls]++;
    if (!walls_fit(geometry->d, value))
        return DOM_NO_ROOM;
    geometry->box = walls_box(geometry->d, WALLS_WIDTH, value).inertia;
    return DOM_OK;
}
