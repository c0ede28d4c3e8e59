/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The tables of commands, each in the file with its name; registry.c lists them. */
#ifndef SHELL_TABLES_H
#define SHELL_TABLES_H

#include "interpreter/command.h"

extern const struct command cycle_commands[], walk_commands[], limit_commands[], cost_commands[],
    session_commands[], help_commands[], draw_commands[], plot_commands[], effect_commands[], row_commands[],
    study_commands[], sweep_commands[];

/* Gives the parameter or effect that the call names its values: 'set' and 'effect'. */
bool run_set(struct session *session, const struct call *call);

#endif
