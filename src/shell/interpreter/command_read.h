/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Finds the command of a line. A line begins with a command, or is a shorthand such as 2+2, r = 2, q or
 * ?rmax. */
#ifndef SHELL_COMMAND_READ_H
#define SHELL_COMMAND_READ_H

#include "interpreter/reader.h"

/*
 * Returns the command of a line, and moves the reader to its arguments. After an error, sets the reader's
 * problem and returns NULL. Commands win over parameters with the same name, and parameters over abbreviated
 * commands: 'q' is not 'quit'.
 */
const struct command *command_read(struct reader *reader);

/* Finds the command inside another command, such as 'sweep'. An expression stands for 'print'; no other
 * shorthand is allowed here. Completion offers the names in `offered`. */
const struct command *command_read_inner(struct reader *reader, names_list *offered);

/* Returns true if there is an operator or 'to' at c. The word before c then begins an expression. */
bool goes_on(const char *c);

/* Parses the head of a definition, "x =" or "f(s, d) =". Returns the position after the '=', or NULL if there
 * is no head. */
const char *definition_head(const char *text, struct variable *variable);

#endif
