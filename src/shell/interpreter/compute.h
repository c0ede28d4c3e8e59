/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Computes the answer of a command, and its errors. */
#ifndef SHELL_COMPUTE_H
#define SHELL_COMPUTE_H

#include "interpreter/command.h"

/* Runs a command. If errors are on, runs it a second time in quad precision, to find the errors of its
 * numbers (answer/reference.h). */
bool command_compute(const struct command *command, const struct query *query, struct answer *answer,
                     struct problem *problem);

#endif
