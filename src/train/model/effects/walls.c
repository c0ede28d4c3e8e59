/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Walls: a domino is a hollow box with six walls. Its moment of inertia is larger than that of a solid block
 * with the same mass, and its centre of mass is the same.
 *
 * In a train, walls multiply all moments of inertia by the same factor. The time scale tau contains this
 * factor: tau^2 is proportional to it. So in units of tau, a train moves just as it would without walls, and
 * only the force of the floor changes. In a row, the factor may differ from domino to domino.
 *
 * Let d be the thickness of the domino, w its width and t the thickness of a wall, all relative to the
 * height. The hollow is smaller than the box by these fractions of the height, the thickness and the width:
 *
 *     a = 2 t,   b = 2 t / d,   c = 2 t / w.
 *
 * The hollow fills the fraction v = (1 - a) (1 - b) (1 - c) of the box. By the parallel axis theorem, the
 * moment of inertia about the lower edge, relative to a solid block of the same mass, is
 *
 *     1 + v (1 - u) / (4 (1 - v)),   u = [(1 - a)^2 + d^2 (1 - b)^2] / (1 + d^2).
 */
#include "effects/effects.h"

enum dom_status dom_box_find(dom_real height, dom_real thickness, dom_real width, dom_real walls,
                             struct dom_box *box)
{
    const real d = thickness / height, t = walls / height;
    /* Two walls may be as thick as the domino, apart from rounding errors. */
    if (!(height > 0 && width > 0 && t > 0 && 2 * t <= d * (1 + 8 * REAL_EPSILON)))
        return DOM_NO_ROOM;
    /* If walls meet, there is no hollow. */
    const real a = fmin(2 * t, 1), b = fmin(2 * t / d, 1), c = fmin(2 * t / (width / height), 1);
    const real filled = a + (1 - a) * (b + (1 - b) * c), v = (1 - a) * (1 - b) * (1 - c),
               smaller = (a * (2 - a) + d * d * b * (2 - b)) / (1 + d * d); /* 1 - u without cancellation */
    *box = (struct dom_box){filled, 1 + v * smaller / (4 * filled)};
    return DOM_OK;
}

/* Switches the effect on; value is the thickness of the walls, relative to the height. */
KERNEL enum dom_status walls_apply(struct geometry *geometry, real value)
{
    struct dom_box box;
    const enum dom_status status = dom_box_find(1, geometry->d, geometry->width, value, &box);
    if (status == DOM_OK)
        geometry->inertia_factor = box.inertia;
    return status;
}

const struct dom_effect dom_effect_walls = {
    .name = "walls",
    .synonyms = "box hollow boards plywood inertia shell",
    .adds = "the moment of inertia of boxes made of six walls",
    .help = "Without this effect, the moment of inertia is that of a solid block, even if 'q' is hollow. In "
            "a train, THICKNESS is the same fraction of the height for every domino. The walls then change "
            "only tau, the unit of time, and the friction that the floor needs: with thin walls, the times "
            "of the standard domino are 2.8 % longer.\n\n"
            "In a row, all dominoes are made of the same boards: THICKNESS times the height of the first "
            "domino, or a length, as in 'set walls 12 mm'. With ABOVE, as in 'set walls 12 mm 30 cm', only "
            "the dominoes that are taller are boxes. The endless train then consists of solid dominoes, and "
            "unless the row comes from a file, masses follow from the volumes, whatever 'q' is. Masses "
            "computed from a density are those of the boards.\n\n"
            "v is the part of the volume that is hollow, and w the width divided by the height, which is 1/2 "
            "unless 'set width' or the file of a row gives it. I is taken about the lower edge.",
    .source = "moment of inertia of a block with a smaller block cut out, and the parallel-axis theorem",
    .equations = (const char *const[]){"I = I_solid (1 + v (1 - u)/(4 (1 - v)))",
                                       "v = (1 - 2 t)(1 - 2 t/d)(1 - 2 t/w)",
                                       "u = ((1 - 2 t)^2 + (d - 2 t)^2)/(1 + d^2)", NULL},
    .argument = {{.name = "THICKNESS",
                  .unit = "h",
                  .meaning = "thickness of the walls divided by the height of the domino, or a length",
                  .lowest = (dom_real)1 / 1000000000,
                  .highest = 1,
                  .usual = (dom_real)1 / 48},
                 {.name = "ABOVE",
                  .unit = "m",
                  .meaning = "height; in a row, only taller dominoes are boxes",
                  .lowest = 0,
                  .highest = (dom_real)1e9,
                  .usual = 0,
                  .optional = true}},
    .cancels = true,
};
