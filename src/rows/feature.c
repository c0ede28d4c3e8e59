/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "interpreter/feature.h"
#include "rows/rows.h"

extern const struct command row_commands[];

static const struct command_group groups[] = {
    {"A row of dominoes", "rows", row_commands},
    {NULL, NULL, NULL},
};

/* The effect 'row', which may come from a file, and whose dominoes may have been changed. */
static const struct parameter *parameter(int k)
{
    static const struct parameter row = {.name = "row",
                                         .value = domq_effect_row.argument,
                                         .effect = &domq_effect_row,
                                         .which = DOM_EFFECT_row,
                                         .words = effect_words,
                                         .example = "set row 13; fall; set row off",
                                         .load = rowfile_load,
                                         .save = row_changes_save};
    return k == 0 ? &row : NULL;
}

const struct feature rows_feature = {.name = "rows", .groups = groups, .parameter = parameter};
