/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Help as rows, where the output is csv or json. */
#ifndef SHELL_HELP_ROWS_H
#define SHELL_HELP_ROWS_H

#include "interpreter/command.h"

/* Gives the answer the columns of the rows below. */
void help_rows_begin(struct answer *answer);

/* Write what the tables say of a command; of a parameter or an effect. */
void help_row_command(struct answer *answer, const struct command *command);
void help_row_variable(struct answer *answer, const struct variable *variable);
void help_row_parameter(struct answer *answer, const struct parameter *parameter);

#endif
