/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The history of a session's states, for 'undo' and 'redo'. */
#ifndef SHELL_UNDO_H
#define SHELL_UNDO_H

#include "session/scene.h"
#include <stddef.h>

struct undo;

/* Returns a copy of the state before a command, for undo_keep. Returns NULL if memory runs out; the command
 * then cannot be undone. */
struct state *undo_begin(const struct state *state);

/* Adds a step if the command `text`, of `length` bytes, has changed the state. Takes ownership of `before`,
 * which undo_begin returned. *undo is NULL at first. */
void undo_keep(struct undo **undo, const struct state *state, struct state *before, const char *text,
               size_t length);

/* Undoes the last command or, if `back` is false, redoes the command that was undone last. Returns the text
 * of the command, or NULL if there is none. */
const char *undo_step(struct undo *undo, struct state *state, bool back);

void undo_free(struct undo *undo);

#endif
