/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * All effects of a session: those of the library, and after them those that a rigid-body engine brings, since
 * a train of one degree of freedom cannot have them. To add one, write its name here, its description in
 * engine_effects.c, and what it changes in src/engine/.
 */
#ifndef SHELL_ENGINE_EFFECTS_H
#define SHELL_ENGINE_EFFECTS_H

#include "domino_quad.h"

/* Lists the effects of the engine: X(effect). */
#define ENGINE_EFFECTS(X) X(feet) X(bounce)

enum {
    EFFECTS_BEFORE = DOM_EFFECT_COUNT - 1, /* so that the next one follows those of the library */
#define ENGINE_EFFECT_ENUM(name) EFFECT_##name,
    ENGINE_EFFECTS(ENGINE_EFFECT_ENUM)
#undef ENGINE_EFFECT_ENUM
        EFFECT_COUNT
};

#define ENGINE_EFFECT_DECLARE(name) extern const struct domq_effect engine_effect_##name;
ENGINE_EFFECTS(ENGINE_EFFECT_DECLARE)
#undef ENGINE_EFFECT_DECLARE

/* Returns the description of effect k, from 0. */
const struct domq_effect *effect_at(int k);

#endif
