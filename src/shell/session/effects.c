/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "session/effects.h"
#include "language/names.h"
#include "language/quad.h"
#include "session/rowfile.h"
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

const char *effect_names(const void *context, int k)
{
    (void)context;
    return k < DOM_EFFECT_COUNT ? domq_effect((enum dom_effect_name)k)->name : NULL;
}

bool effect_hint(const char *word, char message[NAMES_MESSAGE])
{
    char usage[EFFECT_USAGE];
    int k = names_exact(effect_names, NULL, word);
    if (k >= 0)
        snprintf(message, NAMES_MESSAGE, "'%s' is an effect: 'effect %s'", word,
                 effect_usage((enum dom_effect_name)k, usage));
    return k >= 0;
}

const char *effect_usage(enum dom_effect_name name, char usage[EFFECT_USAGE])
{
    const struct domq_effect *e = domq_effect(name);
    int n = snprintf(usage, EFFECT_USAGE, "%s", e->name);
    for (int i = 0; i < DOM_EFFECT_ARGUMENTS && e->argument[i].name; i++)
        n += snprintf(usage + n, (size_t)(EFFECT_USAGE - n),
                      e->argument[i].optional  ? " [%s]"
                      : e->argument[i].or_file ? " %s|FILE"
                                               : " %s",
                      e->argument[i].name);
    return usage;
}

const char *effect_setting(const struct session *session, enum dom_effect_name name,
                           char setting[EFFECT_SETTING])
{
    const struct effect_state *state = &session->effect[name];
    const struct domq_effect *e = domq_effect(name);
    setting[0] = '\0';
    if (name == DOM_EFFECT_row && state->on && session->listed.domino) {
        const char *slash = strrchr(session->listed.path, '/');
        snprintf(setting, EFFECT_SETTING, "%s", slash ? slash + 1 : session->listed.path);
        return setting;
    }
    for (int i = 0, n = 0; state->on && i < DOM_EFFECT_ARGUMENTS && e->argument[i].name; i++) {
        const struct domq_effect_argument *of = &e->argument[i];
        char number[WIDE_TEXT];
        if (i > 0 && of->optional && state->value[i] == of->usual)
            break;
        n += snprintf(setting + n, (size_t)(EFFECT_SETTING - n), "%s%s%s%s", n ? ", " : "",
                      quad_text(state->value[i], 10, number), *of->unit ? " " : "", of->unit);
    }
    return setting;
}

/* The file as named, or, where there is none, beside the script that names it. */
static char *path_beside(const struct session *session, const char *path)
{
    const char *slash = session->source ? strrchr(session->source, '/') : NULL;
    if (!slash || *path == '/' || access(path, F_OK) == 0)
        return strdup(path);
    size_t length = (size_t)(slash - session->source) + 1;
    char *beside = malloc(length + strlen(path) + 1);
    if (beside) {
        memcpy(beside, session->source, length);
        memcpy(beside + length, path, strlen(path) + 1);
    }
    return beside;
}

/* What is on and says nothing without the row, as ", with push and placement". */
static void row_needed(const struct session *session, char *text, size_t size)
{
    int n = 0;
    text[0] = '\0';
    for (int k = 0; k < DOM_EFFECT_COUNT && n < (int)size; k++)
        if (session->effect[k].on && domq_effect((enum dom_effect_name)k)->needs >> DOM_EFFECT_row & 1)
            n += snprintf(text + n, size - (size_t)n, "%s%s", n ? " and " : ", with ",
                          domq_effect((enum dom_effect_name)k)->name);
}

/* Row off, and what needs it. */
static void row_drop(struct session *session)
{
    for (int k = 0; k < DOM_EFFECT_COUNT; k++)
        if (k == DOM_EFFECT_row || domq_effect((enum dom_effect_name)k)->needs >> DOM_EFFECT_row & 1)
            session->effect[k] = (struct effect_state){.on = false};
    listed_free(&session->listed);
    effects_apply(session);
}

/* False: an error was reported, and there is no row any more: what was asked for is not the one before. */
static bool row_from_file(struct session *session, const char *name)
{
    struct rowfile file = {.domino = NULL};
    char then[EFFECT_SETTING + 160] = "", setting[EFFECT_SETTING], needed[64], shown[NAMES_SHOWN],
                               *kept = NULL;
    row_needed(session, needed, sizeof needed);
    if (session->effect[DOM_EFFECT_row].on)
        snprintf(then, sizeof then, "; the row before it (%s%s) is off now%s",
                 session->listed.domino ? "" : "N = ", effect_setting(session, DOM_EFFECT_row, setting),
                 needed);
    if (session->safe) {
        session_error(session, "'row %s' reads a file, which a safe session does not%s",
                      names_shown(name, shown), then);
    } else {
        char *path = path_beside(session, name);
        bool read = path && rowfile_read(session, path, then, &file);
        /* What is saved is found from anywhere; a pipe has no other path. */
        kept = read ? realpath(path, NULL) : NULL;
        if (read && !kept)
            kept = path;
        else
            free(path);
        if (!path)
            session_error(session, "%s%s", dom_status_text(DOM_NO_MEMORY), then);
    }
    if (!kept) {
        rowfile_free(&file);
        row_drop(session);
        return false;
    }
    listed_free(&session->listed);
    session->listed = (struct listed_row){
        .domino = file.domino, .count = file.count, .weighed = file.weighed, .path = kept};
    return true;
}

bool effect_needs(struct session *session, enum dom_effect_name name)
{
    char usage[EFFECT_USAGE];
    for (int k = 0; k < DOM_EFFECT_COUNT; k++)
        if (domq_effect(name)->needs >> k & 1 && !session->effect[k].on)
            return session_error(session, "%s is about a %s: 'effect %s' first", domq_effect(name)->name,
                                 domq_effect((enum dom_effect_name)k)->name,
                                 effect_usage((enum dom_effect_name)k, usage));
    if (name == DOM_EFFECT_friction && session->train.fuel == DOM_FUEL_PAPER)
        return session_error(
            session, "the paper's closed form of the fuel knows no friction: they exclude each other; "
                     "'set fuel exact' first");
    return true;
}

bool effect_turn_on(struct session *session, enum dom_effect_name name, const domq_real *value, int given,
                    const char *path)
{
    const struct domq_effect *e = domq_effect(name);
    struct effect_state state = {.on = true};
    char usage[EFFECT_USAGE];
    for (int i = 0; i < DOM_EFFECT_ARGUMENTS && e->argument[i].name; i++) {
        if (i >= given && !(i == 0 && path) && !e->argument[i].optional)
            return session_error(session, "%s is missing, the %s; usage: effect %s", e->argument[i].name,
                                 e->argument[i].meaning, effect_usage(name, usage));
        state.value[i] = i < given ? value[i] : e->argument[i].usual;
    }
    if (!effect_needs(session, name) || (path && !row_from_file(session, path)))
        return false;
    if (name == DOM_EFFECT_row && !path)
        listed_free(&session->listed);
    session->effect[name] = state;
    effects_apply(session);
    return true;
}

void effect_put(struct session *session, enum dom_effect_name name, domq_real value)
{
    const struct domq_effect *e = domq_effect(name);
    struct effect_state *state = &session->effect[name];
    for (int i = 1; !state->on && i < DOM_EFFECT_ARGUMENTS && e->argument[i].name; i++)
        state->value[i] = e->argument[i].usual;
    state->on = true;
    state->value[0] = value;
    if (name == DOM_EFFECT_row)
        session->listed = (struct listed_row){.domino = NULL};
    effects_apply(session);
}

bool effect_turn_off(struct session *session, enum dom_effect_name name)
{
    for (int k = 0; k < DOM_EFFECT_COUNT; k++)
        if (session->effect[k].on && domq_effect((enum dom_effect_name)k)->needs >> name & 1)
            return session_error(session, "%s is about the %s: 'effect %s off' first",
                                 domq_effect((enum dom_effect_name)k)->name, domq_effect(name)->name,
                                 domq_effect((enum dom_effect_name)k)->name);
    if (name == DOM_EFFECT_row)
        listed_free(&session->listed);
    session->effect[name] = (struct effect_state){.on = false};
    effects_apply(session);
    return true;
}

bool effects_savable(struct session *session)
{
    char shown[NAMES_SHOWN];
    const char *path = session->listed.domino ? session->listed.path : "";
    for (const char *c = path; *c; c++)
        if ((unsigned char)*c < ' ' || *c == 0x7f)
            return session_error(
                session,
                "cannot save: the name of the row's file, '%s', has a control character; rename "
                "the file, or first 'effect row off'",
                names_shown(path, shown));
    return true;
}

/* As read_file takes it back. */
static void save_name(const char *path, FILE *out)
{
    fputs(" \"", out);
    for (const char *c = path; *c; c++)
        fputs(*c == '"' ? "\"\"" : (char[]){*c, '\0'}, out);
    putc('"', out);
}

void effects_save_off(const struct session *session, FILE *out)
{
    /* Those that need another one first. */
    for (int needs = 1; needs >= 0; needs--)
        for (int k = 0; k < DOM_EFFECT_COUNT; k++) {
            const struct domq_effect *e = domq_effect((enum dom_effect_name)k);
            if (!session->effect[k].on && (e->needs != 0) == (needs != 0))
                fprintf(out, "effect %s off\n", e->name);
        }
}

void effects_save(const struct session *session, FILE *out)
{
    for (int k = 0; k < DOM_EFFECT_COUNT; k++) {
        const struct domq_effect *e = domq_effect((enum dom_effect_name)k);
        if (!session->effect[k].on)
            continue;
        fprintf(out, "effect %s", e->name);
        if (k == DOM_EFFECT_row && session->listed.domino)
            save_name(session->listed.path, out);
        for (int i = 0; i < DOM_EFFECT_ARGUMENTS && e->argument[i].name; i++) {
            char number[WIDE_TEXT];
            if (k != DOM_EFFECT_row || !session->listed.domino)
                fprintf(out, " %s", quad_exact(session->effect[k].value[i], number));
        }
        putc('\n', out);
    }
    for (size_t i = 0; i < session->listed.changes; i++) {
        char number[WIDE_TEXT];
        fprintf(out, "place %zu %s\n", session->listed.placed[i].k,
                quad_exact(session->listed.placed[i].gap, number));
    }
}

/* ---- The row ---- */

bool scene_weighed(const struct session *session)
{
    return session_mass(session) > 0 || (session->listed.domino && session->listed.weighed);
}

/* Masses of which only the ratios are known become such that m g h / 2 of the first is 1, or what is set. */
static void row_weigh(const struct session *session, struct domq_domino *domino, size_t count)
{
    domq_real mass = session_block_mass(session, domino[0].height, domino[0].thickness);
    domq_real first = mass > 0 ? mass : 2 / (session->scale.g * domino[0].height),
              by = first / domino[0].mass;
    for (size_t k = 0; k < count; k++)
        domino[k].mass *= by;
}

bool scene_row_make(struct session *session, struct scene_row *scene)
{
    const struct listed_row *listed = &session->listed;
    const struct effect_state *effect = session->effect;
    if (!effect[DOM_EFFECT_row].on) {
        session_error(session, "there is no row here: 'effect row N', or 'effect row FILE' with a csv file");
        return false;
    }
    size_t count = listed->domino ? listed->count : (size_t)effect[DOM_EFFECT_row].value[0];
    scene->domino = malloc(count * sizeof *scene->domino);
    if (!scene->domino) {
        session_status(session, DOM_NO_MEMORY);
        return false;
    }
    if (listed->domino)
        memcpy(scene->domino, listed->domino, count * sizeof *scene->domino);
    else
        domq_row_of_train(&session->train, &session->scale, 1, scene->domino, count);
    for (size_t i = 0; i < listed->changes; i++)
        scene->domino[listed->placed[i].k - 1].gap = listed->placed[i].gap;
    if (!listed->domino || !listed->weighed)
        row_weigh(session, scene->domino, count);
    scene->row = (struct domq_row){
        .domino = scene->domino,
        .count = count,
        .g = session->scale.g,
        .push = effect[DOM_EFFECT_push].on ? effect[DOM_EFFECT_push].value[0] : DOMQ_NAN,
        .mu = session->train.mu,
        .floor = effect[DOM_EFFECT_floor].on,
    };
    scene->compute = session->compute;
    return true;
}

bool scene_row_place(struct session *session, size_t k, domq_real gap)
{
    struct scene_row scene;
    struct listed_row *listed = &session->listed;
    if (!scene_row_make(session, &scene))
        return false;
    size_t count = scene.row.count, i = 0;
    free(scene.domino);
    if (k < 2 || k > count)
        return session_error(session, "domino %zu has no gap before it; in this row 2 .. %zu have", k, count);
    while (i < listed->changes && listed->placed[i].k != k)
        i++;
    struct placed *more =
        i < listed->changes ? listed->placed : realloc(listed->placed, (i + 1) * sizeof *listed->placed);
    if (!more)
        return session_status(session, DOM_NO_MEMORY);
    listed->placed = more;
    listed->placed[i] = (struct placed){k, gap};
    listed->changes += i == listed->changes;
    return true;
}
