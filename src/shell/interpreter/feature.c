/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The registry of features, of all their commands, and the names that are known in a line. */
#include "interpreter/question.h"
#include "io/terminal.h"
#include "language/text.h"
#include "session/row.h"
#include <string.h>

enum { GROUPS_MOST = 48, COMMANDS_MOST = 128, NAMED_MOST = 64 };
static struct command_group groups[GROUPS_MOST + 1];
static const struct command *every[COMMANDS_MOST]; /* the commands of all groups */
static char letters[COMMANDS_MOST];                /* the first letter of each command */
static int every_count;
static const char *named[NAMED_MOST]; /* the names that features give to values */
static int named_count;

static const struct feature *const no_feature[] = {NULL};
static const struct feature *const *features = no_feature;

const struct aggregates *aggregates;

/* What runs a command. */
static bool (*computes)(const struct command *, const struct query *, struct answer *, struct problem *);

bool command_compute(const struct command *c, const struct query *query, struct answer *answer,
                     struct problem *problem)
{
    return computes(c, query, answer, problem);
}

void features_register(const struct feature *const *list)
{
    size_t count = 0;
    features = list;
    every_count = named_count = 0;
    computes = command_answer;
    parameters_begin();
    for (int needs = 0; needs <= 1; needs++) /* parameters that need an effect come after it */
        for (const struct feature *const *f = features; *f; f++)
            for (const struct parameter *const *p = (*f)->parameters; p && *p; p++)
                if (((*p)->needs != NULL) == needs)
                    parameters_add(*p);
    for (const struct feature *const *f = features; *f; f++) {
        for (int k = 0; (*f)->names && named_count < NAMED_MOST && (*f)->names(NULL, k); k++)
            named[named_count++] = (*f)->names(NULL, k);
        if ((*f)->compute)
            computes = (*f)->compute;
        if ((*f)->progress)
            progress_hook = (*f)->progress;
        if ((*f)->aggregates)
            aggregates = (*f)->aggregates;
        if ((*f)->engine)
            row_engine = (*f)->engine;
        if ((*f)->row_note)
            row_note = (*f)->row_note;
        for (const struct command_group *g = (*f)->groups; g && g->title && count < GROUPS_MOST; g++) {
            size_t at = count; /* after the last group with the same word, or at the end */
            while (at > 0 && strcmp(groups[at - 1].word, g->word) != 0)
                at--;
            at = at > 0 ? at : count;
            memmove(&groups[at + 1], &groups[at], (count++ - at) * sizeof *groups);
            groups[at] = *g;
        }
    }
    groups[count] = (struct command_group){NULL, NULL, NULL};
    for (const struct command_group *g = groups; g->title; g++)
        for (const struct command *c = g->commands; c->name && every_count < COMMANDS_MOST; c++) {
            letters[every_count] = *c->name;
            every[every_count++] = c;
        }
}

const struct feature *feature_at(int k)
{
    return features[k];
}

const struct first_line *first_line_at(int place)
{
    const struct first_line *next = NULL;
    for (const struct feature *const *f = features; *f; f++)
        for (const struct first_line *l = (*f)->first; l && l->place; l++)
            if (l->place >= place && (!next || l->place < next->place))
                next = l;
    return next;
}

bool feature_is_always(const struct feature *feature)
{
    return strcmp(feature->name, "shell") == 0 || strcmp(feature->name, "train") == 0;
}

const char *feature_names(const void *context, int k)
{
    (void)context;
    return k < named_count ? named[k] : NULL;
}

const struct feature *feature_value(const char *text, const char **name, const char **end,
                                    struct quantity *value)
{
    for (const struct feature *const *f = features; *f; f++)
        if ((*f)->value && (*name = (*f)->value(text, end, value)) != NULL)
            return *f;
    return NULL;
}

const struct command_group *command_groups(void)
{
    return groups;
}

int command_count(void)
{
    return every_count;
}

const struct command *command_at(int k)
{
    return k >= 0 && k < every_count ? every[k] : NULL;
}

const char *command_names(const void *context, int k)
{
    (void)context;
    return k < every_count ? every[k]->name : NULL;
}

const char *offered_commands(const void *context, int k)
{
    (void)context;
    for (int i = 0; i < every_count; i++)
        if (!every[i]->typed.phrase && !every[i]->typed.is_hidden && k-- == 0)
            return every[i]->name;
    return NULL;
}

const struct command *command_find(const char *name)
{
    const char *end = letters + every_count;
    for (const char *at = letters; (at = memchr(at, *name, (size_t)(end - at))) != NULL; at++)
        if (strcmp(every[at - letters]->name, name) == 0)
            return every[at - letters];
    return NULL;
}

/* ---- Names ---- */

const char *topic_names(const void *context, int k)
{
    const int commands = command_count();
    if (k < commands)
        return command_names(context, k);
    /* Some names belong to both a command and a parameter, such as 'fuel'. They have been listed already. */
    for (const struct parameter *p = session_parameters; p->name; p++)
        if (!command_find(p->name) && k-- == commands)
            return p->name;
    return NULL;
}

const char *value_names(const void *context, int k)
{
    const struct state *state = context;
    const int variables = state ? (int)state->variables.count : 0, heights = state ? named_count : 0;
    for (int n = 0; expression_names(NULL, n); n++)
        if (k-- == 0)
            return expression_names(NULL, n);
    if (k < heights)
        return named[k];
    k -= heights;
    if (k < variables)
        return state->variables.list[k].name;
    k -= variables;
    if (aggregates && k-- == 0)
        return aggregates->name;
    return k == 0 ? "ans" : topic_names(NULL, k - 1);
}

bool is_value_name(const struct state *state, const char *name)
{
    return names_exact(value_names, state, name) >= 0;
}

const char *answer_keys(const void *command, int k)
{
    const struct column *columns = ((const struct command *)command)->columns;
    return columns ? columns[k].key : NULL;
}

const char *command_keys(const void *command, int k)
{
    const struct command *c = command;
    const char *key = answer_keys(c, k);
    return key && c->sweep.slow_column && strcmp(key, c->sweep.slow_column) == 0 ? NULL : key;
}

int command_principal(const struct command *c)
{
    return names_exact(command_keys, c, c->principal);
}

const char *command_usage_write(const struct command *c, char usage[USAGE_SIZE])
{
    snprintf(usage, USAGE_SIZE, "%s", c->typed.phrase ? c->typed.phrase : c->name);
    bool inside = false; /* a '[' has been written, but not yet its ']' */
    for (const struct argument *a = c->argument, *end = a + ARGUMENTS_MAX; a < end && a->kind; a++) {
        const bool more = a->kind == ARGUMENT_VALUE && a + 1 < end && a[1].kind == ARGUMENT_VALUE;
        text_add(usage, USAGE_SIZE, " %s%s%s", a->optional && !inside ? "[" : "", a->name,
                 a->optional && !more ? "]" : "");
        inside = a->optional && more;
    }
    return usage;
}

/* ---- Commands in expressions ---- */

int command_values(const struct command *c, int *fewest)
{
    int most = 0;
    *fewest = 0;
    for (int i = 0; i < ARGUMENTS_MAX && c->argument[i].kind; i++) {
        const struct argument *a = &c->argument[i];
        /* an argument can be given in an expression if it and all arguments before it are values that need no
         * function of their own */
        bool is_value = a->kind >= ARGUMENT_TILT && a->kind <= ARGUMENT_PLACE && most == i && !a->bind;
        if (!is_value && !a->optional)
            return -1;
        most += is_value;
        *fewest += is_value && !a->optional;
    }
    return most;
}

int command_arity(const struct command *c, int *fewest)
{
    const int most = command_values(c, fewest);
    return c->columns && c->principal ? most : -1;
}

bool command_is_table(const struct command *c)
{
    int fewest;
    return aggregates && c && c->rows && !c->principal && c->columns && c->columns->key && c->run &&
           !c->writes && !c->access.changes && command_values(c, &fewest) >= 0;
}
