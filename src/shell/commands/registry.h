/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The one list of all commands; each group is the table of one file of this folder. */
#ifndef SHELL_REGISTRY_H
#define SHELL_REGISTRY_H

#include "interpreter/command.h"

/* In the order of 'help'; ends with a NULL title. */
extern const struct command_group all_commands[];

#endif
