/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The history of a session's states, for 'undo' and 'redo'. */
#ifndef SHELL_UNDO_H
#define SHELL_UNDO_H

#include "session/scene.h"
#include <stddef.h>

struct undo;

/* Returns a copy of the state. Call this function before a command, and pass the copy to undo_keep after the
 * command. Returns NULL if memory runs out; the command then cannot be undone. */
struct state *undo_begin(const struct state *state);

/* If a command has changed the state, adds a step to the history. Takes ownership of `before`, the copy that
 * undo_begin made before the command. `text` is the command, and `length` its length. *undo is NULL if there
 * is no history yet. */
void undo_keep(struct undo **undo, const struct state *state, struct state *before, const char *text,
               size_t length);

/* Undoes the last command if `back` is true, and otherwise redoes the command that was undone last. Returns
 * the text of this command, or NULL if there is nothing to undo or redo. */
const char *undo_step(struct undo *undo, struct state *state, bool back);

void undo_free(struct undo *undo);

#endif
