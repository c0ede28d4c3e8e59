/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "session/row.h"
#include "answer/cell.h"
#include "language/quad.h"
#include "session/parameters.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- Problems ---- */

/* Reports that the walls do not fit into domino k. If k = 0, the message is about a domino of the train.
 * Returns false. */
static bool problem_no_room(struct problem *problem, const struct scene *scene, size_t k, domq_real thickness)
{
    char which[32] = "the domino";
    if (k > 0)
        snprintf(which, sizeof which, "domino %zu", k);
    return problem_no_answer(problem,
                             "walls of %s do not fit into %s, which is %s thick; walls of %s make it solid",
                             measured(scene_walls(scene), "m", 4).text, which,
                             measured(thickness, "m", 4).text, measured(thickness / 2, "m", 4).text);
}

/* Reports that domino k cannot stand, because the slope exceeds `limit` radians. If k = 0, the message is
 * about a domino of the train. Returns false. */
static bool problem_no_stand(struct problem *problem, const struct scene *scene, size_t k, domq_real limit)
{
    const double degree = (double)QUAD_PI / 180, alpha = (double)scene->train.alpha / degree;
    char which[48] = "no domino can", example[32] = "off";
    if (k > 0)
        snprintf(which, sizeof which, "domino %zu cannot", k);
    if (limit > 0)
        snprintf(example, sizeof example, "%.2g deg", copysign((double)limit, alpha) / degree / 2);
    return problem_no_answer(problem,
                             "%s stand upright on a slope of %.4g deg; for this thickness%s the limit is "
                             "%.4g deg; enter, for example, 'set slope %s'",
                             which, alpha, scene->train.rho > 0 ? " and rounded edges" : "",
                             (double)limit / degree, example);
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
    const domq_real rho = scene_edges(scene);
    if ((status == DOM_NO_ROUND || status == DOM_NO_STAND) && rho > t->d / 2)
        return problem_no_answer(problem,
                                 "edges with a radius of %s h do not fit: the radius can be at most half of "
                                 "the thickness, %.6g h; enter, for example, 'set edges %.2g'",
                                 quad_text(rho, 6), (double)(t->d / 2), (double)(t->d / 4));
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
    if (status == DOM_NOT_CONVERGED) {
        const enum precision precision = scene->compute.precision;
        return problem_no_answer(problem, "%s of %.3g; enter %sa larger tolerance with 'set tol'",
                                 dom_status_text(status), (double)scene->compute.tol,
                                 precision == IN_FLOAT    ? "'set precision double', or "
                                 : precision == IN_DOUBLE ? "'set precision quad', or "
                                                          : "");
    }
    if (status == DOM_BAD_AIR && effect_value(scene, DOM_EFFECT_air, 0) > 0)
        return problem_no_answer(problem,
                                 "'set air' needs the mass of the dominoes; first enter, for example, "
                                 "'set density 650 kg/m^3'");
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
    return problem_no_answer(problem, "%s%s", dom_status_text(status),
                             status == DOM_NO_AIR && parameter_find("row")
                                 ? "; enter 'set q solid', or ask about a row, as in 'set row 12; fall'"
                             : status == DOM_NO_AIR   ? "; enter 'set q solid'"
                             : status == DOM_NO_FUEL  ? "; 'why' says more"
                             : status == DOM_OPEN     ? "; try a slightly different s"
                             : status == DOM_TOO_LONG ? "; use a larger s, d or tol"
                                                      : "");
}

/* ---- The row ---- */

void row_weigh(const struct scene *scene, const struct domq_domino *first, struct domq_domino *domino,
               size_t count)
{
    const domq_real known = scene_first_mass(scene, first),
                    mass = known > 0 ? known : 2 / (scene->scale.g * first->height), by = mass / first->mass;
    for (size_t k = 0; k < count; k++)
        domino[k].mass *= by;
}

void train_row_fill(const struct scene *scene, struct domq_domino *domino, size_t count)
{
    domq_row_of_train(&scene->train, &scene->scale, 1, domino, count);
    for (size_t k = 0; k < count && scene_boxes_above(scene) > 0; k++)
        domino[k].mass =
            domino[k].height * domino[k].width * domino[k].thickness * scene_filled(scene, &domino[k]);
    row_weigh(scene, domino, domino, count);
}

bool scene_walls_fit(const struct scene *scene, const struct scene_row *row, struct problem *problem)
{
    const domq_real walls = scene_walls(scene);
    struct domq_box box;
    for (size_t k = 0; k < row->row.count && walls > 0; k++) {
        const struct domq_domino *d = &row->domino[k];
        if (d->height > scene_boxes_above(scene) &&
            domq_box_find(d->height, d->thickness, d->width, walls, &box) != DOM_OK)
            return problem_no_room(problem, scene, k + 1, d->thickness);
    }
    return true;
}

/* Checks that the first domino can be held at the tilt of 'set release'. */
static bool row_has_room(const struct scene *scene, const struct scene_row *row, struct problem *problem)
{
    const domq_real release = row->row.release, deg = 180 / QUAD_PI;
    const bool leans = isinf(release);
    domq_real touch = QUAD_PI / 2;
    if (!(release > 0))
        return true;
    if (row->row.count > 1) {
        const enum dom_status status = any_row_touch(&row->row, &row->compute, &touch);
        if (status == DOM_INTERRUPTED || status == DOM_NO_MEMORY)
            return problem_status(problem, scene, status);
        if (status != DOM_OK) /* the run of the row reports the domino that is wrong */
            return true;
    }
    if (leans && !(touch < 1.57))
        return problem_no_answer(
            problem, "the first domino cannot lean against %s; enter a tilt, as in 'set release 20 deg'",
            row->row.count > 1 ? "the second, which is out of its reach"
                               : "a second, since the row has only one");
    if (leans || release <= touch * (1 + (domq_real)1e-12))
        return true;
    return problem_no_answer(problem,
                             "the first domino cannot be released at %s deg, since it touches the second at "
                             "%s deg; enter 'set release %s deg' or less, or 'set release touch'",
                             quad_text(release * deg, 6), quad_text(touch * deg, 6),
                             quad_limit(touch * deg, 4));
}

/* Checks that upright dominoes can stand on the slope. */
static bool row_stands(const struct scene *scene, const struct domq_row *row, struct problem *problem)
{
    for (size_t k = 0; k < row->count; k++) {
        domq_real level[2];
        if (dom_raised(scene->compute.interrupt))
            return problem_status(problem, scene, DOM_INTERRUPTED);
        domq_lean_limits(&row->domino[k], 0, row->rho, level);
        /* where a limit is not above 0, the edges are too round */
        if (row->alpha != 0 && level[1] > 0 && !(quad(fabs)(row->alpha) < level[1]))
            return problem_no_stand(problem, scene, scene->slot ? k + 1 : 0, level[1]);
    }
    return true;
}

const struct engine_driver *row_engine;
const char *row_note;

const char *scene_engine(const struct scene *scene)
{
    return row_engine && scene->effect[DOM_EFFECT_row].on ? row_engine->why(scene) : NULL;
}

const char *scene_train_note(const struct scene *scene)
{
    return scene->effect[DOM_EFFECT_row].on               ? row_note
           : row_engine && row_engine->why(scene) != NULL ? row_engine->train_note
                                                          : NULL;
}

bool row_prepare(const struct scene *scene, bool has_masses, struct scene_row *made, struct problem *problem)
{
    struct domq_row *row = &made->row;
    *row = (struct domq_row){.domino = made->domino,
                             .count = row->count,
                             .g = scene->scale.g,
                             .push = scene_push(scene, made->domino->height),
                             .release = scene_release(scene),
                             .boxes_above = scene_boxes_above(scene),
#define VALUE(name, member, status) .member = scene->train.member,
                             DOM_DYNAMICS(VALUE)
#undef VALUE
    };
    row->walls = scene_walls(scene);
    row->rho = scene_edges(scene);
    row->air = has_masses ? effect_value(scene, DOM_EFFECT_air, 0) : row->air;
    made->compute = scene->compute;
    if (scene_walls_fit(scene, made, problem) && row_stands(scene, row, problem) &&
        row_has_room(scene, made, problem) &&
        (!scene_engine(scene) || row_engine->make(scene, made, problem)))
        return true;
    free(made->domino);
    return false;
}

bool train_row_make(const struct scene *scene, struct scene_row *row, struct problem *problem)
{
    row->row.count = (size_t)scene->effect[DOM_EFFECT_row].value[0];
    row->domino = malloc(row->row.count * sizeof *row->domino);
    if (!row->domino)
        return problem_status(problem, scene, DOM_NO_MEMORY);
    train_row_fill(scene, row->domino, row->row.count);
    return row_prepare(scene, scene_has_mass(scene), row, problem);
}

domq_real scene_first_height(const struct scene *scene)
{
    return scene->slot ? scene->slot->kind->height(scene) : scene->scale.h;
}

domq_real scene_push(const struct scene *scene, domq_real height)
{
    const struct effect_state *push = &scene->effect[DOM_EFFECT_push];
    const domq_real speed = scene->length[SHARE_push].m;
    const bool is_released = scene->effect[DOM_EFFECT_release].on;
    return !push->on ? (is_released ? 0 : DOMQ_NAN) : speed > 0 ? speed / height : push->value[0];
}

domq_real scene_edges(const struct scene *scene)
{
    const domq_real radius = scene->length[SHARE_edges].m;
    return scene->train.rho > 0 && radius > 0 ? radius / scene_first_height(scene) : scene->train.rho;
}

domq_real scene_release(const struct scene *scene)
{
    const domq_real tilt = effect_value(scene, DOM_EFFECT_release, 0);
    return tilt == RELEASE_TOUCH ? (domq_real)HUGE_VAL : tilt;
}

bool scene_has_lengths(const struct scene *scene)
{
    bool has = false;
    for (int k = 0; k < SHARE_COUNT; k++)
        has = has || scene->length[k].m != 0;
    return has;
}

void scene_apply_lengths(struct scene *scene)
{
    domq_real *const value[SHARE_COUNT] = {
        [SHARE_s] = &scene->train.s,
        [SHARE_d] = &scene->train.d,
        [SHARE_width] = &scene->train.width,
        [SHARE_walls] = scene->effect[DOM_EFFECT_walls].value,
        [SHARE_edges] = scene->effect[DOM_EFFECT_edges].value,
    };
    const bool has_lengths = scene_has_lengths(scene);
    for (int share = 0; share < SHARE_COUNT && has_lengths; share++)
        if (value[share] && scene->length[share].m > 0)
            *value[share] = scene->length[share].m / scene->scale.h;
    effects_apply(scene);
    if (scene->effect[DOM_EFFECT_push].on && scene->length[SHARE_push].m > 0)
        scene->effect[DOM_EFFECT_push].value[0] = scene_push(scene, scene_first_height(scene));
}
