/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The history of a session's states, for 'undo' and 'redo'. */
#ifndef SHELL_UNDO_H
#define SHELL_UNDO_H

#include "session/scene.h"
#include <stddef.h>

struct undo;

/* Must be called before a command. Returns a copy of the state, for undo_keep. If memory runs out, returns
 * NULL, and the command cannot be undone. */
struct state *undo_begin(const struct state *state);

/* Must be called after a command. If the command has changed the state, adds a step to the history. The
 * command is the first `length` bytes of `text`. `before` is what undo_begin returned before the command, and
 * undo_keep takes ownership of it. *undo must be NULL before the first call. */
void undo_keep(struct undo **undo, const struct state *state, struct state *before, const char *text,
               size_t length);

/* If `back` is true, undoes the last command. Otherwise redoes the command that was undone last. Returns the
 * text of the command, or NULL if there is no such command. */
const char *undo_step(struct undo *undo, struct state *state, bool back);

void undo_free(struct undo *undo);

#endif
