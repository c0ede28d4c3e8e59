/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "interpreter/feature.h"
#include "session/engine.h"
#include <string.h>

enum { GROUPS_MOST = 48 };

/* Adds a group after the last one with the same word. */
static void group_add(struct command_group *all, size_t count, const struct command_group *group)
{
    size_t at = count;
    for (size_t k = count; k > 0 && at == count; k--)
        at = strcmp(all[k - 1].word, group->word) == 0 ? k : at;
    memmove(&all[at + 1], &all[at], (count - at) * sizeof *all);
    all[at] = *group;
}

static const struct feature *const none[] = {NULL};
static const struct feature *const *features = none;

static bool feature_has(const char *name)
{
    for (int k = 0; features[k]; k++)
        if (strcmp(features[k]->name, name) == 0)
            return true;
    return false;
}

void features_register(const struct feature *const *list)
{
    features = list;
    parameters_of_features(feature_has);
    static struct command_group all[GROUPS_MOST + 1];
    const struct parameter *p;
    size_t count = 0;
    for (const struct feature *const *f = features; *f; f++) {
        for (int k = 0; (*f)->parameter && (p = (*f)->parameter(k)) != NULL; k++)
            parameters_add(p, feature_has);
        if ((*f)->engine)
            row_engine = (*f)->engine;
        for (const struct command_group *g = (*f)->groups; g && g->title && count < GROUPS_MOST; g++)
            group_add(all, count++, g);
    }
    all[count] = (struct command_group){NULL, NULL, NULL};
    command_registry(all);
}

const struct feature *feature_at(int k)
{
    return features[k];
}

const struct feature_picture *feature_picture(const struct command *command)
{
    for (const struct feature *const *f = features; *f; f++)
        for (const struct feature_picture *p = (*f)->picture; p && p->command; p++)
            if (strcmp(p->command, command->name) == 0)
                return p;
    return NULL;
}
