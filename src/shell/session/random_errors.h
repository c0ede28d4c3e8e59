/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Converts the effects that describe random errors to the form that the library takes. */
#ifndef SHELL_RANDOM_ERRORS_H
#define SHELL_RANDOM_ERRORS_H

#include "session/scene.h"

/* A names_list (see names.h) of the kinds of random error, with "all" as its last name. */
const char *error_names(const void *context, int k);

/* Returns the unit of a kind of random error. The kind DOM_ERROR_COUNT stands for "all". Its value is a
 * factor, so its unit is "". */
const char *error_unit(int kind);

/* Returns the effect that describes a kind of random error. Gaps and heights share 'placement'. */
int error_effect(int kind);

/* Fills the array `error` with the random errors of a scene. If a kind of error is off, its size is 0.
 * Returns true if any of the effects for random errors is on. */
bool scene_errors(const struct scene *scene, struct domq_random_error error[DOM_ERROR_COUNT]);

/* Returns true if the random errors can be combined with the other effects. Otherwise reports the problem. */
bool errors_check(const struct scene *scene, struct problem *problem);

void errors_off(struct scene *scene);

/* Describes the DOM_ERROR_COUNT elements of `error`, as in "gap 0.003 m, friction 0.05 uniform". */
enum { ERRORS_TEXT = 1024 };
const char *errors_text(const struct domq_random_error *error, char text[ERRORS_TEXT]);

#endif
