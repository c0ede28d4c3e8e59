/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "commands/tables.h"

const struct command_group all_commands[] = {
    {"One cycle of the train", cycle_commands},
    {"The cycle, step by step", walk_commands},
    {"How far it can grow", limit_commands},
    {"Answers with a proof", prove_commands},
    {"Where a number comes from", explain_commands},
    {"The train in pictures", draw_commands},
    {"Curves", plot_commands},
    {"Any answer over a grid", sweep_commands},
    {"Effects beyond the paper", effect_commands},
    {"A row of dominoes", row_commands},
    {"Planning a row", design_commands},
    {"Rows with random errors", study_commands},
    {"What accuracy costs", cost_commands},
    {"The session", session_commands},
    {"Scripts and records", script_commands},
    {"Help", help_commands},
    {NULL, NULL},
};
