/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The registry of features and of all their commands. */
#include "interpreter/feature.h"
#include "session/row.h"
#include <string.h>

enum { GROUPS_MOST = 48, COMMANDS_MOST = 128 };
static struct command_group groups[GROUPS_MOST + 1];
static const struct command *every[COMMANDS_MOST]; /* the commands of all groups */
static char letters[COMMANDS_MOST];                /* the first letter of each command */
static int every_count;

static const struct feature *const no_feature[] = {NULL};
static const struct feature *const *features = no_feature;

static bool feature_has(const char *name)
{
    for (int k = 0; features[k]; k++)
        if (strcmp(features[k]->name, name) == 0)
            return true;
    return false;
}

void features_register(const struct feature *const *list)
{
    const struct parameter *p;
    size_t count = 0;
    features = list;
    every_count = 0;
    parameters_of_features(feature_has);
    for (const struct feature *const *f = features; *f; f++) {
        for (int k = 0; (*f)->parameter && (p = (*f)->parameter(k)) != NULL; k++)
            parameters_add(p, feature_has);
        if ((*f)->engine)
            row_engine = (*f)->engine;
        for (const struct command_group *g = (*f)->groups; g && g->title && count < GROUPS_MOST; g++) {
            size_t at = count; /* after the last group with the same word */
            for (size_t k = count; k > 0 && at == count; k--)
                at = strcmp(groups[k - 1].word, g->word) == 0 ? k : at;
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

const struct command_group *command_groups(void)
{
    return groups;
}

bool group_named(const char *word)
{
    bool found = strcmp(word, "all") == 0;
    for (const struct command_group *g = groups; g->title; g++)
        found = found || strcmp(g->word, word) == 0;
    return found;
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
