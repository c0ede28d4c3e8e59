/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "session/effects.h"
#include "language/names.h"
#include "language/quad.h"
#include "language/text.h"
#include <stdlib.h>
#include <string.h>

const char *effect_file(const struct scene *scene, int effect)
{
    return effect == DOM_EFFECT_row && scene->listed.domino ? scene->listed.path : NULL;
}

/* Returns true if argument i and all arguments after it are optional and have their usual values. */
static bool usual_from(const struct domq_effect *e, const struct effect_state *state, int i)
{
    bool usual = i > 0;
    for (; i < DOM_EFFECT_ARGUMENTS && e->argument[i].name; i++)
        usual = usual && e->argument[i].optional && state->value[i] == e->argument[i].usual;
    return usual;
}

/* Returns the word for value i of an effect, or NULL if it is a number. */
static const char *value_word(const struct scene *scene, int effect, int i)
{
    const domq_real value = scene->effect[effect].value[i];
    const char *const *words = effect_at(effect)->argument[i].words;
    return words                                                    ? words[(int)value]
           : effect == DOM_EFFECT_release && value == RELEASE_TOUCH ? RELEASE_TOUCH_WORD
                                                                    : NULL;
}

const char *effect_setting_write(const struct scene *scene, int effect, char setting[EFFECT_SETTING])
{
    const struct effect_state *state = &scene->effect[effect];
    const struct domq_effect *e = effect_at(effect);
    const char *path = effect_file(scene, effect), *slash = path ? strrchr(path, '/') : NULL;
    snprintf(setting, EFFECT_SETTING, "%s", slash ? slash + 1 : path ? path : state->on ? "" : "off");
    for (int i = 0; state->on && !path && i < DOM_EFFECT_ARGUMENTS && e->argument[i].name; i++) {
        const struct domq_effect_argument *of = &e->argument[i];
        if (usual_from(e, state, i))
            break;
        const char *word = value_word(scene, effect, i);
        text_add(setting, EFFECT_SETTING, "%s%s%s%s", i ? ", " : "",
                 word ? word : quad_text(state->value[i], 10), *of->unit && !word ? " " : "",
                 word ? "" : of->unit);
    }
    /* a row from which dominoes were removed, or into which some were inserted */
    if (effect == DOM_EFFECT_row && scene_row_count(scene) != scene_row_planned(scene))
        text_add(setting, EFFECT_SETTING, ", now %zu", scene_row_count(scene));
    return setting;
}

/* Returns true if `effect` cannot be on without the effect `other`. An effect that is about rows waits until
 * there is a row. */
static bool needs(int effect, int other)
{
    return other != DOM_EFFECT_row && (effect_at(effect)->needs >> other & 1) != 0;
}

bool effect_check_needs(const struct scene *scene, int effect, struct problem *problem)
{
    for (int k = 0; k < EFFECT_COUNT; k++)
        if (needs(effect, k) && !scene->effect[k].on)
            return problem_error(problem, "'set %s' needs the effect %s; first enter 'set %s %s'",
                                 effect_at(effect)->name, effect_at(k)->name, effect_at(k)->name,
                                 effect_at(k)->argument[0].name);
    return effect >= DOM_DYNAMICS_COUNT || effect_at(effect)->cancels ||
           scene->train.fuel != DOM_FUEL_PAPER ||
           problem_no_answer(problem, "'fuel paper' cannot be combined with %s; first enter 'set fuel exact'",
                             effect_at(effect)->name);
}

bool effect_complete(const struct scene *scene, int effect, const domq_real *value, int given,
                     domq_real all[DOM_EFFECT_ARGUMENTS], struct problem *problem)
{
    const struct domq_effect *e = effect_at(effect);
    bool off = given > 0 && value[0] == EFFECT_OFF, usual = off || (given > 0 && value[0] == EFFECT_ON);
    for (int i = 0; i < DOM_EFFECT_ARGUMENTS; i++) {
        if (e->argument[i].name && i >= given && !e->argument[i].optional && !usual)
            return problem_error(problem, "%s, the %s, is missing; enter, for example, 'set %s %s%s%s'",
                                 e->argument[i].name, e->argument[i].meaning, e->name,
                                 quad_text(e->argument[i].usual, 4), *e->argument[i].unit ? " " : "",
                                 e->argument[i].unit);
        all[i] = i < given && !usual ? value[i] : e->argument[i].usual;
    }
    if (!off)
        return true;
    all[0] = EFFECT_OFF;
    for (int k = 0; k < EFFECT_COUNT; k++)
        if (scene->effect[k].on && needs(k, effect))
            return problem_error(problem, "'set %s' needs the %s; first enter 'set %s off'",
                                 effect_at(k)->name, e->name, effect_at(k)->name);
    return true;
}

void effect_put(struct scene *scene, int effect, domq_real value, const domq_real *others)
{
    struct effect_state *state = &scene->effect[effect];
    for (int i = 1; (others || !state->on) && i < DOM_EFFECT_ARGUMENTS; i++)
        state->value[i] = others ? others[i - 1] : effect_at(effect)->argument[i].usual;
    state->on = value != EFFECT_OFF;
    state->value[0] = value;
    if (effect == DOM_EFFECT_row)
        scene->listed = (struct listed_row){.domino = NULL};
    effects_apply(scene);
}

bool effects_savable(const struct scene *scene, struct problem *problem)
{
    const char *path = scene->listed.domino ? scene->listed.path : "";
    for (const char *c = path; *c; c++)
        if ((unsigned char)*c < ' ' || *c == 0x7f)
            return problem_error(
                problem,
                "cannot save: the name of the row's file, '%s', contains a control character; "
                "rename the file, or enter 'set row off'",
                names_shown(path));
    return true;
}

/* Writes a path in double quotes. If the file is below the directory `folder` of the script, the path is
 * written relative to the script, beginning with "./". The script and the file can then be moved together. */
static void save_name(const char *path, const char *folder, FILE *out)
{
    size_t length = folder ? strlen(folder) : 0;
    bool below = length > 0 && strncmp(path, folder, length) == 0 && path[length] == '/';
    fputs(below ? " \"." : " \"", out);
    for (const char *c = below ? path + length : path; *c; c++)
        fputs(*c == '"' ? "\"\"" : (char[]){*c, '\0'}, out);
    putc('"', out);
}

void effect_save(const struct scene *scene, int effect, const char *folder, FILE *out)
{
    const struct domq_effect *e = effect_at(effect);
    const struct effect_state *state = &scene->effect[effect];
    const char *path = effect_file(scene, effect);
    char number[WIDE_TEXT];
    fprintf(out, state->on ? "set %s" : "set %s off", e->name);
    if (path)
        save_name(path, folder, out);
    const struct typed_length *length = effect == DOM_EFFECT_walls   ? &scene->length[SHARE_walls]
                                        : effect == DOM_EFFECT_edges ? &scene->length[SHARE_edges]
                                        : effect == DOM_EFFECT_push  ? &scene->length[SHARE_push]
                                                                     : NULL;
    const bool is_length = length && length->m > 0 && state->on;
    if (is_length)
        fprintf(out, " %s", length_write(length->m, length->unit, (char[LENGTH_TEXT]){""}));
    for (int i = is_length; !path && state->on && i < DOM_EFFECT_ARGUMENTS && e->argument[i].name; i++)
        if (!usual_from(e, state, i)) {
            const char *word = value_word(scene, effect, i);
            fprintf(out, " %s", word ? word : quad_exact(state->value[i], WIDE_DIGITS, number));
        }
    putc('\n', out);
}
