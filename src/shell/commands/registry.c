/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "commands/tables.h"

const struct command_group all_commands[] = {
    {"One cycle of the train", "cycles", cycle_commands},
    {"The cycle, step by step", "cycles", walk_commands},
    {"How far it can grow", "limits", limit_commands},
    {"Answers with a proof", "limits", prove_commands},
    {"Where a number comes from", "limits", explain_commands},
    {"The train in pictures", "pictures", draw_commands},
    {"Curves", "pictures", plot_commands},
    {"Any answer over a grid", "sweeps", sweep_commands},
    {"What accuracy costs", "sweeps", cost_commands},
    {"A row of dominoes", "rows", row_commands},
    {"Planning a row", "planning", design_commands},
    {"Rows with random errors", "chances", study_commands},
    {"Effects beyond the paper", "settings", effect_commands},
    {"The session", "settings", session_commands},
    {"Scripts and records", "scripts", script_commands},
    {"Help", "scripts", help_commands},
    {NULL, NULL, NULL},
};
