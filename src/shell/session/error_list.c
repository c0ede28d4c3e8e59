/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Descriptions of the errors of random rows. Only the errors of gaps and heights are missing, because they
 * belong to the effect 'placement'. To add an error, add it to DOM_ERRORS, its name to ERROR_EFFECTS, its
 * description here, and the way in which it changes a row to src/model/planning/draw.c.
 */
#include "session/effect_kinds.h"

static const char *const distributions[] = {"normal", "uniform", NULL};

#define SOURCE        "pseudo-random numbers of GSL: the generators taus2 and mrg"
#define PLAN          "many rows, verdicts only, on all processors"
#define NEEDS(effect) (1U << (effect))

/* Initialises the arguments that all errors have. */
#define SIZED(unit_, meaning_, highest_, usual_)                                                             \
    .source = SOURCE, .plan = PLAN,                                                                          \
    .argument = {{.name = "SIZE",                                                                            \
                  .unit = unit_,                                                                             \
                  .meaning = meaning_,                                                                       \
                  .lowest = 0,                                                                               \
                  .highest = (domq_real)(highest_),                                                          \
                  .usual = (domq_real)(usual_)},                                                             \
                 {.name = "LIMITS",                                                                          \
                  .unit = "",                                                                                \
                  .meaning = "whether the error is normal, and SIZE its standard deviation, or uniform "     \
                             "from -SIZE to SIZE",                                                           \
                  .lowest = 0,                                                                               \
                  .highest = 1,                                                                              \
                  .usual = 0,                                                                                \
                  .optional = true,                                                                          \
                  .words = distributions}}

const struct domq_effect error_effect_place = {
    .name = "error_place",
    .synonyms = "position tape",
    .adds = "random errors of the places of dominoes",
    .help = "Each domino stands off its place by an error of its own, and the dominoes after it keep their "
            "places, as if a tape measure had been used. In 'effect placement' an error of a gap moves all "
            "dominoes after it. Dominoes that would overlap touch.",
    SIZED("m", "error of every place", 1e9, 0.001),
    .needs = NEEDS(DOM_EFFECT_row),
};

const struct domq_effect error_effect_thickness = {
    .name = "error_thickness",
    .synonyms = "thick boards",
    .adds = "random errors of the thicknesses of dominoes",
    .help =
        "Each domino is thicker or thinner by an error of its own, which is a share of its thickness, "
        "such as 0.01 or 1 %. Gaps stay as they are, and so does the density, so that a thicker domino is "
        "heavier. A thickness is at least 1/100 of what it should be, twice the thickness of the "
        "walls and twice the radius of the edges.",
    SIZED("", "error of every thickness, as a share", 1, 0.01),
    .needs = NEEDS(DOM_EFFECT_row),
};

const struct domq_effect error_effect_mass = {
    .name = "error_mass",
    .synonyms = "weight density",
    .adds = "random errors of the masses of dominoes",
    .help = "Each domino is heavier or lighter by an error of its own, which is a share of its mass.",
    SIZED("", "error of every mass, as a share", 1, 0.05),
    .needs = NEEDS(DOM_EFFECT_row),
};

const struct domq_effect error_effect_lean = {
    .name = "error_lean",
    .synonyms = "plumb upright tilted",
    .adds = "dominoes that are not set up plumb, by random angles",
    .help = "Each domino leans forwards or backwards by an angle of its own, and rests on its front edge. A "
            "domino that would fall over by itself leans as far as it stands. Leans cannot be combined with "
            "rounded edges, or with the rigid-body engine.",
    SIZED("rad", "error of every lean", 1.5, 0.005),
    .needs = NEEDS(DOM_EFFECT_row),
};

const struct domq_effect error_effect_radius = {
    .name = "error_radius",
    .synonyms = "rounding bevels",
    .adds = "random errors of the radii of rounded edges",
    .help =
        "The edges of each domino have a radius with an error of its own, which is a share of the radius. "
        "A radius is at most half of the thickness.",
    SIZED("", "error of every radius, as a share", 1, 0.1),
    .needs = NEEDS(DOM_EFFECT_row) | NEEDS(DOM_EFFECT_edges),
};

const struct domq_effect error_effect_friction = {
    .name = "error_friction",
    .synonyms = "unknown",
    .adds = "an unknown friction between dominoes, the same for all",
    .help =
        "Nobody knows the friction between dominoes well. One error is drawn for each row, added to the "
        "coefficient of 'effect friction', and is the same for all its dominoes. A friction below 0 is 0.",
    SIZED("", "error of the friction coefficient", 100, 0.05),
    .needs = NEEDS(DOM_EFFECT_row),
};

const struct domq_effect error_effect_slope = {
    .name = "error_slope",
    .synonyms = "level uneven",
    .adds = "a floor that is not level, by a random angle",
    .help = "One angle is drawn for each row and added to that of 'effect slope'. A floor is never so steep "
            "that a domino falls over by itself.",
    SIZED("rad", "error of the slope of the floor", 1.5, 0.005),
    .needs = NEEDS(DOM_EFFECT_row),
};

const struct domq_effect error_effect_floor = {
    .name = "error_floor",
    .synonyms = "unknown slippery",
    .adds = "an unknown friction of the floor, the same for all dominoes",
    .help = "One error is drawn for each row and added to the friction of the floor, on which feet slip: "
            "'effect feet'. A friction below 0 is 0.",
    SIZED("", "error of the friction coefficient of the floor", 100, 0.05),
    .needs = NEEDS(DOM_EFFECT_row) | NEEDS(EFFECT_feet),
};

const struct domq_effect error_effect_push = {
    .name = "error_push",
    .synonyms = "finger",
    .adds = "a push that is not always as strong",
    .help = "One error is drawn for each row and added to the speed of 'effect push'. A speed below 0 is 0.",
    SIZED("rad/s", "error of the angular velocity of the first domino", 1e6, 0.5),
    .needs = NEEDS(DOM_EFFECT_row) | NEEDS(DOM_EFFECT_push),
};
