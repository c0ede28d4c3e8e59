/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The floor's friction: what it is; floor.c of the model finds it. */
#include "numerics/api.h"

const struct dom_effect dom_effect_floor = {
    .name = "floor",
    .adds = "what friction the floor needs so that no hinge slips",
    .help =
        "Newton's law for the middle of each block, less gravity and its contacts, is the force R of the "
        "floor at "
        "its hinge: the hinge holds while |R_x|/R_z is below the floor's friction. In the collision the same "
        "holds of the impulses; for the struck domino that is |1/2 - (1 + d^2)/(3 a)|/(d/2), 0 where it is "
        "hit "
        "at its centre of percussion. A domino that would be lifted needs more than any floor has. The "
        "motion "
        "itself stays that of hinges: the answer says where a real floor would let a domino slip first.",
    .source = "Newton's law for a hinged block; the centre of percussion is textbook mechanics",
    .plan = "forces at samples, closer around the largest",
    .argument = {{.name = "MU",
                  .unit = "",
                  .meaning = "friction coefficient of the floor",
                  .lowest = 0,
                  .highest = (dom_real)1e6,
                  .usual = (dom_real)0.5}},
};
