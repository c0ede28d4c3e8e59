/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Lines that begin with no command, and mean one: 2+2, q, r = 2, x = 3, ?rmax, rmax?. */
#ifndef SHELL_FORMS_H
#define SHELL_FORMS_H

#include "interpreter/words.h"

/*
 * Returns the command that a line without a command's name means, and moves the reader to where its
 * arguments begin; NULL: the line has no such form.  A command's name comes first: 'fuel' is the command, and
 * 'q' the parameter, since the command is 'quit'.
 */
const struct command *read_form(struct reader *reader);

/* Returns true if an operator that needs a value before it, or a conversion, is here, behind a word. */
bool goes_on(const char *c);

/* Reads the name of a command; `offered` lists those that completion offers. Returns NULL after an error,
 * which was described. */
const struct command *read_command(struct reader *reader, names_list *offered);

/* Reads what a command begins with, a name or another form, and parses its arguments. */
struct question;
bool command_parse(struct reader *reader, struct question *question);

/* Reads the head of a definition, "x =" or "f(s, d) =".  Returns the place after '=', or NULL: none is there.
 */
const char *definition_head(const char *text, struct variable *variable);

#endif
