/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "session/scene.h"
#include "answer/cell.h"
#include "language/quad.h"
#include "language/text.h"
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void state_init(struct state *state)
{
    *state = (struct state){.settings = {.style = {.digits = DIGITS_DEFAULT, .header = true}}};
    scene_reset(&state->scene);
}

void state_close(struct state *state)
{
    slot_drop(state->scene.slot);
    state->scene.slot = NULL;
    variables_free(&state->variables);
}

void slot_drop(struct slot *slot)
{
    if (slot && --slot->holders == 0)
        slot->kind->free(slot);
}

void effects_apply(struct scene *scene)
{
#define APPLY(name, member, status) scene->train.member = effect_value(scene, DOM_EFFECT_##name, 0);
    DOM_DYNAMICS(APPLY)
#undef APPLY
    if (scene_boxes_above(scene) > 0)
        scene->train.walls = 0; /* in an endless train, either all dominoes are boxes or all are solid */
    if (scene->train.air > 0) {
        struct domq_domino first;
        domq_row_of_train(&scene->train, &scene->scale, 1, &first, 1);
        const domq_real mass = scene_first_mass(scene, &first);
        scene->train.air *= mass > 0 ? first.height * first.thickness * first.width / mass : DOMQ_NAN;
    }
}

void scene_reset(struct scene *scene)
{
    const volatile sig_atomic_t *interrupt = scene->compute.interrupt;
    slot_drop(scene->slot);
    *scene = (struct scene){.train = domq_train_default(),
                            .compute = any_compute_default(),
                            .scale = domq_scale_default(),
                            .seed = SEED_DEFAULT};
    scene->compute.interrupt = interrupt;
    for (int k = 0; k < EFFECTS_MOST; k++)
        scene->effect[k].value[0] = EFFECT_OFF;
    effects_apply(scene);
}

domq_real scene_filled(const struct scene *scene, const struct domq_domino *d)
{
    struct domq_box box = {.filled = 1};
    domq_real walls = d->height > scene_boxes_above(scene) ? scene_walls(scene) : 0;
    return walls > 0 && domq_box_find(d->height, d->thickness, d->width, walls, &box) == DOM_OK ? box.filled
                                                                                                : 1;
}

domq_real scene_first_mass(const struct scene *scene, const struct domq_domino *d)
{
    return scene->mass > 0 ? scene->mass
                           : scene->density * d->height * d->width * d->thickness * scene_filled(scene, d);
}

domq_real scene_mass(const struct scene *scene)
{
    struct domq_domino first;
    domq_row_of_train(&scene->train, &scene->scale, 1, &first, 1);
    return scene_first_mass(scene, &first);
}

const char *losses_write(const struct domq_train *train, char text[LOSSES_TEXT])
{
#define VALUE(name, member, status) train->member,
    const domq_real value[] = {DOM_DYNAMICS(VALUE)};
#undef VALUE
    text[0] = '\0';
    for (int k = 0; k < DOM_DYNAMICS_COUNT; k++) {
        const char *dissipates = domq_effect((enum dom_effect_name)k)->dissipates;
        if (value[k] != 0 && dissipates)
            text_add(text, LOSSES_TEXT, "%s%s", *text ? " and " : "", dissipates);
    }
    return text;
}

/* ---- Problems ---- */

bool problem_report(struct problem *problem, enum problem_kind kind, const char *format, ...)
{
    if (problem->kind != PROBLEM_NONE)
        return false;
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(problem->text, sizeof problem->text, format, arguments);
    va_end(arguments);
    problem->kind = kind;
    problem->column = problem->place;
    return false;
}
