/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How a row starts. */
#include "numerics/api.h"

const struct dom_effect dom_effect_push = {
    .name = "push",
    .adds = "the first domino is pushed upright, not tipped over",
    .help = "Without it the first domino stands on its edge, at theta_u with tan theta_u = d (b1), and is "
            "let go; its "
            "time is counted from its first hit. With it the clock starts at the push. A push too weak to "
            "carry it "
            "over its edge is a verdict; where it touches the next before it tips over, it needs one.",
    .source = "energy of a single domino, (b2) and (b5)",
    .plan = "omega^2 of the first domino",
    .argument = {{.name = "OMEGA",
                  .unit = "rad/s",
                  .meaning = "angular velocity of the first domino",
                  .lowest = 0,
                  .highest = (dom_real)1e6,
                  .usual = 5}},
    .needs = 1U << DOM_EFFECT_row,
};
