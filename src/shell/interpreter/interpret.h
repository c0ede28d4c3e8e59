/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Runs the commands in a text or in a stream. Each command takes these steps: command_read (command_read.h)
 * finds it in the tables, question_parse (question.h) parses its arguments and resolves the names in them,
 * '> FILE' or the pager becomes the top of the stack of outputs (io/output.h), question_bind computes the
 * arguments, the command's function writes its answer (answer/answer.h) or describes a problem
 * (session/problem.h), and the output is taken off the stack, which keeps or drops the file.
 */
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
