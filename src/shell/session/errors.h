/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The errors of random rows: the effects of a scene, as the library takes them. */
#ifndef SHELL_ERRORS_H
#define SHELL_ERRORS_H

#include "session/scene.h"

/* The names of the kinds of errors, and "all" after them, for names.h. */
const char *error_names(const void *context, int k);

/* The unit of a kind of error; "" for DOM_ERROR_COUNT, which stands for a factor of all errors. */
const char *error_unit(int kind);

/* Returns the effect that has a kind of error: 'placement' for gaps and heights. */
int error_effect(int kind);

/* Writes the errors of a scene. An error that is off has the size 0. Returns true if any effect with errors
 * is on. */
bool scene_errors(const struct scene *scene, struct domq_error error[DOM_ERROR_COUNT]);

/* Returns true unless the errors cannot be combined with other effects of the scene. Otherwise describes the
 * problem. */
bool errors_check(const struct scene *scene, struct problem *problem);

/* Turns all errors off in a copy of a scene that borrows its row. */
void errors_off(struct scene *scene);

/* Writes the errors as words, with sizes that are exact: "gap 0.003 m, friction 0.05 uniform". */
enum { ERRORS_TEXT = 1024 };
const char *errors_text(const struct domq_error error[DOM_ERROR_COUNT], char text[ERRORS_TEXT]);

#endif
