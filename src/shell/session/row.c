/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "session/row.h"
#include "answer/measure.h"
#include "language/quad.h"
#include "session/rowfile.h"
#include <stdlib.h>
#include <string.h>

bool scene_has_masses(const struct scene *scene)
{
    return scene_mass(scene) > 0 || (scene->listed.domino && scene->listed.has_masses);
}

/* Scales the masses of a row. Before the call, only their ratios are correct. The first domino gets the mass
 * that 'mass' or 'density' gives, and the other masses change by the same factor. If neither is known, the
 * mass of the first domino is chosen so that m g h/2 = 1. */
static void row_weigh(const struct scene *scene, struct domq_domino *domino, size_t count)
{
    domq_real mass = scene_first_mass(scene, domino);
    domq_real first = mass > 0 ? mass : 2 / (scene->scale.g * domino[0].height), by = first / domino[0].mass;
    for (size_t k = 0; k < count; k++)
        domino[k].mass *= by;
}

void scene_row_fill(const struct scene *scene, struct domq_domino *domino, size_t count)
{
    const struct listed_row *listed = &scene->listed;
    if (listed->domino)
        memcpy(domino, listed->domino, count * sizeof *domino);
    else
        domq_row_of_train(&scene->train, &scene->scale, 1, domino, count);
    for (size_t k = 0; k < count; k++) {
        struct domq_domino *d = &domino[k];
        const bool has_width = d->width > 0;
        if (!has_width)
            d->width = scene_width(scene, d->height);
        if (listed->from_volumes) /* with the width that the file gives, or with half the height */
            d->mass *= (has_width ? 1 : d->width / (d->height / 2)) * scene_filled(scene, d);
        else if (!listed->domino && scene_boxes_above(scene) > 0)
            d->mass = d->height * d->width * d->thickness * scene_filled(scene, d);
    }
    if (!listed->domino || !listed->has_masses)
        row_weigh(scene, domino, count);
    for (size_t k = 0; k < count; k++)
        row_changes_apply(scene, k, &domino[k]);
    /* If the masses are not known, m g h/2 of the first domino must be 1. A change may have altered it. */
    if (listed->changes > 0 && !scene_has_masses(scene))
        row_weigh(scene, domino, count);
}

static bool walls_fit(const struct scene *scene, const struct domq_domino *domino, size_t count,
                      struct problem *problem)
{
    struct domq_box box;
    for (size_t k = 0; k < count; k++)
        if (domino[k].height > scene_boxes_above(scene) &&
            domq_box_find(domino[k].height, domino[k].thickness, domino[k].width, scene_walls(scene), &box) !=
                DOM_OK)
            return problem_no_room(problem, scene, k + 1, domino[k].thickness);
    return true;
}

bool scene_row_list(const struct scene *scene, struct scene_row *row, struct problem *problem)
{
    const struct listed_row *listed = &scene->listed;
    const struct effect_state *effect = scene->effect;
    row->domino = NULL;
    if (!effect[DOM_EFFECT_row].on)
        return problem_error(problem, "there is no row; first enter 'set row N' or 'set row FILE'");
    size_t count = listed->domino ? listed->count : (size_t)effect[DOM_EFFECT_row].value[0];
    row->domino = malloc(count * sizeof *row->domino);
    if (!row->domino)
        return problem_status(problem, scene, DOM_NO_MEMORY);
    scene_row_fill(scene, row->domino, count);
    if (scene_walls(scene) > 0 && !walls_fit(scene, row->domino, count, problem)) {
        free(row->domino);
        row->domino = NULL;
        return false;
    }
    row->row = (struct domq_row){
        .domino = row->domino,
        .count = count,
        .g = scene->scale.g,
        .push = effect[DOM_EFFECT_push].on ? effect[DOM_EFFECT_push].value[0] : DOMQ_NAN,
#define VALUE(name, member, status) .member = scene->train.member,
        DOM_DYNAMICS(VALUE)
#undef VALUE
            .floor = effect[DOM_EFFECT_floor].on,
    };
    row->row.walls = scene_walls(scene);
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

/* The smallest relative tolerance of searches that run the engine. */
#define ENGINE_TOL ((domq_real)1 / 10000)

bool scene_row_make(const struct scene *scene, struct scene_row *row, struct problem *problem)
{
    if (!scene_row_list(scene, row, problem))
        return false;
    bool good = row_stands(scene, &row->row, problem);
    if (good && scene_has_engine(scene)) {
        good = scene_engine_make(scene, row->row.count, &row->engine, problem);
        row->row.engine = &row->engine.engine;
        row->compute.tol = quad_larger(row->compute.tol, ENGINE_TOL);
    }
    if (!good)
        free(row->domino);
    return good;
}

/* ---- Changes ---- */

/* A value without a unit is probably a mistake if it is at least this many times the current value. */
#define SLIP_OF_UNIT 50

/* Checks a value that was typed without a unit. Such a value is in m or kg, but the user may have meant mm or
 * g: a height of 25 would be 25 m. If the value is not plausible, reports the problem and returns false. */
static bool bare_likely(const struct domq_domino *row, size_t k, enum row_measure measure, domq_real now,
                        domq_real value, struct problem *problem)
{
    const bool is_gap = measure == MEASURE_GAP, is_mass = measure == MEASURE_MASS;
    const char *unit = is_mass ? "kg" : "m", *write = is_mass ? "g" : "mm";
    const domq_real tall = is_gap ? row[k - 1].height : now;
    /* a gap is not plausible if it exceeds the heights of both its dominoes */
    if (is_gap ? value <= tall || value <= row[k].height
               : measure == MEASURE_RADIUS || measure == MEASURE_LEAN || value < SLIP_OF_UNIT * now)
        return true;
    return problem_error(problem,
                         "a %s of %s without a unit would be %s, but domino %zu is %s%s; write '%s %s', or "
                         "the unit that you mean",
                         row_measure_names(NULL, (int)measure), quad_text(value, 10),
                         measured(value, unit, 6).text, k + !is_gap, measured(tall, unit, 4).text,
                         is_gap || measure == MEASURE_HEIGHT ? " tall"
                         : is_mass                           ? " now"
                         : measure == MEASURE_WIDTH          ? " wide"
                                                             : " thick",
                         quad_text(value, 10), write);
}

domq_real scene_row_measure(const struct scene *scene, const struct domq_domino *domino,
                            enum row_measure measure)
{
    struct domq_domino d = *domino;
    return measure == MEASURE_LEAN                      ? lean_offset(&d)
           : measure == MEASURE_RADIUS && d.radius == 0 ? scene->train.rho * d.height
                                                        : *row_measure_at(&d, measure);
}

/* Returns the lean angle of a domino whose top is off plumb by `off` metres. */
static domq_real lean_angle(domq_real off, domq_real height)
{
    return quad(fabs)(off) < height ? quad(asin)(off / height) : (off < 0 ? -1 : 1) * QUAD_PI / 2;
}

/* Computes the value that a measurement of domino k, counted from 0, has after a change. Stores the value in
 * *kept in the form of listed_row.change: a mass as a factor, and a lean as an angle. If the domino cannot
 * have this value, sets *problem and returns false. */
static bool domino_change(const struct scene *scene, const struct row_change *change,
                          const struct scene_row *row, size_t k, domq_real *kept, struct problem *problem)
{
    const enum row_measure measure = change->measure;
    const bool is_lean = measure == MEASURE_LEAN, is_mass = measure == MEASURE_MASS;
    struct domq_domino d = row->domino[k], *domino = &d;
    domq_real *member = row_measure_at(domino, measure),
              now = is_lean && change->is_angle ? domino->lean : scene_row_measure(scene, domino, measure),
              value = change->how == CHANGE_TO   ? change->value
                      : change->how == CHANGE_BY ? now + change->value
                                                 : now * change->value;
    const struct listed_row *listed = &scene->listed;
    const domq_real before = is_mass && listed->changes > 0 ? listed->change[k].mass : DOMQ_NAN;
    char message[MISFIT_MESSAGE];
    if (change->is_bare && !bare_likely(row->domino, k, measure, now, value, problem))
        return false;
    if (!csv_fits(&rowfile_kind.column[measure], value, message))
        return problem_no_answer(problem, "domino %zu: %s", k + 1, message);
    if (is_lean && !change->is_angle)
        value = lean_angle(value, domino->height);
    if (row_measure_is_size(measure))
        domino->mass *= value / *member;
    *kept = !is_mass ? value : change->how == CHANGE_TIMES ? change->value : value / now;
    *kept *= isnan(before) ? 1 : before;
    *member = value;
    return (domino_misfit(domino, scene->train.alpha, message) == ROW_MEASURES &&
            csv_fits(&rowfile_kind.column[MEASURE_MASS], domino->mass, message)) ||
           problem_no_answer(problem, "domino %zu: %s", k + 1, message);
}

/* Checks that all dominoes in the ranges exist and have this measurement. The only measurement that can be
 * missing is the gap before the first domino. */
static bool ranges_check(const struct row_range *range, int ranges, enum row_measure measure, size_t count,
                         struct problem *problem)
{
    const size_t first = measure == MEASURE_GAP ? 2 : 1;
    if (count < first)
        return problem_error(problem, "a row of one domino has no gap; enter 'set row N' with a larger N");
    for (int i = 0; i < ranges; i++) {
        const size_t wrong = range[i].first < first ? range[i].first : range[i].last;
        if ((wrong < first || wrong > count) && measure == MEASURE_GAP)
            return problem_error(problem, "there is no gap before domino %zu; choose a domino from 2 to %zu",
                                 wrong, count);
        if (wrong < first || wrong > count)
            return problem_error(problem, "there is no domino %zu; this row has %zu", wrong, count);
    }
    return true;
}

/* Changes the row of a scene, which must own the row. On failure, sets *problem and returns false. */
static bool row_change(struct scene *scene, const struct scene_row *row, const struct row_change *change,
                       const struct row_range *range, int ranges, struct problem *problem)
{
    struct scene_row changed;
    struct listed_row next;
    if (!listed_share(&next, &scene->listed) || !row_changes_open(&next, row->row.count)) {
        listed_free(&next);
        return problem_status(problem, scene, DOM_NO_MEMORY);
    }
    bool good = true;
    for (int i = 0; i < ranges; i++)
        for (size_t k = range[i].first - 1; good && k < range[i].last; k++)
            good = domino_change(scene, change, row, k, row_measure_at(&next.change[k], change->measure),
                                 problem);
    struct listed_row before = scene->listed;
    next.saved = false;
    scene->listed = next;
    good = good && scene_row_list(scene, &changed, problem); /* checks the walls, too */
    if (good)
        free(changed.domino);
    else
        scene->listed = before;
    listed_free(good ? &before : &next);
    return good;
}

bool scene_row_change(struct scene *scene, const struct row_change *change, const struct row_range *range,
                      int ranges, struct problem *problem)
{
    struct scene_row row = {.domino = NULL};
    if (!scene_row_list(scene, &row, problem))
        return false;
    bool good = ranges_check(range, ranges, change->measure, row.row.count, problem);
    if (good && change->measure == MEASURE_MASS && change->how != CHANGE_TIMES && !scene_has_masses(scene))
        good = problem_error(problem, "the masses of this row are not known; enter the mass of its first "
                                      "domino with 'set mass', or a relative change such as '+10 %%'");
    good = good && row_change(scene, &row, change, range, ranges, problem);
    free(row.domino);
    return good;
}
