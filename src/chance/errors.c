/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The kinds of random error. To add a kind, add it to DOM_ERRORS, describe it here, and apply it to a row in
 * model/draw.c. */
#include "chance/chance.h"
#include "language/quad.h"
#include <string.h>

/* The numbers of the effects. */
static int error_number[DOM_ERROR_COUNT];

static const char *const distributions[] = {"normal", "uniform", NULL};

/* What the kinds with an effect of their own have in common. `usual_` and `most_` are the usual and the
 * largest size; `to_` is the largest size that 'solve' tries; `needs_` enters the effect that this one needs,
 * and `rows_` is the number of rows in the example. The engine takes a thousand times as long as the model.
 */
#define SIZED(kind, unit_, usual_, most_, to_, needs_, rows_)                                                \
    .name = #kind, .unit = unit_, .parameter.effect = &error_kinds[DOM_ERROR_##kind].effect,                 \
    .parameter.number = &error_number[DOM_ERROR_##kind], .parameter.is_minor = true, .parameter.to = to_,    \
    .parameter.example = "set row on; " needs_ "set error_" #kind " on; placement " rows_,                   \
    .effect.name = "error_" #kind,                                                                           \
    .effect.source = "pseudo-random numbers from GSL: the generators taus2 and mrg",                         \
    .effect.argument[0].name = "SIZE", .effect.argument[0].unit = unit_,                                     \
    .effect.argument[0].usual = (domq_real)(usual_), .effect.argument[0].highest = (domq_real)(most_),       \
    .effect.argument[1] = {                                                                                  \
        .name = "LIMITS",                                                                                    \
        .unit = "",                                                                                          \
        .meaning = "distribution of the error: normal with the standard deviation SIZE, or uniform from "    \
                   "-SIZE to SIZE",                                                                          \
        .highest = 1,                                                                                        \
        .optional = true,                                                                                    \
        .words = distributions}

static const char placement_help[] =
    "The row is set up many times. Each gap has a normally distributed error with the standard deviation "
    "SIGMA, which is a length, and each height has a relative error with the standard deviation HEIGHTS. "
    "If LIMITS is 'uniform', SIGMA and HEIGHTS are limits, and all errors within them are equally likely. "
    "Dominoes that would overlap are moved until they touch. 'placement' counts how often all dominoes "
    "fall, gives the exact 95 % interval of Clopper and Pearson, and reports where rows stop. 'budget' "
    "finds the SIGMA at which a given share of the rows falls. With the same 'seed', row number i is "
    "always the same, with any number of 'threads'. Other errors have separate effects: error_place, "
    "error_thickness, error_mass, error_lean and error_radius for each domino, and error_friction, "
    "error_slope, error_floor and error_push for the whole row.";

const struct error_kind error_kinds[DOM_ERROR_COUNT + 1] = {
    /* 'placement' has the errors of gaps and of heights */
    [DOM_ERROR_gap] =
        {.name = "gap",
         .unit = "m",
         .parameter = {.effect = &error_kinds[DOM_ERROR_gap].effect,
                       .number = &error_number[DOM_ERROR_gap],
                       .example =
                           "set row 13; set placement 2 mm; placement 500; set placement off; set row off",
                       .to = 0.1},
         .effect =
             {
                 .name = "placement",
                 .synonyms =
                     "probability chance errors precision accuracy error_gap error_height gaps heights",
                 .adds = "random errors in the gaps, and in the heights if HEIGHTS is given",
                 .help = placement_help,
                 .source = "C. J. Clopper and E. S. Pearson, Biometrika 26, 404 (1934), for the interval; "
                           "pseudo-random numbers from GSL",
                 .argument = {{.name = "SIGMA",
                               .unit = "m",
                               .meaning = "standard deviation of every gap",
                               .highest = (domq_real)1e9,
                               .usual = (domq_real)1 / 1000},
                              {.name = "HEIGHTS",
                               .unit = "",
                               .meaning = "relative standard deviation of every height",
                               .highest = 1,
                               .optional = true},
                              {.name = "LIMITS",
                               .unit = "",
                               .meaning = "distribution of the errors: normal, or uniform within limits",
                               .highest = 1,
                               .optional = true,
                               .words = distributions}},
             }},
    [DOM_ERROR_height] = {.name = "height", .unit = ""},
    [DOM_ERROR_place] = {SIZED(place, "m", 0.001, 1e9, 0.1, "", "500"), .effect.synonyms = "position tape",
                         .effect.adds = "random errors in the positions of dominoes",
                         .effect.argument[0].meaning = "error in each position",
                         .effect.help =
                             "Each domino after the first is out of position by a separate random error. An "
                             "error moves only one domino, as if all positions had been measured with one "
                             "tape. In 'set placement', by contrast, an error in a gap moves all dominoes "
                             "after it. Dominoes that would overlap are moved until they touch."},
    [DOM_ERROR_thickness] =
        {SIZED(thickness, "", 0.01, 1, 0.5, "", "500"), .effect.synonyms = "thick boards",
         .effect.adds = "random errors in the thicknesses of dominoes",
         .effect.argument[0].meaning = "error in each thickness, as a fraction of the thickness",
         .effect.help = "Each domino is thicker or thinner by a separate random error, given as a fraction "
                        "of its thickness, such as 0.01 or 1 %. Gaps and the density do not change, so a "
                        "thicker domino is heavier. No domino becomes thinner than twice the thickness of "
                        "the walls, twice the radius of the edges, or 1/100 of its intended thickness."},
    [DOM_ERROR_mass] = {SIZED(mass, "", 0.05, 1, 1, "", "500"), .effect.synonyms = "weight density",
                        .effect.adds = "random errors in the masses of dominoes",
                        .effect.argument[0].meaning = "error in each mass, as a fraction of the mass",
                        .effect.help = "Each domino is heavier or lighter by a separate random error, given "
                                       "as a fraction of its mass."},
    [DOM_ERROR_lean] =
        {SIZED(lean, "rad", 0.005, 1.5, 0.14, "", "500"), .effect.synonyms = "plumb upright tilted",
         .effect.adds = "dominoes that are off plumb by random angles",
         .effect.argument[0].meaning = "error in each lean",
         .effect.help = "Each domino leans forwards or backwards by a separate random angle, as if its floor "
                        "or its foot were not flat. When it falls, it turns about its front edge. A domino "
                        "that would fall over by itself gets the largest lean at which it still stands. This "
                        "effect cannot be combined with rounded edges or with the rigid-body engine."},
    [DOM_ERROR_radius] = {SIZED(radius, "", 0.1, 1, 1, "set edges on; ", "500"),
                          .effect.synonyms = "rounding bevels",
                          .effect.adds = "random errors in the radii of rounded edges",
                          .effect.argument[0].meaning = "error in each radius, as a fraction of the radius",
                          .effect.needs = 1U << DOM_EFFECT_edges,
                          .effect.help =
                              "The radius of the edges of each domino has a separate random error, given as "
                              "a fraction of the radius. A radius is at most half of the thickness."},
    [DOM_ERROR_friction] = {SIZED(friction, "", 0.05, 100, 0.5, "", "500"), .effect.synonyms = "unknown",
                            .effect.adds = "an unknown friction between dominoes, the same for all",
                            .effect.argument[0].meaning = "error in the friction coefficient",
                            .effect.help =
                                "The friction between dominoes is never known precisely. One error is drawn "
                                "for each row. It is added to the coefficient of 'set friction', for all "
                                "dominoes of the row. If the sum is negative, the coefficient is 0."},
    [DOM_ERROR_slope] = {SIZED(slope, "rad", 0.005, 1.5, 0.14, "", "500"), .effect.synonyms = "level uneven",
                         .effect.adds = "a floor that is off level by a random angle",
                         .effect.argument[0].meaning = "error in the slope of the floor",
                         .effect.help =
                             "One angle is drawn for each row and added to the angle of 'set slope'. A floor "
                             "is never so steep that a domino falls over by itself."},
    [DOM_ERROR_floor] = {SIZED(floor, "", 0.05, 100, 0.5, "set feet on; ", "5"),
                         .effect.synonyms = "unknown slippery",
                         .effect.adds = "an unknown friction of the floor, the same for all dominoes",
                         .effect.argument[0].meaning = "error in the friction coefficient of the floor",
                         .parameter.needs = "feet", .parameter.by_engine = true,
                         .effect.help =
                             "One error is drawn for each row and added to the friction coefficient of the "
                             "floor, which 'set feet' sets. If the sum is negative, the coefficient is 0."},
    [DOM_ERROR_push] = {SIZED(push, "rad/s", 0.5, 1e6, 5, "set push on; ", "500"),
                        .effect.synonyms = "finger", .effect.adds = "a push whose strength varies at random",
                        .effect.argument[0].meaning = "error in the angular velocity of the first domino",
                        .effect.needs = 1U << DOM_EFFECT_push,
                        .effect.help = "One error is drawn for each row and added to the speed of 'set "
                                       "push'. If the sum is negative, the speed is 0."},
    [DOM_ERROR_COUNT] = {.name = "all", .unit = ""},
};

int error_effect(int kind)
{
    return error_number[kind == DOM_ERROR_height ? DOM_ERROR_gap : kind];
}

bool scene_errors(const struct scene *scene, struct dom_random_error error[DOM_ERROR_COUNT])
{
    bool any = false;
    for (int k = 0; k < DOM_ERROR_COUNT; k++) {
        const int effect = error_effect(k);
        const struct effect_state *state = &scene->effect[effect];
        const bool placed = effect == error_number[DOM_ERROR_gap];
        const domq_real size = state->value[k == DOM_ERROR_height], limits = state->value[placed ? 2 : 1];
        error[k] = (struct dom_random_error){.size = state->on ? (double)size : 0,
                                             .uniform = state->on && limits != 0};
        any = any || state->on;
    }
    return any;
}

bool errors_check(const struct scene *scene, struct problem *problem)
{
    if (!scene->effect[error_number[DOM_ERROR_lean]].on)
        return true;
    if (scene_engine(scene))
        return problem_error(problem,
                             "'set error_lean' cannot be combined with the rigid-body engine, which runs "
                             "this row because %s; first enter 'set error_lean off'",
                             scene_engine(scene));
    return scene->train.rho == 0 ||
           problem_error(problem, "'set error_lean' cannot be combined with rounded edges; first enter "
                                  "'set edges off', or 'set error_lean off'");
}

const char *errors_text(const struct dom_random_error *error, bool for_people, char text[ERRORS_TEXT])
{
    text[0] = '\0';
    for (int k = 0, n = 0; k < DOM_ERROR_COUNT; k++) {
        const char *unit = error_kinds[k].unit;
        const bool is_added = k == DOM_ERROR_friction || k == DOM_ERROR_floor;
        char size[CELL_TEXT];
        if (!(error[k].size > 0))
            continue;
        if (!for_people)
            snprintf(size, sizeof size, "%s%s%s", quad_text((domq_real)error[k].size, 10), *unit ? " " : "",
                     unit);
        else if (strcmp(unit, "rad") == 0)
            snprintf(size, sizeof size, "%s", measured(error[k].size * (180 / QUAD_PI), "deg", 3).text);
        else
            snprintf(size, sizeof size, "%s",
                     measured(error[k].size, *unit || is_added ? unit : "share", 3).text);
        n += snprintf(text + n, (size_t)(ERRORS_TEXT - n), "%s%s %s%s", n ? ", " : "", error_kinds[k].name,
                      size,
                      !error[k].uniform ? ""
                      : for_people      ? " at most"
                                        : " uniform");
    }
    return text;
}
