/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "interpreter/feature.h"

extern const struct command explain_commands[];

static const struct command_group groups[] = {
    {"Where a number comes from", "limits", explain_commands},
    {NULL, NULL, NULL},
};

const struct feature explain_feature = {.name = "explain", .groups = groups};
