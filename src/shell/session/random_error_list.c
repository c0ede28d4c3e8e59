/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The effects that give rows random errors. Errors in gaps and heights are not here, but in the effect
 * 'placement'. To add a kind of error, add it to DOM_ERRORS and ERROR_EFFECTS, describe it in this file, and
 * apply it to a row in src/chance/model/draw.c. */
#include "session/effect_kinds.h"

static const char *const distributions[] = {"normal", "uniform", NULL};

#define SOURCE        "pseudo-random numbers from GSL: the generators taus2 and mrg"
#define PLAN          "many rows, verdicts only, on all processors"
#define NEEDS(effect) (1U << (effect))

/* Initialises the members that all kinds of random error have: the source, the plan and the two arguments
 * SIZE and LIMITS. */
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
                  .meaning = "distribution of the error: normal with the standard deviation SIZE, or "       \
                             "uniform from -SIZE to SIZE",                                                   \
                  .lowest = 0,                                                                               \
                  .highest = 1,                                                                              \
                  .usual = 0,                                                                                \
                  .optional = true,                                                                          \
                  .words = distributions}}

const struct domq_effect error_effect_place = {
    .name = "error_place",
    .synonyms = "position tape",
    .adds = "random errors in the positions of dominoes",
    .help =
        "Each domino after the first is out of position by a separate random error. An error moves only one "
        "domino, as if all positions had been measured with one tape. In 'set placement', by contrast, an "
        "error in a gap moves all dominoes after it. Dominoes that would overlap are moved until they touch.",
    SIZED("m", "error in each position", 1e9, 0.001),
};

const struct domq_effect error_effect_thickness = {
    .name = "error_thickness",
    .synonyms = "thick boards",
    .adds = "random errors in the thicknesses of dominoes",
    .help = "Each domino is thicker or thinner by a separate random error, given as a fraction of its "
            "thickness, such as 0.01 or 1 %. Gaps and the density do not change, so a thicker domino is "
            "heavier. No domino becomes thinner than twice the thickness of the walls, twice the radius of "
            "the edges, or 1/100 of its intended thickness.",
    SIZED("", "error in each thickness, as a fraction of the thickness", 1, 0.01),
};

const struct domq_effect error_effect_mass = {
    .name = "error_mass",
    .synonyms = "weight density",
    .adds = "random errors in the masses of dominoes",
    .help = "Each domino is heavier or lighter by a separate random error, given as a fraction of its mass.",
    SIZED("", "error in each mass, as a fraction of the mass", 1, 0.05),
};

const struct domq_effect error_effect_lean = {
    .name = "error_lean",
    .synonyms = "plumb upright tilted",
    .adds = "dominoes that are off plumb by random angles",
    .help = "Each domino leans forwards or backwards by a separate random angle, as if its floor or its foot "
            "were not flat. When it falls, it turns about its front edge. A domino that would fall over by "
            "itself gets the largest lean at which it still stands. This effect cannot be combined with "
            "rounded edges or with the rigid-body engine.",
    SIZED("rad", "error in each lean", 1.5, 0.005),
};

const struct domq_effect error_effect_radius = {
    .name = "error_radius",
    .synonyms = "rounding bevels",
    .adds = "random errors in the radii of rounded edges",
    .help = "The radius of the edges of each domino has a separate random error, given as a fraction of the "
            "radius. A radius is at most half of the thickness.",
    SIZED("", "error in each radius, as a fraction of the radius", 1, 0.1),
    .needs = NEEDS(DOM_EFFECT_edges),
};

const struct domq_effect error_effect_friction = {
    .name = "error_friction",
    .synonyms = "unknown",
    .adds = "an unknown friction between dominoes, the same for all",
    .help = "The friction between dominoes is never known precisely. One error is drawn for each row. It is "
            "added to the coefficient of 'set friction', for all dominoes of the row. If the sum is "
            "negative, the coefficient is 0.",
    SIZED("", "error in the friction coefficient", 100, 0.05),
};

const struct domq_effect error_effect_slope = {
    .name = "error_slope",
    .synonyms = "level uneven",
    .adds = "a floor that is off level by a random angle",
    .help = "One angle is drawn for each row and added to the angle of 'set slope'. A floor is never so "
            "steep that a domino falls over by itself.",
    SIZED("rad", "error in the slope of the floor", 1.5, 0.005),
};

const struct domq_effect error_effect_floor = {
    .name = "error_floor",
    .synonyms = "unknown slippery",
    .adds = "an unknown friction of the floor, the same for all dominoes",
    .help = "One error is drawn for each row and added to the friction coefficient of the floor, which "
            "'set feet' sets. If the sum is negative, the coefficient is 0.",
    SIZED("", "error in the friction coefficient of the floor", 100, 0.05),
    .needs = NEEDS(EFFECT_feet),
};

const struct domq_effect error_effect_push = {
    .name = "error_push",
    .synonyms = "finger",
    .adds = "a push whose strength varies at random",
    .help = "One error is drawn for each row and added to the speed of 'set push'. If the sum is "
            "negative, the speed is 0.",
    SIZED("rad/s", "error in the angular velocity of the first domino", 1e6, 0.5),
    .needs = NEEDS(DOM_EFFECT_push),
};
