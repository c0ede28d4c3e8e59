/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The errors of random rows: converts the effects of a scene to the form that the library takes. */
#ifndef SHELL_RANDOM_ERRORS_H
#define SHELL_RANDOM_ERRORS_H

#include "session/scene.h"

/* A names_list (see names.h) of the kinds of errors, with "all" as its last name. */
const char *error_names(const void *context, int k);

/* Returns the unit of a kind of error, or "" for DOM_ERROR_COUNT, which stands for a factor that scales all
 * errors. */
const char *error_unit(int kind);

/* Returns the effect to which a kind of error belongs, which is 'placement' for gaps and heights. */
int error_effect(int kind);

/* Writes the errors of a scene to `error`. An error that is off has the size 0. Returns true if any effect
 * with errors is on. */
bool scene_errors(const struct scene *scene, struct domq_error error[DOM_ERROR_COUNT]);

/* Returns true if the errors can be combined with the other effects of the scene. Otherwise reports the
 * problem. */
bool errors_check(const struct scene *scene, struct problem *problem);

/* Turns all errors off in a copy of a scene. The copy must borrow its row from the original. */
void errors_off(struct scene *scene);

/* Describes the errors of an array of DOM_ERROR_COUNT elements in words, with their exact sizes, for example
 * "gap 0.003 m, friction 0.05 uniform". */
enum { ERRORS_TEXT = 1024 };
const char *errors_text(const struct domq_error *error, char text[ERRORS_TEXT]);

#endif
