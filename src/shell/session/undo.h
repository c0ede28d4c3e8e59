/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The history of the states of a session, for 'undo' and 'redo'. */
#ifndef SHELL_UNDO_H
#define SHELL_UNDO_H

#include "session/scene.h"
#include <stddef.h>

struct undo;

/* Returns a copy of a state, to be made before a command and given to undo_keep after it. Returns NULL if
 * there is no memory; the command then cannot be undone. */
struct state *undo_begin(const struct state *state);

/* Adds a step to the history, which begins as NULL, if the command with this text has changed the state.
 * Takes ownership of the state before the command. */
void undo_keep(struct undo **undo, const struct state *state, struct state *before, const char *text,
               size_t length);

/* Goes one step back or forward. Returns the text of the command of that step, or NULL if there is no step.
 */
const char *undo_step(struct undo *undo, struct state *state, bool back);

void undo_free(struct undo *undo);

#endif
