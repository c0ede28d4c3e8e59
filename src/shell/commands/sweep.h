/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How the arguments of the command sweep are read: a grid, and behind ':' the command that each point asks.
 */
#ifndef SHELL_SWEEP_H
#define SHELL_SWEEP_H

#include "interpreter/arguments.h"

struct sweep;

/* What is wrong is an error of the session.  The command's own arguments are read at each point. */
bool sweep_read_grid(struct reader *reader, struct call *call);
bool sweep_read_command(struct reader *reader, struct call *call);
void sweep_free(struct sweep *sweep);

#endif
