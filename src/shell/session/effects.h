/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The numbers and descriptions of all effects: first the effects of the library, then those that features of
 * the program describe. To add an effect of the model, follow src/train/model/dynamics/README.md. */
#ifndef SHELL_EFFECTS_H
#define SHELL_EFFECTS_H

#include "domino_quad.h"
#include <math.h>

/* The effects of the rigid-body engine, which the feature 'engine' describes. */
#define ENGINE_EFFECTS(X) X(feet) X(bounce)

/* The kinds of random error that have their own effect, which the feature 'chance' describes, and the feature
 * without which there is no such effect. Errors in gaps and heights belong to 'placement'. */
#define ERROR_EFFECTS(X)                                                                                     \
    X(place, "chance")                                                                                       \
    X(thickness, "chance")                                                                                   \
    X(mass, "chance")                                                                                        \
    X(lean, "chance")                                                                                        \
    X(radius, "chance") X(friction, "chance") X(slope, "chance") X(floor, "engine") X(push, "chance")

enum {
    /* The numbers of the shell's effects continue after the library's last effect. */
    EFFECTS_BEFORE = DOM_EFFECT_COUNT - 1,
#define ENGINE_EFFECT_ENUM(name) EFFECT_##name,
    ENGINE_EFFECTS(ENGINE_EFFECT_ENUM)
#undef ENGINE_EFFECT_ENUM
        EFFECT_ENGINE_END,
    EFFECTS_BEFORE_ERRORS = EFFECT_ENGINE_END - 1,
#define ERROR_EFFECT_ENUM(name, feature) EFFECT_error_##name,
    ERROR_EFFECTS(ERROR_EFFECT_ENUM)
#undef ERROR_EFFECT_ENUM
        EFFECT_COUNT
};

/* Returns true for an effect that gives rows random errors. */
static inline bool effect_is_random(int effect)
{
    return effect == DOM_EFFECT_placement || effect >= EFFECT_ENGINE_END;
}

/* First values of an effect that stand for the words "off" and "on". EFFECT_ON turns an effect on with its
 * usual values. If the effect is already on, its values do not change. */
#define EFFECT_OFF ((domq_real)-HUGE_VAL)
#define EFFECT_ON  ((domq_real)HUGE_VAL)

/* The value of the effect 'release' that stands for the word "touch": the domino leans against the next one,
 * which it touches before it lies flat. */
#define RELEASE_TOUCH ((domq_real)1.5707963267948966)

/* Returns the description of effect number k, counted from 0, or NULL if this build lacks the effect. */
const struct domq_effect *effect_at(int k);

#endif
