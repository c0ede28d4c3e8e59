/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random errors of placement: what they are; placement.c of the model draws them. */
#include "numerics/api.h"

const struct dom_effect dom_effect_placement = {
    .name = "placement",
    .adds = "random errors of the gaps, and of the heights if asked for",
    .help = "The row is set up again and again, each gap with a normal error of its own of standard "
            "deviation SIGMA (a "
            "length), each height, where HEIGHTS is given, with a relative one; dominoes that would overlap "
            "touch. "
            "'placement' counts how often all fall, with the exact 95 % interval of Clopper and Pearson, and "
            "where "
            "rows stop; 'budget' finds the SIGMA that a probability allows. Row number i is the same for the "
            "same "
            "'seed', whatever 'threads' is.",
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
