/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "effects/effects.h"

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
    .plan = "verdicts on many random rows, computed on all processors",
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
