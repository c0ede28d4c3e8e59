/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "session/scene.h"
#include "answer/cell.h"
#include "language/quad.h"
#include "language/text.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void state_init(struct state *state)
{
    *state = (struct state){.scene = {.train = domq_train_default(),
                                      .compute = any_compute_default(),
                                      .scale = domq_scale_default(),
                                      .seed = SEED_DEFAULT},
                            .settings = {.style = {.digits = DIGITS_DEFAULT, .header = true}}};
    effects_reset(&state->scene);
}

void state_close(struct state *state)
{
    effects_reset(&state->scene);
    variables_free(&state->variables);
}

void listed_free(struct listed_row *row)
{
    if (row->holders && --*row->holders == 0) {
        free(row->domino);
        free(row->path);
        free(row->others);
        free(row->holders);
    }
    free(row->change);
    *row = (struct listed_row){.domino = NULL};
}

bool listed_share(struct listed_row *to, const struct listed_row *from)
{
    size_t size = from->changes * sizeof *from->change;
    struct changed_domino *change = size ? malloc(size) : NULL;
    *to = (struct listed_row){.domino = NULL};
    if (size && !change)
        return false;
    *to = *from;
    to->change = size ? memcpy(change, from->change, size) : NULL;
    if (from->holders)
        ++*from->holders;
    return true;
}

size_t scene_row_planned(const struct scene *scene)
{
    const struct effect_state *row = &scene->effect[DOM_EFFECT_row];
    return !row->on ? 0 : scene->listed.domino ? scene->listed.count : (size_t)row->value[0];
}

size_t scene_row_count(const struct scene *scene)
{
    return scene->effect[DOM_EFFECT_row].on && scene->listed.changes > 0 ? scene->listed.changes
                                                                         : scene_row_planned(scene);
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

void effects_reset(struct scene *scene)
{
    for (int k = 0; k < EFFECT_COUNT; k++)
        scene->effect[k] = (struct effect_state){.value[0] = EFFECT_OFF};
    scene->length[SHARE_walls] = scene->length[SHARE_edges] = scene->length[SHARE_push] =
        (struct typed_length){.m = 0};
    listed_free(&scene->listed);
    effects_apply(scene);
}

domq_real scene_filled(const struct scene *scene, const struct domq_domino *d)
{
    struct domq_box box = {.filled = 1};
    domq_real walls = d->height > scene_boxes_above(scene) ? scene_walls(scene) : 0;
    return walls > 0 && domq_box_find(d->height, d->thickness, d->width, walls, &box) == DOM_OK ? box.filled
                                                                                                : 1;
}

domq_real scene_width(const struct scene *scene, domq_real height)
{
    const domq_real length = scene->length[SHARE_width].m;
    return length > 0 ? length : scene->train.width * height;
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

bool problem_no_room(struct problem *problem, const struct scene *scene, size_t k, domq_real thickness)
{
    char which[32] = "the domino";
    if (k > 0)
        snprintf(which, sizeof which, "domino %zu", k);
    return problem_no_answer(problem,
                             "walls of %s do not fit into %s, which is %s thick; walls of %s make it solid",
                             measured(scene_walls(scene), "m", 4).text, which,
                             measured(thickness, "m", 4).text, measured(thickness / 2, "m", 4).text);
}

bool problem_no_stand(struct problem *problem, const struct scene *scene, size_t k, domq_real limit)
{
    const double degree = (double)QUAD_PI / 180, alpha = (double)scene->train.alpha / degree;
    char which[32] = "no domino", example[32] = "off";
    if (k > 0)
        snprintf(which, sizeof which, "domino %zu", k);
    if (limit > 0)
        snprintf(example, sizeof example, "%.2g deg", copysign((double)limit, alpha) / degree / 2);
    return problem_no_answer(problem,
                             "%s %s stand upright on a slope of %.4g deg; for %s thickness%s the limit is "
                             "%.4g deg; enter, for example, 'set slope %s'",
                             which, k > 0 ? "cannot" : "can", alpha, k > 0 ? "its" : "this",
                             scene->train.rho > 0 ? " and rounded edges" : "", (double)limit / degree,
                             example);
}

bool problem_status(struct problem *problem, const struct scene *scene, enum dom_status status)
{
    const struct domq_train *t = &scene->train;
    if (status == DOM_OK)
        return true;
    problem->place = 0;
    /* These failures do not depend on the parameters, so a sweep must not continue. */
    if (status == DOM_INTERRUPTED || status == DOM_NO_MEMORY)
        return problem_error(problem, "%s", dom_status_text(status));
    if (status == DOM_NO_ROUND && t->rho > t->d / 2)
        return problem_no_answer(problem,
                                 "edges with a radius of %s h do not fit: the radius can be at most half of "
                                 "the thickness, %.6g h; enter, for example, 'set edges %.2g'",
                                 quad_text(t->rho, 10), (double)(t->d / 2), (double)(t->d / 4));
    if (status == DOM_NO_STAND) {
        domq_real lean[2];
        domq_lean_limits(&(struct domq_domino){.height = 1, .thickness = t->d}, 0, t->rho, lean);
        return problem_no_stand(problem, scene, 0, lean[1]);
    }
    if (status == DOM_OUT_OF_REACH)
        return problem_no_answer(problem,
                                 "r s = %s > %.6g: the head falls past the next domino without touching it; "
                                 "the largest r for this s is %s%s",
                                 quad_text(t->r * t->s, 10), (double)(domq_train_reach(t) * t->s),
                                 t->rho == 0 ? "1/s = " : "", quad_limit(domq_train_reach(t), 6));
    if (status == DOM_NO_METHOD && domq_first_effect(t) && t->fuel == DOM_FUEL_PAPER)
        return problem_no_answer(
            problem, "'fuel paper' cannot be combined with %s; enter 'set fuel exact' or 'set %s off'",
            domq_first_effect(t)->name, domq_first_effect(t)->name);
    if (status == DOM_NOT_CONVERGED && scene->compute.precision != IN_QUAD)
        return problem_no_answer(problem,
                                 "%s of %.3g; enter 'set precision %s', or a larger tolerance with 'set tol'",
                                 dom_status_text(status), (double)scene->compute.tol,
                                 scene->compute.precision == IN_FLOAT ? "double" : "quad");
    if (status == DOM_BAD_AIR && effect_value(scene, DOM_EFFECT_air, 0) > 0)
        return problem_no_answer(problem,
                                 "'set air' needs the mass of the dominoes; first enter, for example, "
                                 "'set density 650 kg/m^3'");
    if (status == DOM_NO_AIR)
        return problem_no_answer(
            problem, "%s; enter 'set q solid', or ask about %s or 'rowmax'", dom_status_text(status),
            scene->effect[DOM_EFFECT_row].on ? "the row: 'fall'" : "a row: 'set row 20; fall'");
    if (status == DOM_NO_FUEL)
        return problem_no_answer(problem, "%s; 'why' says more", dom_status_text(status));
    const domq_real above = scene_boxes_above(scene);
    if (status == DOM_NO_ROOM && above > 0)
        return problem_no_answer(
            problem,
            "walls of %s do not fit into each domino taller than %s here; enter a larger "
            "height, as in 'set walls %s %s'",
            measured(scene_walls(scene), "m", 4).text, measured(above, "m", 4).text,
            measured(scene_walls(scene), "m", 4).text, measured(2 * above, "m", 4).text);
    if (status == DOM_NO_ROOM)
        return problem_no_room(problem, scene, 0, t->d * scene->scale.h);
    if (status == DOM_OPEN)
        return problem_no_answer(problem, "%s; try a slightly different s", dom_status_text(status));
    if (status == DOM_TOO_LONG)
        return problem_no_answer(problem, "%s; use a larger s, d or tol", dom_status_text(status));
    return problem_no_answer(problem, "%s", dom_status_text(status));
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

domq_real lean_offset(const struct domq_domino *domino)
{
    return domino->height * quad(sin)(domino->lean);
}

bool lean_stands(const struct domq_domino *domino, domq_real alpha, char message[LEAN_MESSAGE])
{
    domq_real lean[2], limit;
    domq_lean_limits(domino, alpha, 0, lean);
    if (domino->lean > lean[0] && domino->lean < lean[1])
        return true;
    limit = domino->lean < 0 ? lean[0] : lean[1];
    snprintf(message, LEAN_MESSAGE,
             "with its top %s off plumb, this domino falls over by itself; the limit%s is %s",
             measured(lean_offset(domino), "m", 4).text, alpha != 0 ? " on this slope" : "",
             measured(domino->height * quad(sin)(limit), "m", 4).text);
    return false;
}
