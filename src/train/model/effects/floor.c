/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "effects/effects.h"

const struct dom_effect dom_effect_floor = {
    .name = "floor",
    .synonyms = "feet foot slip slide slippery ground",
    .adds = "the friction that the floor needs so that no foot slips",
    .help = "With this effect, answers report the friction coefficient that the floor "
            "needs so that no foot slips, and which domino would slip first on a floor with the "
            "friction coefficient MU. The motion is computed for feet that do not slip. Newton's law "
            "for the centre of each block gives the force R of the floor on its foot: mass times "
            "acceleration, minus gravity and the contact forces. The foot does not slip while "
            "|R_x|/R_z is below MU. In the collision the same holds for the impulses; for the struck "
            "domino the ratio is |1/2 - (1 + d^2)/(3 a)|/(d/2), which is 0 if the domino is hit at "
            "its centre of percussion. If a domino would be lifted off the floor, no amount of "
            "friction is enough.",
    .source = "Newton's law for a hinged block; the centre of percussion is textbook mechanics",
    .plan = "forces at sampled tilts, with denser samples where the required friction is largest",
    .argument = {{.name = "MU",
                  .unit = "",
                  .meaning = "friction coefficient of the floor",
                  .lowest = 0,
                  .highest = (dom_real)1e6,
                  .usual = (dom_real)0.5}},
};
