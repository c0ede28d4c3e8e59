/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The effects that change no law of motion: the floor, and what a row of its own has. */
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
    .argument = {{.name = "MU",
                  .unit = "",
                  .meaning = "friction coefficient of the floor",
                  .lowest = 0,
                  .highest = (dom_real)1e6,
                  .usual = (dom_real)0.5}},
};

const struct dom_effect dom_effect_row = {
    .name = "row",
    .synonyms = "file csv load measurements list finite spacing",
    .adds = "a finite row of dominoes, equal or not, instead of the endless train",
    .help =
        "With a number N, domino k is h r^(k-1) tall, the gap before it is s times its height, "
        "and its mass follows from q. FILE is a csv file with a line for each domino and the "
        "columns height, thickness, gap (or pitch, or position) and, if known, mass or density. Units "
        "are written in the first line, as in 'height (mm)', or in the cells. The row starts with a "
        "push ('set push'), from a tilt ('set release'), or with its first domino at the point of tipping "
        "over. 'fall' runs the row. "
        "Domino j leans on domino k = j + 1. If an upper edge would pass above the next domino, or if a "
        "contact would have to pull, the model does not apply, and the output ends with a message.",
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
    .synonyms = "slanted tilted tilt start angle lean held rest let go",
    .adds = "a first domino that is held at a tilt and released",
    .help =
        "The first domino is held at the tilt ANGLE and let go; it starts at rest, unless 'set push' gives "
        "it an angular velocity there. The clock starts at the release. 'set release touch' holds the "
        "domino against the second one, just at the contact: then both start at rest, and the weight of "
        "the first domino alone has to push the second one over. ANGLE must not be larger than the tilt "
        "at which the two touch. If ANGLE is smaller than the tilt at which the domino tips over "
        "(tan theta_u = d with sharp edges on a level floor), it falls back.",
    .source = "energy balance from a first domino at rest, as in (9; b5)",
    .argument = {{.name = "ANGLE",
                  .unit = "rad",
                  .meaning = "tilt of the first domino when it is released",
                  .lowest = 0,
                  .highest = (dom_real)1.5707963267948966,
                  .usual = (dom_real)0.3490658503988659}},
    .needs = 1U << DOM_EFFECT_row,
};

/* The words for the distribution of errors, indexed by the member `uniform` of struct dom_random_error. */
static const char *const distributions[] = {"normal", "uniform", NULL};

const struct dom_effect dom_effect_placement = {
    .name = "placement",
    .synonyms = "probability chance errors precision accuracy error_gap error_height gaps heights",
    .adds = "random errors in the gaps, and in the heights if HEIGHTS is given",
    .help = "The row is set up many times. Each gap has a normally distributed error with the "
            "standard deviation SIGMA, which is a length, and each height has a relative error with "
            "the standard deviation HEIGHTS. If LIMITS is 'uniform', SIGMA and HEIGHTS are limits, "
            "and all errors within them are equally likely. Dominoes that would overlap are moved "
            "until they touch. 'placement' counts how often all dominoes fall, gives the exact 95 "
            "% interval of Clopper and Pearson, and reports where rows stop. 'budget' finds the "
            "SIGMA at which a given share of the rows falls. With the same 'seed', row number i "
            "is always the same, with any number of 'threads'. Other errors have separate "
            "effects: error_place, error_thickness, error_mass, error_lean and error_radius for "
            "each domino, and error_friction, error_slope, error_floor and error_push for the "
            "whole row.",
    .source = "C. J. Clopper and E. S. Pearson, Biometrika 26, 404 (1934), for the interval; "
              "pseudo-random numbers from GSL",
    .argument = {{.name = "SIGMA",
                  .unit = "m",
                  .meaning = "standard deviation of every gap",
                  .lowest = 0,
                  .highest = (dom_real)1e9,
                  .usual = (dom_real)1 / 1000},
                 {.name = "HEIGHTS",
                  .unit = "",
                  .meaning = "relative standard deviation of every height",
                  .lowest = 0,
                  .highest = 1,
                  .usual = 0,
                  .optional = true},
                 {.name = "LIMITS",
                  .unit = "",
                  .meaning = "distribution of the errors: normal, or uniform within limits",
                  .lowest = 0,
                  .highest = 1,
                  .usual = 0,
                  .optional = true,
                  .words = distributions}},
};
