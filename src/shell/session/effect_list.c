/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "session/effect_list.h"
#include "language/text.h"
#include <stdio.h>

const struct domq_effect engine_effect_feet = {
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

const struct domq_effect engine_effect_bounce = {
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

static const struct domq_effect *effects[EFFECT_COUNT] = {
    [EFFECT_feet] = &engine_effect_feet, [EFFECT_bounce] = &engine_effect_bounce};

void effect_use(int k, const struct domq_effect *effect)
{
    effects[k] = effect;
}

const struct domq_effect *effect_at(int k)
{
    return k < DOM_EFFECT_COUNT ? domq_effect((enum dom_effect_name)k) : effects[k];
}

const char *effect_usage_write(int effect, char usage[EFFECT_USAGE])
{
    const struct domq_effect *e = effect_at(effect);
    snprintf(usage, EFFECT_USAGE, "%s", e->name);
    for (int i = 0; i < DOM_EFFECT_ARGUMENTS && e->argument[i].name; i++)
        text_add(usage, EFFECT_USAGE,
                 e->argument[i].optional  ? " [%s]"
                 : e->argument[i].or_file ? " %s|FILE"
                                          : " %s",
                 e->argument[i].name);
    return usage;
}
