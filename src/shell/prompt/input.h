/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Commands from a person at a terminal: the prompt, its history, and completion. */
#ifndef SHELL_INPUT_H
#define SHELL_INPUT_H

#include "session/session.h"

/* Reads lines with Readline until quit or ^D.  Only for terminals. */
void line_prompt(struct session *session);

/*
 * Emits every candidate for the last word of a line: commands, then what the argument of the command can be,
 * units after a number, and files where they belong.  What the parser does not take in this session is left
 * out.
 */
void complete_line(struct session *session, const char *line, bool files,
                   void (*emit)(const char *candidate, void *context), void *context);

/* Completes a word, as Readline's completion function, which takes no context: the session is set before. */
extern struct session *complete_session;
char **complete_word(const char *text, int start, int end);

/*
 * Reads the lines of earlier sessions: from DOMINO_HISTORY, where an empty one means none, or from
 * $XDG_STATE_HOME/domino/history.  Only a regular file is read and written; a device, such as /dev/null,
 * means none, and anything else is reported.
 */
void history_load(struct session *session);

/*
 * Adds a line, also at the end of the file, at once: however the session ends, the file has it.  Blank lines,
 * and the line before again, are left out.  The first failure is reported.
 */
void history_keep(struct session *session, const char *text);

#endif
