/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Completion. The parser reports what may follow at the cursor, and also decides whether a candidate is
 * valid. */
#include "interpreter/question.h"
#include "io/escape.h"
#include "prompt/input.h"
#include "session/session.h"
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include <readline/readline.h>

struct completion {
    struct session *session;
    const char *line;
    const char *word; /* the last word of the line, which is being completed; may be empty */
    /* The name at the end of `word`. In an expression, `word` may have operators before the name. */
    const char *name;
    struct offer offer; /* what the parser would accept at `name` */
    void (*emit)(const char *candidate, void *context);
    void *context;
};

static bool accepted(const struct completion *c, const char *word)
{
    return line_preview(c->session, c->line, (size_t)(c->word - c->line), word, NULL);
}

/* Emits a candidate for the last word. After "2*rm", for example, the name "rmax" gives the candidate
 * "2*rmax". `more` is appended to the name. Emits nothing if `name` does not begin with the typed letters. If
 * `is_checked` is true, the parser must also accept the candidate, alone or at the beginning of a list. */
static void emit_name(const struct completion *c, const char *name, const char *more, bool is_checked)
{
    char whole[128], list[sizeof whole + 1];
    snprintf(whole, sizeof whole, "%.*s%s%s", (int)(c->name - c->word), c->word, name, more);
    snprintf(list, sizeof list, "%s,", whole);
    if (strncmp(name, c->name, strlen(c->name)) == 0 && !escape_needed(whole) &&
        (!is_checked || accepted(c, whole) || accepted(c, list)))
        c->emit(whole, c->context);
}

/* ---- Values ---- */

/* Emits the names that have a value: parameters, commands whose answer is a number, variables, functions and
 * landmarks. If the value is a whole argument, and not a part of an expression, its first letter must have
 * been typed, and the parser checks each name by computing its value. For a command about the row this can
 * take a long time, so such a command is offered only in expressions. */
static void emit_values(const struct completion *c)
{
    const struct argument *a = &c->offer.value;
    const struct variables *variables = &c->session->state.variables;
    const bool is_any = c->offer.is_inside || (a->kind == ARGUMENT_ANY && !a->noun),
               has_row = c->session->state.scene.effect[DOM_EFFECT_row].on;
    const char *name;
    int fewest;
    const bool has_names = is_any ? *c->name != '\0' : a->kind == ARGUMENT_HEIGHT;
    for (int i = 0; has_names && (name = feature_names(NULL, i)) != NULL; i++)
        emit_name(c, name, "", !is_any);
    if (!is_any && !*c->name)
        return;
    for (const struct parameter *p = session_parameters; p->name; p++)
        if (parameter_is_number(p) && p != c->offer.parameter)
            emit_name(c, p->name, "", !is_any);
    const struct command *command;
    for (int i = 0; (command = command_at(i)) != NULL; i++) {
        name = command->name;
        if (c->offer.is_inside && *c->name && command_is_table(command) && (command->train || has_row)) {
            command_values(command, &fewest);
            emit_name(c, name, fewest ? "(" : "", false);
        }
        const bool has_value = command_arity(command, &fewest) >= 0;
        if (has_value && (is_any ? command->train || fewest || has_row : command->train && !fewest))
            emit_name(c, name, fewest ? "(" : "", !is_any);
    }
    emit_name(c, "ans", "", !is_any);
    if (aggregates && is_any && *c->name)
        emit_name(c, aggregates->name, "(", false);
    for (const struct variable *v = variables->list; v && v < variables->list + variables->count; v++)
        emit_name(c, v->name, v->body ? "(" : "", !is_any);
    for (int i = 0; (name = expression_names(NULL, i)) != NULL; i++)
        emit_name(c, name, strcmp(name, "pi") == 0 ? "" : "(", !is_any);
}

/* Emits the units that may follow a number. */
static void emit_units(const struct completion *c)
{
    const char *unit;
    for (int k = 0; (unit = expression_units(NULL, k)) != NULL; k++)
        emit_name(c, unit, "", true);
}

/* ---- Keys and files ---- */

/* Emits the keys of the command whose name comes before the dot, as in 'rmax.' or 'rmax(0.3).'. */
static void emit_keys(const struct completion *c, const char *dot)
{
    const char *end = dot, *key;
    char name[32];
    int fewest;
    if (end > c->word && end[-1] == ')')
        while (end > c->word && *end != '(')
            end--;
    const char *begin = end;
    while (begin > c->word && (isalnum((unsigned char)begin[-1]) || begin[-1] == '_'))
        begin--;
    snprintf(name, sizeof name, "%.*s", (int)(end - begin), begin);
    const struct command *command = command_find(name);
    if (command && (command_arity(command, &fewest) >= 0 || command_is_table(command)))
        for (int k = 0; (key = command_keys(command, k)) != NULL; k++)
            emit_name(c, key, "", false);
}

static void emit_files(const struct completion *c)
{
    char *file;
    for (int state = 0; (file = rl_filename_completion_function(c->word, state)) != NULL; state = 1) {
        /* Makes Readline add a '/' after a directory, and put quotes around a name that contains blanks. */
        rl_filename_completion_desired = 1;
        if (!escape_needed(file))
            c->emit(file, c->context);
        free(file);
    }
}

/* ---- All candidates ---- */

/* Returns the beginning of the last word, which follows a blank, a ';' or an unclosed '"'. */
static const char *last_word(const char *line)
{
    const char *word = line + strlen(line), *quote = strchr(line, '"');
    while (word > line && !strchr(" \t;", word[-1]))
        word--;
    for (const char *behind; quote && (behind = text_quote(quote)) != NULL;)
        quote = strchr(behind, '"');
    return quote ? quote + 1 : word;
}

/* Returns the beginning of the name or number at the end of the word. */
static const char *last_name(const char *word)
{
    const char *end = word + strlen(word), *name = end, *number;
    while (name > word && (isalnum((unsigned char)name[-1]) || name[-1] == '_'))
        name--;
    for (number = name; number > word && (isdigit((unsigned char)number[-1]) || number[-1] == '.');)
        number--;
    return isdigit((unsigned char)*number) ? number : name;
}

void complete_line(struct session *session, const char *line, bool files, void (*emit)(const char *, void *),
                   void *context)
{
    struct completion c = {
        .session = session, .line = line, .word = last_word(line), .emit = emit, .context = context};
    struct offer *o = &c.offer, at_word = {.lists = 0};
    c.name = last_name(c.word);
    line_preview(session, line, (size_t)(c.word - line), PREVIEW_CURSOR, &at_word);
    line_preview(session, line, (size_t)(c.name - line), PREVIEW_CURSOR, o);
    char *unit = NULL; /* the end of the number in a name such as "5c", behind which a unit may be typed */
    if (isdigit((unsigned char)*c.name))
        strtod(c.name, &unit);
    if (files && at_word.kinds & OFFER_FILE)
        emit_files(&c);
    else if (c.name > c.word && c.name[-1] == '.')
        emit_keys(&c, c.name - 1);
    for (int i = 0; i < o->lists; i++) {
        const char *candidate;
        for (int k = 0; (candidate = o->names[i](o->context[i], k)) != NULL; k++)
            emit_name(&c, candidate, "", true);
    }
    if (o->kinds & OFFER_VARIABLE)
        for (size_t i = 0; i < session->state.variables.count; i++)
            emit_name(&c, session->state.variables.list[i].name, "", false);
    if (o->value.kind != ARGUMENT_NONE && unit) {
        c.name = unit;
        emit_units(&c);
    } else if (o->value.kind != ARGUMENT_NONE &&
               (o->is_inside || o->lists == 0 || o->value.kind == ARGUMENT_PLACE ||
                (o->command && o->command->typed.variant)))
        emit_values(&c);
    if (o->kinds & OFFER_UNIT && !unit)
        emit_units(&c);
}
