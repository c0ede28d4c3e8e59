/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "session/random_errors.h"
#include "language/quad.h"
#include "session/effects.h"
#include <stdio.h>

const char *error_names(const void *context, int k)
{
    (void)context;
#define NAME(name, unit, meaning) #name,
    static const char *const names[] = {DOM_ERRORS(NAME) "all", NULL};
#undef NAME
    return names[k];
}

const char *error_unit(int kind)
{
#define UNIT(name, unit, meaning) unit,
    static const char *const units[] = {DOM_ERRORS(UNIT) ""};
#undef UNIT
    return units[kind];
}

int error_effect(int kind)
{
#define EFFECT(name) [DOM_ERROR_##name] = EFFECT_error_##name,
    static const int effects[] = {[DOM_ERROR_gap] = DOM_EFFECT_placement,
                                  [DOM_ERROR_height] = DOM_EFFECT_placement,
                                  ERROR_EFFECTS(EFFECT)};
#undef EFFECT
    return effects[kind];
}

bool scene_errors(const struct scene *scene, struct domq_random_error error[DOM_ERROR_COUNT])
{
    bool any = false;
    for (int k = 0; k < DOM_ERROR_COUNT; k++) {
        const int effect = error_effect(k);
        const struct effect_state *state = &scene->effect[effect];
        const bool placed = effect == DOM_EFFECT_placement;
        const domq_real size = state->value[k == DOM_ERROR_height], limits = state->value[placed ? 2 : 1];
        error[k] =
            (struct domq_random_error){.size = state->on ? size : 0, .uniform = state->on && limits != 0};
        any = any || state->on;
    }
    return any;
}

bool errors_check(const struct scene *scene, struct problem *problem)
{
    if (!scene->effect[EFFECT_error_lean].on)
        return true;
    if (scene_has_engine(scene))
        return problem_error(problem,
                             "'set error_lean' cannot be combined with the rigid-body engine, which runs "
                             "this row because %s; first enter 'set error_lean off'",
                             scene_engine_why(scene));
    return scene->train.rho == 0 ||
           problem_error(problem, "'set error_lean' cannot be combined with rounded edges; first enter "
                                  "'set edges off', or 'set error_lean off'");
}

void errors_off(struct scene *scene)
{
    for (int k = 0; k < DOM_ERROR_COUNT; k++)
        effect_put(scene, error_effect(k), EFFECT_OFF, NULL);
}

const char *errors_text(const struct domq_random_error *error, char text[ERRORS_TEXT])
{
    text[0] = '\0';
    for (int k = 0, n = 0; k < DOM_ERROR_COUNT; k++)
        if (error[k].size > 0)
            n += snprintf(text + n, (size_t)(ERRORS_TEXT - n), "%s%s %s%s%s%s", n ? ", " : "",
                          error_names(NULL, k), quad_text(error[k].size, 10), *error_unit(k) ? " " : "",
                          error_unit(k), error[k].uniform ? " uniform" : "");
    return text;
}
