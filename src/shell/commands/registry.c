/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "commands/tables.h"

/* The comments name the file in which each table of commands stands. */
const struct command_group all_commands[] = {
    {"One cycle of the train", cycle_commands},      /* cycle.c */
    {"The cycle, step by step", walk_commands},      /* step.c */
    {"How far it can grow", limit_commands},         /* limit.c */
    {"Answers with a proof", prove_commands},        /* prove.c */
    {"Where a number comes from", explain_commands}, /* explain/explain.c */
    {"The train in pictures", draw_commands},        /* drawing/draw.c */
    {"Curves", plot_commands},                       /* plots/plot.c */
    {"Any answer over a grid", sweep_commands},      /* sweeps/sweep_table.c */
    {"Effects beyond the paper", effect_commands},   /* effect.c */
    {"A row of dominoes", row_commands},             /* rows/row.c */
    {"Planning a row", design_commands},             /* planning/planning_table.c */
    {"Rows with random errors", study_commands},     /* rows/study.c */
    {"What accuracy costs", cost_commands},          /* cost.c */
    {"The session", session_commands},               /* settings.c */
    {"Scripts and records", script_commands},        /* script.c */
    {"Help", help_commands},                         /* help.c */
    {NULL, NULL},
};
