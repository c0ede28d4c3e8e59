/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "effects/effects.h"

const struct dom_effect dom_effect_push = {
    .name = "push",
    .synonyms = "start finger kick speed velocity",
    .adds = "a push on the first domino, which then starts upright",
    .help = "Without a push the first domino is let go at the angle at which it begins to tip over "
            "(tan theta_u = d), and the clock starts when it hits the second domino. With a push the "
            "first domino starts upright, or at the tilt of 'set release', and the clock starts with the "
            "push. A standard domino "
            "needs about 2.5 rad/s to tip over; with a weaker push the row stops at domino 1. If the "
            "first domino touches the second before it tips over, the row needs a push. OMEGA may also "
            "be the speed of the domino's upper edge, as in 'set push 0.5 m/s'; it then stays this speed if "
            "the domino becomes taller.",
    .source = "energy of a single domino, (6; b2) and (9; b5)",
    .plan = "omega^2 of the first domino",
    .argument = {{.name = "OMEGA",
                  .unit = "rad/s",
                  .meaning = "angular velocity of the first domino",
                  .lowest = 0,
                  .highest = (dom_real)1e6,
                  .usual = 5}},
    .needs = 1U << DOM_EFFECT_row,
};
