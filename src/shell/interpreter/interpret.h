/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Runs commands in these steps:
 * - command_read (question.h) finds the command in the tables.
 * - question_parse parses the arguments and resolves names.
 * - question_bind computes the arguments.
 * - io/output.h pushes a file onto the stack of outputs.
 * - The command writes its answer (answer/answer.h) or describes a problem (session/problem.h).
 * - The output is popped. After a problem, the file is not kept.
 */
#pragma once

#include "interpreter/question.h"
#include "session/session.h"

/* Runs the commands in a string of one or more lines. ';' separates commands, and '#' begins a comment. After
 * a command, '> NAME' writes the answer to a file, and '>> NAME' appends the answer to a file. */
void command_run_text(struct session *session, const char *text);

/* Runs the commands of a stream line by line. `name` is the name of the stream in error messages. */
void line_stream(struct session *session, FILE *in, const char *name);

/* ---- A line that is being typed, for completion. No command is run. ---- */

/* The character that marks the cursor. No name, value or operator contains this character. */
#define PREVIEW_CURSOR "\001"

/*
 * Parses a line that is not complete yet, and returns true if its last command is right so far. The line
 * consists of `length` bytes of the text `line`, followed by the text `tail`. If `offer` is NULL, also
 * computes and checks the values in the line. If `offer` is not NULL and `tail` ends with PREVIEW_CURSOR,
 * stores in *offer what may be typed at the cursor.
 */
bool line_preview(struct session *session, const char *line, size_t length, const char *tail,
                  struct offer *offer);
