/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The effects that change no law of motion: a row, and how it starts. */
#include "effects/effects.h"

const struct dom_effect dom_effect_row = {
    .name = "row",
    .synonyms = "file csv load measurements list finite spacing",
    .adds = "a finite row of dominoes, equal or not, instead of the endless train",
    .help = "With a number N, domino k is h r^(k-1) tall, the gap before it is s times its height, and its "
            "mass follows from q. FILE is a csv file with a line for each domino and the columns height, "
            "thickness, gap (or pitch, or position) and, if known, mass or density. Units are written in the "
            "first line, as in 'height (mm)', or in the cells. The row starts with a push ('set push'), from "
            "a tilt ('set release'), or with its first domino at the point of tipping over. 'fall' runs the "
            "row. In the equations, domino j leans on domino k = j + 1.",
    .source = "energy balance and collision of the paper, (19; c1) to (22; c4), for dominoes of any sizes",
    .equations =
        (const char *const[]){"h_j sin(theta_j - theta_k) = (gap_k + d_k) cos theta_k - d_k",
                              "H = sum m g (h cos theta + d sin theta)/2", "J = sum I theta'^2",
                              "omega_k(0) = omega_j T/(1 + T), T = J of the dominoes before k / I_k", NULL},
    .argument = {{.name = "N",
                  .unit = "",
                  .meaning = "number of dominoes",
                  .lowest = 1,
                  .highest = 100000,
                  .usual = 20,
                  .whole = true,
                  .or_file = "a csv file of dominoes"}},
};

const struct dom_effect dom_effect_push = {
    .name = "push",
    .synonyms = "start finger kick tip speed velocity",
    .adds = "a push on the first domino, which then starts upright",
    .help = "The first domino starts upright, or at the tilt of 'set release', and the clock starts with the "
            "push. A standard domino needs about 2.5 rad/s to tip over. OMEGA may also be the speed of the "
            "upper edge, as in 'set push 0.5 m/s', which stays the same if the domino becomes taller. "
            "Without a push the first domino is let go where it begins to tip over (tan theta_u = d), and "
            "the clock starts when it hits the second one. If the two touch before that, the row needs a "
            "push.",
    .source = "energy of a single domino, (6; b2) and (9; b5)",
    .argument = {{.name = "OMEGA",
                  .unit = "rad/s",
                  .meaning = "angular velocity of the first domino",
                  .lowest = 0,
                  .highest = (dom_real)1e6,
                  .usual = 5}},
    .needs = 1U << DOM_EFFECT_row,
};

const struct dom_effect dom_effect_release = {
    .name = "release",
    .synonyms = "slanted tilted tilt tip start angle lean held rest let go",
    .adds = "a first domino that is held at a tilt and released",
    .help =
        "The first domino is held at the tilt ANGLE and let go, and the clock starts. The domino starts "
        "at rest, unless 'set push' gives it an angular velocity there. With 'set release touch' it leans "
        "against the second domino, which it has to push over by its weight alone. If ANGLE is smaller "
        "than the tilt at which the domino tips over (tan theta_u = d with sharp edges on a level floor), "
        "it falls back.",
    .source = "energy balance from a first domino at rest, as in (9; b5)",
    .argument = {{.name = "ANGLE",
                  .unit = "rad",
                  .meaning = "tilt of the first domino when it is released",
                  .lowest = 0,
                  .highest = (dom_real)1.5707963267948968, /* 90 deg, rounded up */
                  .usual = (dom_real)0.3490658503988659}},
    .needs = 1U << DOM_EFFECT_row,
};
