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

#ifdef KERNEL_TEXTS
const struct dom_effect dom_effect_walls = {
    .name = "walls",
    .synonyms = "box hollow boards plywood inertia shell",
    .adds = "the moment of inertia of boxes of six walls",
    .help =
        "Without it a domino is a solid block, also where 'q' is hollow. A train has dominoes of one shape, "
        "each with walls of the same share of its height: only times change, since the moment of inertia is "
        "in tau alone; thin walls take 2.8 % longer. In a row all dominoes are boxes of the same boards, of "
        "THICKNESS times the height of the first domino, or of a length such as 'effect walls 12 mm': "
        "inertia and masses that follow from a density are those of the boxes. Walls of half of the "
        "thickness make a solid block. A domino is half as wide as tall. The moment of inertia about the "
        "lower edge is that of a solid block of the same mass, times 1 + v (1 - u)/(4 (1 - v)), with the "
        "volume of the hollow v = (1 - 2 t)(1 - 2 t/d)(1 - 4 t), and u = ((1 - 2 t)^2 + (d - 2 t)^2)/(1 + "
        "d^2).",
    .source = "moments of inertia of two blocks, one cut out of the other; the parallel axis",
    .plan = "one factor of the moment of inertia, in closed form",
    .argument = {{.name = "THICKNESS",
                  .unit = "h",
                  .meaning = "thickness of the walls over the height of the domino, or a length",
                  .lowest = (dom_real)1 / 1000000000,
                  .highest = 1,
                  .usual = (dom_real)1 / 48}},
    .cancels = true,
};
#endif

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
