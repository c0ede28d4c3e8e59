/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "session/row.h"
#include "answer/cell.h"
#include "language/quad.h"
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

/* ---- The engine ---- */

const struct engine_driver *row_engine;

bool scene_has_engine(const struct scene *scene)
{
    return scene->effect[DOM_EFFECT_row].on &&
           (scene->method == METHOD_ENGINE || scene->effect[EFFECT_feet].on ||
            scene->effect[EFFECT_bounce].on);
}

const char *scene_engine_why(const struct scene *scene)
{
    return scene->effect[EFFECT_feet].on     ? "feet is on"
           : scene->effect[EFFECT_bounce].on ? "bounce is on"
                                             : "method is engine";
}

/* ---- Changes to single dominoes ---- */

domq_real *row_measure_at(struct domq_domino *domino, enum row_measure measure)
{
    static const size_t member[ROW_MEASURES] = {
        [MEASURE_HEIGHT] = offsetof(struct domq_domino, height),
        [MEASURE_THICKNESS] = offsetof(struct domq_domino, thickness),
        [MEASURE_GAP] = offsetof(struct domq_domino, gap),
        [MEASURE_MASS] = offsetof(struct domq_domino, mass),
        [MEASURE_RADIUS] = offsetof(struct domq_domino, radius),
        [MEASURE_LEAN] = offsetof(struct domq_domino, lean),
        [MEASURE_WIDTH] = offsetof(struct domq_domino, width),
    };
    return (void *)((char *)domino + member[measure]);
}

/* Returns the stored change of a measurement, or NaN if the measurement has not been changed. */
static domq_real changed(const struct listed_row *row, size_t k, enum row_measure measure)
{
    return k < row->changes ? *row_measure_at(&row->change[k].to, measure) : DOMQ_NAN;
}

/* Applies the stored changes to domino k of the row, counted from 0. */
static void row_changes_apply(const struct scene *scene, size_t k, struct domq_domino *d)
{
    for (enum row_measure m = 0; m < ROW_MEASURES; m++) {
        domq_real value = changed(&scene->listed, k, m), *member = row_measure_at(d, m);
        if (isnan(value))
            continue;
        if (row_measure_is_size(m)) {
            /* Dominoes above a certain height can be boxes. With its new size, a solid domino may become a
             * box, or a box may become a solid domino. */
            d->mass *= value / *member / scene_filled(scene, d);
            *member = value;
            d->mass *= scene_filled(scene, d);
        } else
            *member = m == MEASURE_MASS ? *member * value : value;
    }
}

bool row_changes_open(struct listed_row *row, size_t count)
{
    if (row->change)
        return true;
    row->change = malloc(count * sizeof *row->change);
    row->changes = row->change ? count : 0;
    for (size_t k = 0; k < row->changes; k++) {
        row->change[k].origin = k;
        for (enum row_measure m = 0; m < ROW_MEASURES; m++)
            *row_measure_at(&row->change[k].to, m) = DOMQ_NAN;
    }
    return row->change;
}

/* ---- The row ---- */

bool scene_has_masses(const struct scene *scene)
{
    return scene_mass(scene) > 0 || (scene->listed.domino && scene->listed.has_masses);
}

/* Scales the masses of a row. Before the call, only their ratios are correct. `first` is the first domino of
 * the file or of the train. It has the mass that 'mass' or 'density' gives, and the other masses change by
 * the same factor. If neither is known, its mass is chosen so that m g h/2 = 1. */
static void row_weigh(const struct scene *scene, const struct domq_domino *first, struct domq_domino *domino,
                      size_t count)
{
    const domq_real known = scene_first_mass(scene, first),
                    mass = known > 0 ? known : 2 / (scene->scale.g * first->height), by = mass / first->mass;
    for (size_t k = 0; k < count; k++)
        domino[k].mass *= by;
}

/* Writes the dominoes of the file or of the train from which the dominoes of a changed row originate. Has the
 * same rounding errors as domq_row_of_train. */
static void origins_fill(const struct scene *scene, struct domq_domino *domino, size_t count)
{
    const struct listed_row *listed = &scene->listed;
    const struct domq_train *t = &scene->train;
    const domq_real heavier = quad(pow)(t->r, t->q - 1);
    domq_real height = scene->scale.h, mass = 1;
    for (size_t k = 0, i = 0; k < count; k++) {
        for (; !listed->domino && i < listed->change[k].origin; i++) {
            height *= t->r;
            mass *= heavier;
        }
        domino[k] = listed->domino ? listed->domino[listed->change[k].origin]
                                   : (struct domq_domino){.height = height,
                                                          .thickness = t->d * height,
                                                          .gap = i > 0 ? t->s * height : 0,
                                                          .width = t->width * height,
                                                          .mass = mass};
    }
}

/* Gives a domino of the file or of the train its width and, if masses follow from volumes, its mass. */
static void domino_complete(const struct scene *scene, struct domq_domino *d)
{
    const struct listed_row *listed = &scene->listed;
    const bool has_width = d->width > 0;
    if (!has_width)
        d->width = scene_width(scene, d->height);
    if (listed->from_volumes) /* with the width that the file gives, or with half the height */
        d->mass *= (has_width ? 1 : d->width / (d->height / 2)) * scene_filled(scene, d);
    else if (!listed->domino && scene_boxes_above(scene) > 0)
        d->mass = d->height * d->width * d->thickness * scene_filled(scene, d);
}

void scene_row_fill(const struct scene *scene, struct domq_domino *domino, size_t count)
{
    const struct listed_row *listed = &scene->listed;
    struct domq_domino first;
    if (listed->domino)
        first = listed->domino[0];
    else
        domq_row_of_train(&scene->train, &scene->scale, 1, &first, 1);
    domino_complete(scene, &first);
    if (listed->changes > 0)
        origins_fill(scene, domino, count);
    else if (listed->domino)
        memcpy(domino, listed->domino, count * sizeof *domino);
    else
        domq_row_of_train(&scene->train, &scene->scale, 1, domino, count);
    for (size_t k = 0; k < count; k++)
        domino_complete(scene, &domino[k]);
    if (!listed->domino || !listed->has_masses)
        row_weigh(scene, &first, domino, count);
    for (size_t k = 0; k < count; k++)
        row_changes_apply(scene, k, &domino[k]);
    domino[0].gap = 0;
    /* If the masses are not known, m g h/2 of the first domino must be 1. A change may have altered it. */
    if (listed->changes > 0 && !scene_has_masses(scene))
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

bool problem_no_row(struct problem *problem)
{
    return problem_error(problem, "there is no row; first enter 'set row N' or 'set row FILE'");
}

bool scene_row_list(const struct scene *scene, struct scene_row *row, struct problem *problem)
{
    const struct effect_state *effect = scene->effect;
    row->domino = NULL;
    if (!effect[DOM_EFFECT_row].on)
        return problem_no_row(problem);
    const size_t count = scene_row_count(scene);
    row->domino = malloc(count * sizeof *row->domino);
    if (!row->domino)
        return problem_status(problem, scene, DOM_NO_MEMORY);
    scene_row_fill(scene, row->domino, count);
    row->row = (struct domq_row){.domino = row->domino,
                                 .count = count,
                                 .g = scene->scale.g,
                                 .push = scene_push(scene, row->domino->height),
                                 .release = scene_release(scene),
#define VALUE(name, member, status) .member = scene->train.member,
                                 DOM_DYNAMICS(VALUE)
#undef VALUE
    };
    row->row.walls = scene_walls(scene);
    row->row.air = scene_has_masses(scene) ? effect_value(scene, DOM_EFFECT_air, 0) : row->row.air;
    row->row.boxes_above = scene_boxes_above(scene);
    row->compute = scene->compute;
    return true;
}

/* Checks that no domino of a row would fall over by itself. */
static bool row_stands(const struct scene *scene, const struct domq_row *row, struct problem *problem)
{
    for (size_t k = 0; k < row->count; k++) {
        const struct domq_domino *domino = &row->domino[k];
        const bool listed = scene->listed.domino;
        char message[LEAN_MESSAGE];
        domq_real level[2];
        if (dom_raised(scene->compute.interrupt))
            return problem_status(problem, scene, DOM_INTERRUPTED);
        domq_lean_limits(domino, 0, row->rho, level);
        if (row->alpha != 0 && !(quad(fabs)(row->alpha) < level[1]))
            return problem_no_stand(problem, scene, listed ? k + 1 : 0, level[1]);
        if (row->rho == 0 && !lean_stands(domino, row->alpha, message))
            return problem_no_answer(problem, "domino %zu: %s", k + 1, message);
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

/* Checks that the walls fit into the dominoes of a row, and that the dominoes stand. */
static bool scene_row_check(const struct scene *scene, const struct scene_row *row, struct problem *problem)
{
    return scene_walls_fit(scene, row, problem) && row_stands(scene, &row->row, problem) &&
           row_has_room(scene, row, problem);
}

/* The smallest relative tolerance of searches that run the engine. */
#define ENGINE_TOL ((domq_real)1 / 10000)

bool scene_row_make(const struct scene *scene, struct scene_row *row, struct problem *problem)
{
    if (!scene_row_list(scene, row, problem))
        return false;
    bool good = scene_row_check(scene, row, problem);
    if (good && scene_has_engine(scene)) {
        good = row_engine->make(scene, row->row.count, &row->engine, problem);
        row->row.engine = &row->engine.engine;
        row->compute.tol = quad_larger(row->compute.tol, ENGINE_TOL);
    }
    if (!good)
        free(row->domino);
    return good;
}

domq_real scene_first_height(const struct scene *scene)
{
    struct domq_domino first = {.height = scene->scale.h};
    if (scene->effect[DOM_EFFECT_row].on)
        scene_row_fill(scene, &first, 1);
    return first.height;
}

domq_real scene_push(const struct scene *scene, domq_real height)
{
    const struct effect_state *push = &scene->effect[DOM_EFFECT_push];
    const domq_real speed = scene->length[SHARE_push].m;
    const bool is_released = scene->effect[DOM_EFFECT_release].on;
    return !push->on ? (is_released ? 0 : DOMQ_NAN) : speed > 0 ? speed / height : push->value[0];
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
