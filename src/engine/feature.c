/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The effects of the rigid-body engine, and its record. To add an effect, add its name to session/effects.h,
 * its description here, its value to row_make (row_engine.c), and its code to the engine. */
#include "interpreter/feature.h"
#include "engine/row_engine.h"

static const struct domq_effect feet = {
    .name = "feet",
    .synonyms = "foot slip slide slippery floor ground hinge engine chipmunk",
    .adds = "feet that can slip on the floor, instead of hinges",
    .help = "Feet are not hinged to the floor. A foot may lift off, and it slides if friction with the "
            "coefficient MU cannot hold it, during the motion or in a collision. The equations of the train "
            "have one degree of freedom and cannot describe this, so the rigid-body engine Chipmunk 7 runs "
            "the row. 'fall' reports how far feet slide. The time step of the engine is halved until the "
            "verdict and the times no longer change. The result depends on the start: a push of more than "
            "sqrt(2 g/h) lifts the first domino and throws it at the second. 'rowmax' finds the largest "
            "growth at which such a row falls; 'rmax' is for the endless train, whose feet are hinges.",
    .source = "Chipmunk 7, a rigid-body engine; Coulomb friction",
    .plan = "rigid-body engine, with steps halved until the results no longer change",
    .argument = {{.name = "MU",
                  .unit = "",
                  .meaning = "friction coefficient of the floor",
                  .lowest = 0,
                  .highest = 100,
                  .usual = (domq_real)1 / 2}},
    .needs = 1U << DOM_EFFECT_row,
    .dissipates = "sliding feet",
};

static const struct domq_effect bounce = {
    .name = "bounce",
    .synonyms = "restitution elastic elasticity rebound engine chipmunk",
    .adds = "dominoes that bounce off each other",
    .help = "After a collision, two dominoes separate at E times the speed at which they met. With E = 0, as "
            "in the paper, they stay together, and with E = 1 no energy is lost. The rigid-body engine "
            "Chipmunk 7 runs the row. The dominoes collide again and again, more and more softly, until they "
            "stay together. Up to E = 0.2, the largest growth changes by less than 0.2 %.",
    .source = "Chipmunk 7, a rigid-body engine; Newton's law of restitution",
    .plan = "rigid-body engine, with steps halved until the results no longer change",
    .argument = {{.name = "E",
                  .unit = "",
                  .meaning = "restitution between dominoes",
                  .lowest = 0,
                  .highest = 1,
                  .usual = (domq_real)1 / 5}},
    .needs = 1U << DOM_EFFECT_row,
    .dissipates = "bounces",
};

#define ENTRY(name_)                                                                                         \
    .name = #name_, .value = name_.argument, .effect = &name_, .which = EFFECT_##name_, .words = effect_words

static const struct parameter parameters[] = {
    {ENTRY(feet), .example = "set q hollow; set row 8; set feet 0.4; fall; set feet off; set row off",
     .from = 0.05, .to = 2},
    {ENTRY(bounce),
     .example = "set q hollow; set row 8; set bounce 0.5; verdict; set bounce off; set row off", .from = 0,
     .to = 1},
};

static const struct parameter *parameter(int k)
{
    return k < (int)(sizeof parameters / sizeof *parameters) ? &parameters[k] : NULL;
}

const struct feature engine_feature = {.name = "engine", .engine = &chipmunk_driver, .parameter = parameter};
