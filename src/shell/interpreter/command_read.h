/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Finds the command of a line. The line either begins with the name of a command or is a shorthand, such as
 * 2+2, r = 2, q or ?rmax. */
#ifndef SHELL_COMMAND_READ_H
#define SHELL_COMMAND_READ_H

#include "interpreter/reader.h"

/*
 * Returns the command of a line, and moves the reader to the beginning of the command's arguments. If there
 * is no such command, sets the reader's problem and returns NULL. If a command and a parameter share a name,
 * the command wins. A parameter wins over an abbreviated command, so that 'q' is the parameter and not
 * 'quit'.
 */
const struct command *command_read(struct reader *reader);

/* Finds the command of a question inside another command, such as 'sweep'. An expression stands for 'print';
 * no other shorthands are accepted. Completion offers the commands in the list `offered`. */
const struct command *command_read_inner(struct reader *reader, names_list *offered);

/* Returns true if there is an operator or 'to' at c. The word before c then begins an expression. */
bool goes_on(const char *c);

/* Parses the head of a definition, "x =" or "f(s, d) =", into *variable. Returns the position after the '=',
 * or NULL if there is no such head. */
const char *definition_head(const char *text, struct variable *variable);

#endif
