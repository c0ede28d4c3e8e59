/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The tables of the shell's own commands. */
#ifndef SHELL_TABLES_H
#define SHELL_TABLES_H

#include "interpreter/command.h"

extern const struct command session_commands[], value_commands[], script_commands[], help_commands[];

#endif
