/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Finds the command that a line means. The line begins with a command's name, or is a shorthand: 2+2, r = 2,
 * q, ?rmax. */
#ifndef SHELL_COMMAND_READ_H
#define SHELL_COMMAND_READ_H

#include "interpreter/reader.h"

/*
 * Returns the command that a line means, and moves the reader to where its arguments begin. Returns NULL with
 * a problem if there is none. A name that a command and a parameter share is the command's; an abbreviated
 * command comes after a parameter, so that 'q' is the parameter, and not 'quit'.
 */
const struct command *command_read(struct reader *reader);

/* Returns the command of a question inside another command, such as 'sweep': an expression means 'print', and
 * there are no other shorthands. `offered` lists the commands that completion offers. */
const struct command *command_read_inner(struct reader *reader, names_list *offered);

/* Returns true if an operator or 'to' at c continues an expression that the word before it begins. */
bool goes_on(const char *c);

/* Reads the head of a definition, "x =" or "f(s, d) =". Returns the place after '=', or NULL if there is no
 * such head. */
const char *definition_head(const char *text, struct variable *variable);

#endif
