/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The prompt at a terminal, with history, completion, colours and hints. */
#ifndef SHELL_INPUT_H
#define SHELL_INPUT_H

#include "session/session.h"

/* Reads and runs lines from the terminal, until the session ends. */
void line_prompt(struct session *session);

/*
 * Calls `emit` with each candidate for the last word of a line. Candidates are names, values, units and, if
 * `files` is true, also paths. Each candidate is a whole word that the parser accepts in this session.
 */
void complete_line(struct session *session, const char *line, bool files,
                   void (*emit)(const char *candidate, void *context), void *context);

/* Readline's completion function. Since Readline's callbacks have no context argument, prompt_session must be
 * set first. */
extern struct session *prompt_session;
char **complete_word(const char *text, int start, int end);

/* Writes the path of one of the user's files. The path is $variable/domino/name if the environment variable
 * holds an absolute path, as the XDG specification demands. Otherwise the path is $HOME/fallback/domino/name.
 * Returns false if neither variable is set, or if the path does not fit into `size` bytes. */
bool line_path(const char *variable, const char *fallback, const char *name, char *path, size_t size);

/*
 * Loads the lines of earlier sessions from the file that DOMINO_HISTORY names, or from
 * $XDG_STATE_HOME/domino/history. An empty DOMINO_HISTORY, or a device such as /dev/null, means that no
 * history is kept.
 */
void history_load(struct session *session);

/* Adds a line to the history, and appends it to the file immediately, so that it is kept even if the session
 * crashes. Blank lines and repetitions of the previous line are not added. The first failure to write is
 * reported, and from then on nothing is written to the file. */
void history_keep(struct session *session, const char *text);

/* Binds the keys that accept a hint. Must be called after rl_initialize. */
void overlay_begin(void);

/* overlay_show draws colours and a hint over the typed line. overlay_remove clears the hint, and must be
 * called before a key is handled. */
void overlay_show(struct session *session);
void overlay_remove(void);

#endif
