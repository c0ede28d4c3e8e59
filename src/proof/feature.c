/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "interpreter/feature.h"

extern const struct command prove_commands[];

static const struct command_group groups[] = {
    {"Answers with a proof", "limits", prove_commands},
    {NULL, NULL, NULL},
};

const struct feature proof_feature = {.name = "proof", .groups = groups};
