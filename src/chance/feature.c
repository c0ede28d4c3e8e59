/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "interpreter/feature.h"
#include "chance/chance.h"

extern const struct command study_commands[];

static const struct command_group groups[] = {
    {"Rows with random errors", "chances", study_commands},
    {NULL, NULL, NULL},
};

const struct feature chance_feature = {.name = "chance", .groups = groups, .parameter = error_parameter};
