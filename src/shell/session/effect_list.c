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

const struct domq_effect *effect_at(int k)
{
    static const struct domq_effect *const more[] = {
#define ENGINE_POINTER(name) &engine_effect_##name,
#define ERROR_POINTER(name)  &error_effect_##name,
        ENGINE_EFFECTS(ENGINE_POINTER) ERROR_EFFECTS(ERROR_POINTER)
#undef ENGINE_POINTER
#undef ERROR_POINTER
    };
    return k < DOM_EFFECT_COUNT ? domq_effect((enum dom_effect_name)k) : more[k - DOM_EFFECT_COUNT];
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

/* Example commands for some effects. For all other effects, effect_example composes the commands. */
static const char *const examples[EFFECT_COUNT] = {
    [DOM_EFFECT_friction] = "set q hollow; set friction 0.2; rmax 0.4; set friction off",
    [DOM_EFFECT_edges] = "set q hollow; set edges 0.01; rmax 0.2; set edges off",
    [DOM_EFFECT_walls] = "set walls 1 mm; duration; set walls off",
    [DOM_EFFECT_row] = "set row 13; fall; set row off",
    [DOM_EFFECT_push] = "set row 5; set push 3; fall; set push off; set row off",
    [DOM_EFFECT_placement] = "set row 13; set placement 2 mm; placement 500; set placement off; set row off",
    [EFFECT_feet] = "set q hollow; set row 8; set feet 0.4; fall; set feet off; set row off",
    [EFFECT_bounce] = "set q hollow; set row 8; set bounce 0.5; verdict; set bounce off; set row off",
    [DOM_EFFECT_floor] = "set row 5; set floor 0.4; fall; set floor off; set row off",
};

const char *effect_example(int effect, char example[EFFECT_EXAMPLE])
{
    const struct domq_effect *e = effect_at(effect);
    const bool is_error = effect >= EFFECT_ENGINE_END;
    if (examples[effect])
        return examples[effect];
    snprintf(example, EFFECT_EXAMPLE, "%s", is_error ? "set row on; " : "");
    for (int k = 0; k < EFFECT_COUNT; k++)
        if (e->needs >> k & 1)
            text_add(example, EFFECT_EXAMPLE, "set %s on; ", effect_at(k)->name);
    text_add(example, EFFECT_EXAMPLE, "set %s on; %s", e->name,
             !is_error ? "scene"
             /* the engine takes a thousand times as long as the model, so only 5 rows are drawn */
             : e->needs >> EFFECT_feet & 1 ? "placement 5"
                                           : "placement 500");
    return example;
}
