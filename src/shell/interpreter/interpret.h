/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs the commands in a text or in a stream. */
#ifndef SHELL_INTERPRET_H
#define SHELL_INTERPRET_H

#include "session/session.h"

/*
 * Runs the commands of a text of one or more lines. ';' separates commands, and '#' begins a comment. After a
 * command, '> FILE' writes the answer to a file and replaces its contents; '>> FILE' appends the answer to
 * the file.
 */
void command_run_text(struct session *session, const char *text);

/* Runs the commands of a stream line by line. Messages call the stream `name`. */
void line_stream(struct session *session, FILE *in, const char *name);

/*
 * Writes the path of one of the user's files: $variable/domino/name if the environment variable holds an
 * absolute path, as the XDG specification demands, and $HOME/fallback/domino/name otherwise. Returns false if
 * neither variable is set, or if the path does not fit into `size` bytes.
 */
bool line_path(const char *variable, const char *fallback, const char *name, char *path, size_t size);

#endif
