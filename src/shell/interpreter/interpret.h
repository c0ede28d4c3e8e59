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

#endif
