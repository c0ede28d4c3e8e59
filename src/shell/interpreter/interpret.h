/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs the commands of lines and of streams of lines. */
#ifndef SHELL_INTERPRET_H
#define SHELL_INTERPRET_H

#include "session/session.h"

/*
 * Runs the commands of a text of one or more lines. ';' separates commands, and '#' begins a comment; the
 * answer of a command with '> FILE' replaces the file, and with '>> FILE' is appended to it.
 */
void command_run_text(struct session *session, const char *text);

/* Runs a stream line by line. Messages call it `name`. */
void line_stream(struct session *session, FILE *in, const char *name);

/*
 * Writes the path of one of a person's files: $variable/domino/name if the variable has an absolute path, as
 * XDG demands, else $HOME/fallback/domino/name. Returns false if neither variable is set or the path is long.
 */
bool line_path(const char *variable, const char *fallback, const char *name, char *path, size_t size);

#endif
