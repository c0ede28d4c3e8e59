/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random errors of placement: their help; placement.c of the model draws them. */
#include "numerics/api.h"

const struct dom_effect dom_effect_placement = {
    .name = "placement",
    .synonyms = "probability chance errors precision accuracy",
    .adds = "random errors of the gaps, and of the heights if HEIGHTS is given",
    .help = "The row is set up again and again. Each gap has a normal error of its own with the standard "
            "deviation SIGMA, which is a length; each height has a relative error with the standard "
            "deviation HEIGHTS. Dominoes that would overlap touch. 'placement' counts how often all dominoes "
            "fall, with the exact 95 % interval of Clopper and Pearson, and reports where rows stop. "
            "'budget' finds the SIGMA that a probability allows. Row number i is the same for the same "
            "'seed', with any number of 'threads'.",
    .source =
        "C. J. Clopper and E. S. Pearson, Biometrika 26, 404 (1934), for the interval; generators of GSL",
    .plan = "many rows, verdicts only, on all processors",
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
                  .optional = true}},
    .needs = 1U << DOM_EFFECT_row,
};
