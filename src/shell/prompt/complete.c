/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "interpreter/forms.h"
#include "interpreter/question.h"
#include "io/escape.h"
#include "prompt/input.h"
#include "prompt/typed.h"
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include <readline/readline.h>

#define NAME_LETTERS "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_"
#define UNIT_LETTERS "abcdefghijklmnopqrstuvwxyz"

/* The candidates at the cursor: lists of names, the values of an argument, files. */
struct offer {
    names_list *list[2];
    const void *context[2];
    int lists;
    struct argument value; /* the argument that takes an expression; else of kind ARGUMENT_NONE */
    bool files;
    bool variables; /* those of the session */
};

static void offer_list(struct offer *offer, names_list *list, const void *context)
{
    if (!list) /* any words: nothing to offer */
        return;
    offer->list[offer->lists] = list;
    offer->context[offer->lists++] = context;
}

/* Returns the candidates for an argument; p: the parameter that it gives a value to, or NULL. */
static struct offer offer_for(const struct argument *a, const struct parameter *p)
{
    struct offer offer = {.files = a->kind == ARGUMENT_FILE || (p && p->value->or_file)};
    offer.variables =
        a->kind == ARGUMENT_TOPIC || (a->kind == ARGUMENT_PARAMETER && a[1].kind != ARGUMENT_VALUE);
    if (a->choices)
        offer_list(&offer, a->choices, NULL);
    else if (p && p->words)
        offer_list(&offer, parameter_offered, p);
    else if (a->kind != ARGUMENT_FILE && a->kind != ARGUMENT_REST)
        offer.value = *a;
    if (a->kind == ARGUMENT_PLACE || a->kind == ARGUMENT_GRID || (p && p->words && !p->words_only))
        offer.value = *a;
    return offer;
}

/* Returns true if an argument may follow this word, the argument before it. */
static bool may_follow(const struct argument *a, const char *word)
{
    char message[NAMES_MESSAGE];
    const struct argument *before = a - 1;
    if (!a->follows)
        return true;
    int k = names_find(before->choices, NULL, before->of, word, message);
    return k < 0 ? before->kind == ARGUMENT_PLACE && a->follows(0)
                 : a->follows(before->kind == ARGUMENT_PLACE ? -1 - k : k);
}

/* Returns the argument that reads all words from its own on, if word i of the command is one of them; or
 * NULL.
 */
static const struct argument *words_argument(const struct command *c, int i)
{
    for (int k = 0; k <= i && k < ARGUMENTS_MAX; k++)
        if (c->argument[k].kind == ARGUMENT_WORDS)
            return &c->argument[k];
    return NULL;
}

/* Lists for names.h the commands that can be swept. */
static const char *swept_names(const void *context, int k)
{
    const char *name;
    for (int i = 0; (name = command_names(context, i)) != NULL; i++)
        if (command_find(name)->columns && !command_find(name)->unswept && k-- == 0)
            return name;
    return NULL;
}

/* Returns the list of the commands that may come after the ':' of this one. */
static names_list *names_after_colon(const struct command *sweep)
{
    const struct argument *a = sweep->argument;
    while (a->kind && a->kind != ARGUMENT_COMMAND)
        a++;
    return a->kind && a->choices ? a->choices : swept_names;
}

/* Returns the candidates for the n-th word after a choice that decides them. */
static struct offer offer_behind(const struct command *c, const char *choice, int n)
{
    char message[NAMES_MESSAGE];
    struct argument a = c->argument[1];
    int k = names_find(c->argument[0].choices, NULL, c->argument[0].of, choice, message);
    a.choices = k < 0 ? NULL : a.offers(k, n);
    return a.choices ? offer_for(&a, NULL) : (struct offer){.lists = 0};
}

/* Returns the candidates for the last word. */
static struct offer offer_at(const struct typed *t)
{
    const struct command *c = t->command;
    int k = typed_argument(t);
    const struct argument *own = c && k >= 0 ? words_argument(c, k) : NULL;
    struct offer offer = {.files = t->file};
    if (t->file)
        return offer;
    if (own && own->choices == value_names) { /* a definition */
        offer.variables = !strchr(t->begin, '=');
        offer.value = (struct argument){.kind = offer.variables ? ARGUMENT_NONE : ARGUMENT_ANY};
    } else if (own)
        offer_list(&offer, own->choices, t->before);
    else if (!c && t->last[strspn(t->last, NAME_LETTERS)]) /* a line may be an expression */
        offer.value = (struct argument){.kind = ARGUMENT_ANY};
    else if (k < 0) {
        offer_list(&offer, t->sweep ? names_after_colon(t->sweep) : command_names, NULL);
        offer.variables = !t->sweep;
    } else if (c && k > 0 && c->argument[1].offers)
        offer = offer_behind(c, t->choice, k);
    else if (c && c->argument[0].kind == ARGUMENT_GRID)
        offer = offer_for(&c->argument[0], NULL); /* as long as it may be */
    else if (c && k < ARGUMENTS_MAX && c->argument[k].kind == ARGUMENT_VALUE && t->parameter) {
        const struct parameter *p = t->parameter;
        if (parameter_value(p, k - 1)) /* only few effects have a second value */
            offer = offer_for(&(struct argument){.kind = ARGUMENT_OF, .of = p->name, .which = k - 1}, p);
    } else if (c && k < ARGUMENTS_MAX && (k == 0 || may_follow(&c->argument[k], t->before)))
        offer = offer_for(&c->argument[k], NULL);
    return offer;
}

/* Returns the command before the dot at the end of text, as in 'rmax.' or 'rmax(0.3).'; NULL if there is
 * none. */
static const struct command *command_before_dot(const char *text, const char *dot)
{
    const char *end = dot;
    if (end > text && end[-1] == ')')
        while (end > text && *end != '(')
            end--;
    const char *begin = end;
    while (begin > text && (isalnum((unsigned char)begin[-1]) || begin[-1] == '_'))
        begin--;
    char name[32];
    snprintf(name, sizeof name, "%.*s", (int)(end - begin), begin);
    const struct command *c = command_find(name);
    int fewest;
    return c && command_values(c, &fewest) >= 0 ? c : NULL;
}

/* ---- Values ---- */

/* Where candidates go. */
struct completion {
    struct session *session;
    const struct typed *typed;
    const char *name; /* what is completed: the last word, or a name at the end of its expression */
    bool alone;       /* the name is all of the argument */
    bool listed;      /* a ',' may have to follow */
    void (*emit)(const char *candidate, void *context);
    void *context;
};

/*
 * Returns true if the parser takes the line with this last word: as a whole, or up to its end, where only
 * something after it is missing.
 */
static bool accepted(const struct completion *c, const char *word)
{
    struct means means = c->session->means;
    struct problem problem = {.kind = PROBLEM_NONE};
    struct text text;
    struct arena arena;
    char *line = NULL;
    int length = asprintf(&line, "%.*s%s", (int)(c->typed->last - c->typed->line), c->typed->line, word);
    if (length < 0 || !text_make(&text, line, (size_t)length)) {
        free(length < 0 ? NULL : line);
        return false;
    }
    struct query query = session_query(c->session);
    query.means = &means;
    means.note = NULL;
    arena_begin(&arena);
    struct reader r = {.query = &query,
                       .problem = &problem,
                       .text = &text,
                       .at = text.line,
                       .arena = &arena,
                       .evaluates = true};
    struct question question = {.key = -1, .command = read_command(&r)};
    bool good = question.command && (question_parse(&r, &question) ||
                                     problem.column >= text_column(&text, text.line + strlen(text.line)));
    arena_free(&arena);
    text_free(&text);
    free(line);
    return good;
}

/* Emits the last word with this name at its end. checked: the parser is asked whether it takes the word. */
static void emit_name(const struct completion *c, const char *name, const char *more, bool checked)
{
    char whole[128], list[sizeof whole + 1];
    snprintf(whole, sizeof whole, "%.*s%s%s", (int)(c->name - c->typed->last), c->typed->last, name, more);
    snprintf(list, sizeof list, "%s,", whole);
    if (strncmp(name, c->name, strlen(c->name)) == 0 && !escape_needed(whole) && /* it is written as it is */
        (!checked || accepted(c, whole) || (c->listed && accepted(c, list))))
        c->emit(whole, c->context);
}

/* Returns the unit of the values of an argument. */
static struct quantity argument_unit(const struct argument *a)
{
    const struct parameter *p = a->kind == ARGUMENT_OF ? parameter_find(a->of) : NULL;
    bool length = a->kind == ARGUMENT_HEIGHT || a->kind == ARGUMENT_LENGTH;
    bool tilt = a->kind == ARGUMENT_TILT || a->kind == ARGUMENT_PLACE;
    return p ? expression_unit(p->value[a->which].unit) : expression_unit(length ? "m" : tilt ? "rad" : "");
}

/*
 * Returns true if a name with this unit may be the value of the argument by itself.  Of the numbers without a
 * unit only those of the argument's parameter may: what is called r or r_max, for r.
 */
static bool of_kind(const struct argument *a, const char *name, const char *unit)
{
    struct quantity own = argument_unit(a);
    size_t length = a->of ? strlen(a->of) : 0;
    if (a->kind == ARGUMENT_COUNT || a->kind == ARGUMENT_GRID)
        return false;
    if (!quantity_bare(own))
        return quantity_alike(expression_unit(unit), own);
    return length > 0 && strncmp(name, a->of, length) == 0 && (name[length] == '\0' || name[length] == '_');
}

/* Emits the variables whose value the argument may be, and functions; without an argument the names of all.
 */
static void emit_variables(const struct completion *c, const struct argument *a, bool any)
{
    const struct variables *all = &c->session->state.variables;
    for (size_t i = 0; i < all->count; i++) {
        const struct variable *v = &all->list[i];
        bool fits = !a || any ||
                    (a->kind != ARGUMENT_GRID && (v->body || quantity_alike(v->value, argument_unit(a))));
        if (fits)
            emit_name(c, v->name, a && v->body ? "(" : "", a && !any);
    }
}

enum { LONE = 64 };

/* The number of candidates, and the last one. */
struct lone {
    int count;
    char *name;
};

static void lone_keep(const char *candidate, void *context)
{
    struct lone *lone = context;
    lone->count++;
    snprintf(lone->name, LONE, "%s", candidate);
}

/* Emits what has a value: parameters, answers, functions. */
static void values_list(const struct completion *c, const struct argument *a)
{
    bool any = !c->alone || (a->kind == ARGUMENT_ANY && !a->of);
    bool row = c->session->state.scene.effect[DOM_EFFECT_row].on;
    const char *name;
    int fewest;
    for (const struct parameter *p = session_parameters; p->name; p++)
        if (parameter_is_number(p) && p != c->typed->parameter &&
            (any || of_kind(a, p->name, p->value->unit)))
            emit_name(c, p->name, "", !any);
    for (int i = 0; (name = command_names(NULL, i)) != NULL; i++) {
        const struct command *command = command_find(name);
        if (command_values(command, &fewest) < 0 || (!command->train && !fewest && !row))
            continue;
        const struct column *column = &command->columns[command_principal(command)];
        /* Answers about the endless train come at once: the parser asks for them. */
        if (any || (!fewest && command->train && of_kind(a, column->key, column->unit)))
            emit_name(c, name, fewest ? "(" : "", !any);
    }
    emit_name(c, "ans", "", !any);
    emit_variables(c, a, any);
    for (int i = 0;
         (any || (*c->name && a->kind != ARGUMENT_COUNT)) && (name = expression_names(NULL, i)) != NULL; i++)
        emit_name(c, name, strcmp(name, "pi") == 0 ? "" : "(", !any);
}

/* Emits values; where nothing is typed, not a single answer, which the key would write unasked: best for s.
 */
static void emit_values(const struct completion *c, const struct argument *a)
{
    char only[LONE] = "";
    struct lone lone = {.count = 0, .name = only};
    struct completion counted = *c;
    counted.emit = lone_keep;
    counted.context = &lone;
    if (!*c->name && c->alone)
        values_list(&counted, a);
    if (lone.count != 1 || !command_find(only))
        values_list(c, a);
}

/* Returns the argument before the last word, if that is a number that may have a unit; or NULL. */
static const struct argument *argument_of_number(const struct typed *t, struct argument *value)
{
    int k = t->words - 2;
    const struct argument *a =
        t->command && t->number && !t->file && k >= 0 && k < ARGUMENTS_MAX ? &t->command->argument[k] : NULL;
    if (!a || a->kind == ARGUMENT_GRID || a->kind == ARGUMENT_COMMAND)
        return NULL;
    if (a->kind != ARGUMENT_VALUE)
        return a;
    *value = (struct argument){.kind = ARGUMENT_OF, .which = k - 1};
    value->of = t->parameter && parameter_value(t->parameter, k - 1) ? t->parameter->name : NULL;
    return value->of ? value : NULL;
}

/* Emits the units that a number may have: in the last word "48m", or the number in the word before. */
static void emit_units(struct completion c)
{
    const char *unit;
    for (int k = 0; (unit = expression_units(NULL, k)) != NULL; k++)
        emit_name(&c, unit, "", true);
}

/* ---- All candidates ---- */

/* Returns true if a grid has a value here, and not a name. */
static bool takes_value(const struct completion *c)
{
    return parameter_find(c->typed->before) || accepted(c, "0.5") || accepted(c, "2");
}

/* Returns the place after the number that the word begins with, where a unit may be; NULL without one. */
static const char *after_number(const char *word)
{
    char *end = NULL;
    if (isdigit((unsigned char)*word) || *word == '.')
        strtod(word, &end);
    return end && end > word && end[strspn(end, UNIT_LETTERS)] == '\0' ? end : NULL;
}

static void emit_files(const struct completion *c)
{
    char *file;
    for (int state = 0; (file = rl_filename_completion_function(c->typed->last, state)) != NULL; state = 1) {
        rl_filename_completion_desired = 1; /* a '/' after folders, '"' around blanks */
        if (!escape_needed(file))           /* it is written on the terminal */
            c->emit(file, c->context);
        free(file);
    }
}

void complete_line(struct session *session, const char *line, bool files, void (*emit)(const char *, void *),
                   void *context)
{
    struct typed t;
    struct argument of;
    typed_read(line, &t);
    struct offer offer = offer_at(&t);
    struct completion c = {.session = session, .typed = &t, .name = t.last, .emit = emit, .context = context};
    const char *unit = after_number(t.last);
    bool value = offer.value.kind != ARGUMENT_NONE;
    bool words = offer.value.kind == ARGUMENT_OF && offer.lists > 0; /* these are what people look for */
    /* In a grid names and values take turns: only the parser knows which is next. */
    if (value && offer.value.kind == ARGUMENT_GRID && typed_argument(&t) > 0 && takes_value(&c)) {
        const struct parameter *p = parameter_find(t.before);
        offer.lists = 0;
        if (p && p->words)
            offer_list(&offer, parameter_offered, p);
    }
    /* In an expression the name begins after the operator. */
    for (const char *at = t.last; *at && value; at++)
        if (!isalnum((unsigned char)*at) && *at != '_')
            c.name = at + 1;
    c.alone = c.name == t.last && !t.joins;
    if (value && c.name > t.last && c.name[-1] == '.' && !unit) {
        const struct command *before = command_before_dot(t.last, c.name - 1);
        for (int k = 0; before && command_keys(before, k); k++)
            emit_name(&c, command_keys(before, k), "", false);
        return;
    }
    c.listed = offer.value.kind == ARGUMENT_GRID;
    for (int l = 0; l < offer.lists; l++) {
        const char *candidate;
        for (int k = 0; (candidate = offer.list[l](offer.context[l], k)) != NULL; k++)
            emit_name(&c, candidate, "", typed_argument(&t) >= 0);
    }
    if (offer.variables && c.name == t.last)
        emit_variables(&c, NULL, true);
    if (value && unit) {
        c.name = unit;
        emit_units(c);
    } else if (value && (!words || !c.alone))
        emit_values(&c, &offer.value);
    if (!unit && c.name == t.last && argument_of_number(&t, &of))
        emit_units(c);
    if (offer.files && files)
        emit_files(&c);
}
