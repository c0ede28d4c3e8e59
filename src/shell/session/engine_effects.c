/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "session/engine_effects.h"

const struct domq_effect engine_effect_feet = {
    .name = "feet",
    .synonyms = "foot slip slide slippery floor ground hinge engine chipmunk",
    .adds = "feet that slip on a floor with friction, instead of hinges",
    .help =
        "Feet are no hinges: a foot slides where the floor would have to give more friction than MU, also "
        "in the collision, and it may be lifted. Such a row is no train of one degree of freedom: a "
        "rigid-body engine runs it, Chipmunk 7, which is loaded only then. 'fall' reports how far feet "
        "slide. The step of the engine is halved until the verdict and the times no longer change. "
        "The answer depends on the start: a push of more than sqrt(2 g/h) lifts the first domino and throws "
        "it at the second. "
        "'rowmax' finds the largest growth of such a row; 'rmax' is about the endless train, whose feet "
        "are hinges.",
    .source = "Chipmunk 7, a rigid-body engine; Coulomb friction",
    .plan = "rigid-body engine, steps halved until nothing changes",
    .argument = {{.name = "MU",
                  .unit = "",
                  .meaning = "friction coefficient of the floor",
                  .lowest = 0,
                  .highest = 100,
                  .usual = (domq_real)1 / 2}},
    .needs = 1U << DOM_EFFECT_row,
    .dissipates = true,
};

const struct domq_effect engine_effect_bounce = {
    .name = "bounce",
    .synonyms = "restitution elastic elasticity rebound engine chipmunk",
    .adds = "dominoes that bounce off each other",
    .help = "The collision gives back the share E of the speed with which two dominoes meet: 0 is the "
            "collision of the paper, after which they stay together, and 1 loses no energy. A rigid-body "
            "engine runs such a row, Chipmunk 7, which is loaded only then. Dominoes that bounce hit each "
            "other again and again, ever more softly, until they stay together: up to E = 0.2 the largest "
            "growth changes by less than 0.2 %.",
    .source = "Chipmunk 7, a rigid-body engine; Newton's law of restitution",
    .plan = "rigid-body engine, steps halved until nothing changes",
    .argument = {{.name = "E",
                  .unit = "",
                  .meaning = "restitution between dominoes",
                  .lowest = 0,
                  .highest = 1,
                  .usual = (domq_real)1 / 5}},
    .needs = 1U << DOM_EFFECT_row,
    .dissipates = true,
};

const struct domq_effect *effect_at(int k)
{
    static const struct domq_effect *const engine[] = {
#define POINTER(name) &engine_effect_##name,
        ENGINE_EFFECTS(POINTER)
#undef POINTER
    };
    return k < DOM_EFFECT_COUNT ? domq_effect((enum dom_effect_name)k) : engine[k - DOM_EFFECT_COUNT];
}
