/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Whether the dominoes of a row stand by themselves before the first one is pushed. */
#ifndef SHELL_STANDS_H
#define SHELL_STANDS_H

#include "session/scene.h"

/* Returns true if a domino with sharp edges stands on the slope alpha with its lean. Otherwise writes a
 * message that says how far it can lean. */
enum { LEAN_MESSAGE = 400 };
bool lean_stands(const struct domq_domino *domino, domq_real alpha, char message[LEAN_MESSAGE]);

/* Returns true if all dominoes of a row stand on its slope. Otherwise describes the first one that does not.
 */
bool row_stands(const struct scene *scene, const struct domq_row *row, struct problem *problem);

#endif
