/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Runs the commands in a text or in a stream. First, command_read (command_read.h) finds a command in the
 * tables. question_parse (question.h) then parses its arguments and resolves the names in them, and
 * question_bind computes the arguments. If the answer goes to a file or through the pager, an output is
 * pushed onto the stack of outputs (io/output.h). The command's function writes the answer (answer/answer.h)
 * or describes a problem (session/problem.h). Finally, the output is popped. If there was a problem, the file
 * is not kept.
 */
#ifndef SHELL_INTERPRET_H
#define SHELL_INTERPRET_H

#include "session/session.h"

/*
 * Runs the commands in a text, which may have several lines. ';' separates commands, and '#' begins a
 * comment. After a command, '> FILE' writes the answer to a file and replaces its contents; '>> FILE' appends
 * the answer to the file.
 */
void command_run_text(struct session *session, const char *text);

/* Runs the commands of a stream line by line. Messages call the stream `name`. */
void line_stream(struct session *session, FILE *in, const char *name);

#endif
