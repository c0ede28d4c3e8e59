/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Finds the command of a line. Most lines begin with the name of a command. The others are shorthands, such
 * as 2+2 for 'print', r = 2 for 'set', q alone for 'show', or ?rmax for 'help'. */
#ifndef SHELL_COMMAND_READ_H
#define SHELL_COMMAND_READ_H

#include "interpreter/reader.h"

/*
 * Returns the command of a line and moves the reader to its arguments. If a command and a parameter have the
 * same name, the name stands for the command. If the name of a parameter is also an abbreviation of a
 * command, the name stands for the parameter, so 'q' does not mean 'quit'. After an error, sets the reader's
 * problem and returns NULL.
 */
const struct command *command_read(struct reader *reader);

/* Finds the command that another command runs, such as 'verdict' in 'assert verdict'. If the text is an
 * expression, as in 'assert rmax < 2', returns 'print'. Other shorthands are not allowed. Completion offers
 * the names in the list `offered`. */
const struct command *command_read_inner(struct reader *reader, names_list *offered);

/* Decides whether the word before c is the beginning of an expression rather than a command. Returns true if
 * there is an operator or 'to' at c. */
bool goes_on(const char *c);

/* Parses the beginning of a definition, up to the '=', as in "x =" or "f(s, d) =". Returns the position after
 * the '='. If the text does not begin in this way, returns NULL. */
const char *definition_head(const char *text, struct variable *variable);

/* Returns true if a variable or function can have this name. Otherwise reports what the name means. */
bool name_free(struct problem *problem, const char *name);

#endif
