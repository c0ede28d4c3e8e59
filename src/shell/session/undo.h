/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The earlier states of a session: parameters, effects, the row, and what 'let' defined. */
#ifndef SHELL_UNDO_H
#define SHELL_UNDO_H

#include "language/names.h"
#include "session/session.h"

/* Returns the state of a session before a command, for undo_keep; NULL: no memory, and no step is kept. */
struct state *undo_begin(struct session *session);

/* Keeps the state as a step if the command, whose text is given, changed it since; else frees it. */
void undo_keep(struct session *session, struct state *before, const char *text, size_t length);

/* Goes one step back, or forward again.  Returns the text of its command, or NULL: there is no step. */
const char *undo_step(struct session *session, bool back, char text[NAMES_SHOWN]);

#endif
