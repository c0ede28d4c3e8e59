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
    const struct method *methods;                /* for 'cost'; the last name is NULL */
    const struct parameter *(*parameter)(int k); /* its effects, from k = 0; NULL after the last one */
};

/* The features of this build, each after those that it needs. The last one is NULL (features.c). */
extern const struct feature *const every_feature[];

/* Registers a list of features and all their commands. Must be called before the first command runs. */
void features_register(const struct feature *const *list);

/* Returns feature number k, counted from 0, or NULL if there are no more. */
const struct feature *feature_at(int k);

#endif
