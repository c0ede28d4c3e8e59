/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The prompt at a terminal, with history and completion. */
#pragma once

#include "session/session.h"
#include <signal.h>

/* Reads and runs lines from the terminal, until the session ends or *raised becomes the number of a signal
 * other than SIGINT. SIGINT ends the line that is being typed, or the command that runs. */
void line_prompt(struct session *session, volatile sig_atomic_t *raised);

/* Reads one line from the terminal, with line editing and the history, also while line_prompt runs a command.
 * Returns NULL at the end of the input. If the session is interrupted, returns an empty line. The caller
 * frees the line. */
char *line_edit(struct session *session, const char *prompt);

/* Finds the candidates for the last word of a line and calls `emit` with each of them. A candidate is a whole
 * word. If `files` is true and the word can be the name of a file, the paths of files are also candidates. */
void complete_line(struct session *session, const char *line, bool files,
                   void (*emit)(const char *candidate, void *context), void *context);
