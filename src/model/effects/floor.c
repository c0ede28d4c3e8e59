/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The friction of the floor: its help; floor.c of the model computes it. */
#include "numerics/api.h"

const struct dom_effect dom_effect_floor = {
    .name = "floor",
    .synonyms = "feet foot slip slide slippery ground",
    .adds = "the friction that the floor needs so that no foot slips",
    .help =
        "With it, 'fall' and 'slip' report the friction coefficient that the floor needs so that no foot "
        "slips. The motion is computed for feet that do not slip: the answer says where a domino would first "
        "slip on a floor with MU. Newton's law for the centre of each block gives the force R of the floor "
        "at its hinge: mass times acceleration, minus gravity and the forces of the contacts. The hinge "
        "holds while |R_x|/R_z is below MU. In the collision the same holds for the impulses; for the struck "
        "domino the ratio is |1/2 - (1 + d^2)/(3 a)|/(d/2), which is 0 if the domino is hit at its centre of "
        "percussion. A domino that would be lifted needs more friction than any floor has.",
    .source = "Newton's law for a hinged block; the centre of percussion is textbook mechanics",
    .plan = "forces at samples, closer around the largest",
    .argument = {{.name = "MU",
                  .unit = "",
                  .meaning = "friction coefficient of the floor",
                  .lowest = 0,
                  .highest = (dom_real)1e6,
                  .usual = (dom_real)0.5}},
};
