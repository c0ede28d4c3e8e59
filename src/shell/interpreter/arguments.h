/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A command's arguments, from the text of a line: words, names, expressions in the session's own names. */
#ifndef SHELL_ARGUMENTS_H
#define SHELL_ARGUMENTS_H

#include "interpreter/words.h"

/* Reads the i-th value of a parameter: one of its words, or an expression. name: the source for messages. */
bool read_value(struct reader *reader, const struct parameter *parameter, int i, const char *name,
                domq_real *number);

/* Reads one of the argument's names; a word that is none of them is an error with all names. */
bool read_choice(struct reader *reader, const struct argument *argument, char **word, domq_real *number);

/* Reads an expression for an argument. */
bool read_quantity(struct reader *reader, const struct argument *argument, struct quantity *quantity,
                   domq_real *number);

/* Reads all arguments of a command, up to its end or a '>'.  Reports what is wrong and returns false. */
bool read_arguments(struct reader *reader, const struct command *command, struct arguments *given);

/* Reads the name of a command.  Returns NULL after an error, which was reported. */
const struct command *read_command(struct reader *reader);

/* Frees the memory of arguments. */
void arguments_free(struct arguments *given);

#endif
