/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "interpreter/feature.h"

extern const struct command row_commands[];

static const struct command_group groups[] = {
    {"A row of dominoes", "rows", row_commands},
    {NULL, NULL, NULL},
};

const struct feature rows_feature = {.name = "rows", .groups = groups};
