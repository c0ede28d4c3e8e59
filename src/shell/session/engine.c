/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "session/engine.h"

const struct engine_driver *row_engine;

bool scene_has_engine(const struct scene *scene)
{
    bool wanted = scene->method == METHOD_ENGINE;
    for (int k = DOM_EFFECT_COUNT; k < EFFECT_ENGINE_END; k++)
        wanted = wanted || scene->effect[k].on;
    return wanted && scene->effect[DOM_EFFECT_row].on;
}

const char *scene_engine_why(const struct scene *scene)
{
#define WHY(name) #name " is on",
    static const char *const why[] = {ENGINE_EFFECTS(WHY)};
#undef WHY
    for (int k = DOM_EFFECT_COUNT; k < EFFECT_ENGINE_END; k++)
        if (scene->effect[k].on)
            return why[k - DOM_EFFECT_COUNT];
    return "method is engine";
}
