/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "session/scene.h"
#include <stdlib.h>
#include <string.h>

void state_init(struct state *state)
{
    *state = (struct state){.scene = {.train = domq_train_default(),
                                      .compute = domq_compute_default(),
                                      .scale = domq_scale_default(),
                                      .seed = SEED_DEFAULT},
                            .settings = {.style = {.digits = DIGITS_DEFAULT, .header = true}, .hints = 1}};
}

void state_close(struct state *state)
{
    effects_reset(&state->scene);
    variables_free(&state->variables);
}

void listed_free(struct listed_row *row)
{
    if (!row->holders || --*row->holders == 0) {
        free(row->domino);
        free(row->width);
        free(row->path);
        free(row->others);
        free(row->holders);
    }
    free(row->placed);
    *row = (struct listed_row){.domino = NULL};
}

bool listed_share(struct listed_row *to, struct listed_row *from)
{
    size_t size = from->changes * sizeof *from->placed;
    *to = (struct listed_row){.domino = NULL};
    if (from->domino && !from->holders && (from->holders = malloc(sizeof *from->holders)) != NULL)
        *from->holders = 1;
    struct placed *placed = size ? malloc(size) : NULL;
    if ((from->domino && !from->holders) || (size && !placed)) {
        free(placed);
        return false;
    }
    *to = *from;
    to->placed = placed;
    if (size)
        memcpy(placed, from->placed, size);
    if (from->holders)
        ++*from->holders;
    return true;
}

void effects_apply(struct scene *scene)
{
#define APPLY(name, member, status)                                                                          \
    scene->train.member = scene->effect[DOM_EFFECT_##name].on ? scene->effect[DOM_EFFECT_##name].value[0] : 0;
    DOM_DYNAMICS(APPLY)
#undef APPLY
}

void effects_reset(struct scene *scene)
{
    for (int k = 0; k < EFFECT_COUNT; k++)
        scene->effect[k] = (struct effect_state){.on = false};
    listed_free(&scene->listed);
    effects_apply(scene);
}

domq_real scene_filled(const struct scene *scene, domq_real height, domq_real thickness, domq_real width)
{
    struct domq_box box = {.filled = 1};
    domq_real walls = scene->train.walls * scene->scale.h;
    return walls > 0 && domq_box_find(height, thickness, width, walls, &box) == DOM_OK ? box.filled : 1;
}

domq_real scene_block_mass(const struct scene *scene, domq_real height, domq_real thickness)
{
    domq_real filled = scene_filled(scene, height, thickness, height / 2);
    return scene->mass > 0 ? scene->mass : scene->density * height * height * thickness / 2 * filled;
}

domq_real scene_mass(const struct scene *scene)
{
    domq_real h = scene->scale.h;
    return scene_block_mass(scene, h, scene->train.d * h);
}
