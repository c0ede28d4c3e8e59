/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The shell's own commands. */
#include "interpreter/feature.h"

extern const struct command session_commands[], script_commands[], help_commands[];

static const struct command_group groups[] = {
    {"The session", "settings", session_commands},
    {"Scripts and records", "scripts", script_commands},
    {"Help", "scripts", help_commands},
    {NULL, NULL, NULL},
};

const struct feature shell_feature = {.name = "shell", .groups = groups};
