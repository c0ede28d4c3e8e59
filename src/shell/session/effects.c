/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "session/effects.h"
#include "language/names.h"
#include "language/quad.h"
#include "session/rowfile.h"
#include <stdlib.h>
#include <string.h>

const char *effect_file(const struct scene *scene, int name)
{
    return name == DOM_EFFECT_row && scene->listed.domino ? scene->listed.path : NULL;
}

/* Returns true if argument i and all later ones may be left out, because they have their usual values. */
static bool usual_from(const struct domq_effect *e, const struct effect_state *state, int i)
{
    bool usual = i > 0;
    for (; i < DOM_EFFECT_ARGUMENTS && e->argument[i].name; i++)
        usual = usual && e->argument[i].optional && state->value[i] == e->argument[i].usual;
    return usual;
}

const char *effect_setting(const struct scene *scene, int name, char setting[EFFECT_SETTING])
{
    const struct effect_state *state = &scene->effect[name];
    const struct domq_effect *e = effect_at(name);
    const char *path = effect_file(scene, name), *slash = path ? strrchr(path, '/') : NULL;
    snprintf(setting, EFFECT_SETTING, "%s", slash ? slash + 1 : path ? path : state->on ? "" : "off");
    for (int i = 0, n = 0; state->on && !path && i < DOM_EFFECT_ARGUMENTS && e->argument[i].name; i++) {
        const struct domq_effect_argument *of = &e->argument[i];
        char number[WIDE_TEXT];
        if (usual_from(e, state, i))
            break;
        n += snprintf(setting + n, (size_t)(EFFECT_SETTING - n), "%s%s%s%s", n ? ", " : "",
                      of->words ? of->words[(int)state->value[i]] : quad_text(state->value[i], 10, number),
                      *of->unit ? " " : "", of->unit);
    }
    return setting;
}

/* Returns true if effect `name` cannot be on without effect `other`. */
static bool needs(int name, int other)
{
    return effect_at(name)->needs >> other & 1;
}

/* Lists the effects that are on and need the row, as in ", with push and placement". */
static void row_needed(const struct scene *scene, char *text, size_t size)
{
    int n = 0;
    text[0] = '\0';
    for (int k = 0; k < EFFECT_COUNT && n < (int)size; k++)
        if (scene->effect[k].on && needs(k, DOM_EFFECT_row))
            n += snprintf(text + n, size - (size_t)n, "%s%s", n ? " and " : ", with ", effect_at(k)->name);
}

/* Turns off the row and all effects that need it. */
static void row_drop(struct scene *scene)
{
    for (int k = 0; k < EFFECT_COUNT; k++)
        if (k == DOM_EFFECT_row || needs(k, DOM_EFFECT_row))
            scene->effect[k] = (struct effect_state){.on = false};
    listed_free(&scene->listed);
    effects_apply(scene);
}

/* Reads a row from a file. Returns false with a problem. */
static bool row_read(const struct scene *scene, const char *name, const struct means *means,
                     struct listed_row *row, struct problem *problem)
{
    struct csv_table *csv = csv_named(scene, means, name, false, &rowfile_kind, problem);
    if (!csv)
        return false;
    bool good = rowfile_read(csv, scene->train.alpha, row), rounded = false;
    for (size_t k = 0; k < row->count; k++)
        rounded = rounded || row->domino[k].radius > 0;
    if (rounded && !scene->effect[DOM_EFFECT_edges].on)
        means_note(means, "%s:%ld: the radii are used while the effect edges is on: 'effect edges on'",
                   csv->path, csv->head.at.line);
    if (good && *csv->unused)
        means_note(means, "%s:%ld: not used: the columns %s; those that are: %s", csv->path,
                   csv->head.at.line, csv->unused, csv->kind->names);
    /* 'save' may write a script in another directory, and so needs the absolute path. A pipe has no such
     * path, and keeps its name. */
    row->path = good ? realpath(csv->path, NULL) : NULL;
    if (good && !row->path) {
        row->path = csv->path;
        csv->path = NULL;
    }
    return csv_end(csv, problem);
}

bool scene_row_load(struct scene *scene, const char *name, const struct means *means, struct problem *problem)
{
    struct listed_row file = {.domino = NULL};
    struct problem in_file = {.kind = PROBLEM_NONE};
    char needed[256], setting[EFFECT_SETTING], shown[NAMES_SHOWN];
    bool earlier = scene->effect[DOM_EFFECT_row].on;
    if (means->safe)
        problem_error(&in_file,
                      "'effect row %s' reads a file, which a safe session cannot do; use 'effect row N'",
                      names_shown(name, shown));
    else if (row_read(scene, name, means, &file, &in_file)) {
        listed_free(&scene->listed);
        scene->listed = file;
        scene->effect[DOM_EFFECT_row] = (struct effect_state){.on = true};
        return true;
    }
    row_needed(scene, needed, sizeof needed);
    problem_error(problem, earlier ? "%s; the earlier row (%s%s) is now off%s" : "%s", in_file.text,
                  scene->listed.domino ? "" : "N = ", effect_setting(scene, DOM_EFFECT_row, setting), needed);
    row_drop(scene);
    return false;
}

bool effect_needs(const struct scene *scene, int name, struct problem *problem)
{
    for (int k = 0; k < EFFECT_COUNT; k++)
        if (needs(name, k) && !scene->effect[k].on)
            return problem_error(problem, "'effect %s' needs a %s; first enter 'effect %s %s'",
                                 effect_at(name)->name, effect_at(k)->name, effect_at(k)->name,
                                 effect_at(k)->argument[0].name);
    return name >= DOM_DYNAMICS_COUNT || effect_at(name)->cancels || scene->train.fuel != DOM_FUEL_PAPER ||
           problem_no_answer(problem, "'fuel paper' cannot be combined with %s; first enter 'set fuel exact'",
                             effect_at(name)->name);
}

bool effect_complete(const struct scene *scene, int name, const domq_real *value, int given,
                     domq_real all[DOM_EFFECT_ARGUMENTS], struct problem *problem)
{
    const struct domq_effect *e = effect_at(name);
    char usual_value[WIDE_TEXT];
    bool off = given > 0 && value[0] == EFFECT_OFF, usual = off || (given > 0 && value[0] == EFFECT_ON);
    for (int i = 0; i < DOM_EFFECT_ARGUMENTS; i++) {
        if (e->argument[i].name && i >= given && !e->argument[i].optional && !usual)
            return problem_error(problem, "%s, the %s, is missing; for example 'effect %s %s%s%s'",
                                 e->argument[i].name, e->argument[i].meaning, e->name,
                                 quad_text(e->argument[i].usual, 4, usual_value),
                                 *e->argument[i].unit ? " " : "", e->argument[i].unit);
        all[i] = i < given && !usual ? value[i] : e->argument[i].usual;
    }
    if (!off)
        return true;
    all[0] = EFFECT_OFF;
    for (int k = 0; k < EFFECT_COUNT; k++)
        if (scene->effect[k].on && needs(k, name))
            return problem_error(problem, "'effect %s' needs the %s; first enter 'effect %s off'",
                                 effect_at(k)->name, e->name, effect_at(k)->name);
    return true;
}

void effect_put(struct scene *scene, int name, domq_real value, const domq_real *others)
{
    struct effect_state *state = &scene->effect[name];
    for (int i = 1; (others || !state->on) && i < DOM_EFFECT_ARGUMENTS; i++)
        state->value[i] = others ? others[i - 1] : effect_at(name)->argument[i].usual;
    state->on = value != EFFECT_OFF;
    state->value[0] = value;
    if (name == DOM_EFFECT_row)
        scene->listed = (struct listed_row){.domino = NULL};
    effects_apply(scene);
}

bool effects_savable(const struct scene *scene, struct problem *problem)
{
    char shown[NAMES_SHOWN];
    const char *path = scene->listed.domino ? scene->listed.path : "";
    for (const char *c = path; *c; c++)
        if ((unsigned char)*c < ' ' || *c == 0x7f)
            return problem_error(problem,
                                 "cannot save: the name of the row's file, '%s', has a control character; "
                                 "rename the file, or enter 'effect row off'",
                                 names_shown(path, shown));
    return true;
}

/* Writes a path in double quotes. If the file is in or below `folder`, the path begins with "./", so that the
 * script and the file can be moved together. */
static void save_name(const char *path, const char *folder, FILE *out)
{
    size_t length = folder ? strlen(folder) : 0;
    bool below = length > 0 && strncmp(path, folder, length) == 0 && path[length] == '/';
    fputs(below ? " \"." : " \"", out);
    for (const char *c = below ? path + length : path; *c; c++)
        fputs(*c == '"' ? "\"\"" : (char[]){*c, '\0'}, out);
    putc('"', out);
}

void effect_save(const struct scene *scene, int name, const char *folder, FILE *out)
{
    const struct domq_effect *e = effect_at(name);
    const struct effect_state *state = &scene->effect[name];
    const char *path = effect_file(scene, name);
    char number[WIDE_TEXT];
    fprintf(out, state->on ? "effect %s" : "effect %s off", e->name);
    if (path)
        save_name(path, folder, out);
    for (int i = 0; !path && state->on && i < DOM_EFFECT_ARGUMENTS && e->argument[i].name; i++)
        if (!usual_from(e, state, i))
            fprintf(out, " %s",
                    e->argument[i].words ? e->argument[i].words[(int)state->value[i]]
                                         : quad_exact(state->value[i], number));
    putc('\n', out);
    for (size_t i = 0; name == DOM_EFFECT_row && i < scene->listed.changes; i++)
        fprintf(out, "place %zu %s m\n", scene->listed.change[i].k,
                quad_exact(scene->listed.change[i].gap, number));
}

/* ---- The row ---- */

bool scene_has_masses(const struct scene *scene)
{
    return scene_mass(scene) > 0 || (scene->listed.domino && scene->listed.has_masses);
}

/* Scales masses of which only the ratios are known. The first domino gets the mass that the session has for
 * it. If there is no such mass, m g h / 2 of the first domino becomes 1. */
static void row_weigh(const struct scene *scene, struct domq_domino *domino, size_t count)
{
    domq_real mass = scene_block_mass(scene, domino[0].height, domino[0].thickness);
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
    for (size_t i = 0; i < listed->changes; i++)
        domino[listed->change[i].k - 1].gap = listed->change[i].gap;
    for (size_t k = 0; listed->width && k < count; k++)
        domino[k].mass *= scene_filled(scene, domino[k].height, domino[k].thickness, listed->width[k]);
    if (!listed->domino || !listed->has_masses)
        row_weigh(scene, domino, count);
}

/* Returns true if the walls fit into every domino. Otherwise reports the problem. */
static bool walls_fit(const struct scene *scene, const struct domq_domino *domino, size_t count,
                      struct problem *problem)
{
    struct domq_box box;
    for (size_t k = 0; k < count; k++)
        if (domq_box_find(domino[k].height, domino[k].thickness, domino[k].height / 2,
                          scene->train.walls * scene->scale.h, &box) != DOM_OK)
            return problem_no_room(problem, scene, k + 1, domino[k].thickness);
    return true;
}

bool scene_row_list(const struct scene *scene, struct scene_row *row, struct problem *problem)
{
    const struct listed_row *listed = &scene->listed;
    const struct effect_state *effect = scene->effect;
    row->domino = NULL;
    if (!effect[DOM_EFFECT_row].on)
        return problem_error(problem, "there is no row; first enter 'effect row N' or 'effect row FILE'");
    size_t count = listed->domino ? listed->count : (size_t)effect[DOM_EFFECT_row].value[0];
    row->domino = malloc(count * sizeof *row->domino);
    if (!row->domino)
        return problem_status(problem, scene, DOM_NO_MEMORY);
    scene_row_fill(scene, row->domino, count);
    if (scene->train.walls > 0 && !walls_fit(scene, row->domino, count, problem)) {
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
    row->row.walls *= scene->scale.h; /* converts from fractions of h to m */
    row->compute = scene->compute;
    return true;
}

/* Returns true if no domino of a row would fall over by itself. Otherwise reports the problem. */
static bool row_stands(const struct scene *scene, const struct domq_row *row, struct problem *problem)
{
    for (size_t k = 0; k < row->count; k++) {
        const struct domq_domino *domino = &row->domino[k];
        const bool listed = scene->listed.domino;
        char message[LEAN_MESSAGE];
        domq_real level[2];
        domq_lean_limits(domino, 0, row->rho, level);
        if (row->alpha != 0 && !(quad(fabs)(row->alpha) < level[1]))
            return problem_no_stand(problem, scene, listed ? k + 1 : 0, level[1]);
        if (row->rho == 0 && !lean_stands(domino, row->alpha, message))
            return problem_no_answer(problem, "domino %zu: %s", k + 1, message);
    }
    return true;
}

/* The relative tolerance of searches that run the engine. */
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

bool scene_row_place(struct scene *scene, size_t k, domq_real gap, struct problem *problem)
{
    struct scene_row row = {.domino = NULL};
    struct listed_row *listed = &scene->listed;
    if (!scene_row_list(scene, &row, problem))
        return false;
    size_t count = row.row.count, i = 0;
    free(row.domino);
    if (count < 2)
        return problem_error(problem, "a row of one domino has no gap; enter 'effect row N' with a larger N");
    if (k < 2 || k > count)
        return problem_error(problem, "there is no gap before domino %zu; K is 2 .. %zu in this row", k,
                             count);
    while (i < listed->changes && listed->change[i].k != k)
        i++;
    struct gap_change *more =
        i < listed->changes ? listed->change : realloc(listed->change, (i + 1) * sizeof *listed->change);
    if (!more)
        return problem_status(problem, scene, DOM_NO_MEMORY);
    listed->change = more;
    listed->change[i] = (struct gap_change){k, gap};
    listed->changes += i == listed->changes;
    listed->saved = false;
    return true;
}
