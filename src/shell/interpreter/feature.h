/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A feature is a part of the program that a build can leave out: a folder of src/ with a feature.mk, which
 * names the features that it needs, and one record. The shell knows features only by this record. */
#ifndef SHELL_FEATURE_H
#define SHELL_FEATURE_H

#include "interpreter/command.h"

struct engine_driver;
struct method;
struct plot;

struct feature {
    const char *name;                            /* its folder; a_b for a folder b in a folder a */
    const struct command_group *groups;          /* its commands; the last title is NULL */
    const struct plot *const *plots;             /* tables of charts for 'plot'; the last one is NULL */
    const struct engine_driver *engine;          /* a rigid-body engine */
    const struct method *method;                 /* what 'cost' compares with */
    const struct parameter *(*parameter)(int k); /* its effects, from k = 0; NULL after the last one */
    /* Names that have values in expressions, unless 'let' defines the same name. The function returns the
     * longest of them with which a text begins, its end in the text and its value, or NULL. The command with
     * the name of the feature explains them. */
    names_list *names;
    const char *(*value)(const char *text, const char **end, struct quantity *value);
};

/* The features of this build, each after those that it needs. The last one is NULL (features.c). */
extern const struct feature *const every_feature[];

/* Registers a list of features and all their commands. Must be called before the first command runs. */
void features_register(const struct feature *const *list);

/* Returns the feature that gives a value to the name at the beginning of the text, or NULL. Stores the name,
 * its end in the text, and the value. */
const struct feature *feature_value(const char *text, const char **name, const char **end,
                                    struct quantity *value);

/* A names_list (see names.h) of the names that features give to values. */
const char *feature_names(const void *context, int k);

/* Returns feature number k, counted from 0, or NULL if there are no more. */
const struct feature *feature_at(int k);

#endif
