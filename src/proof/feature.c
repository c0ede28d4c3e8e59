/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "interpreter/feature.h"
#include "proof/proof.h"

static const struct command_group groups[] = {
    {"Answers with a proof", "limits", prove_commands},
    {NULL, NULL, NULL},
};

static const struct feature_extension extension[] = {{.command = "cost", .add = cost_proved},
                                                     {.command = NULL}};

const struct feature proof_feature = {.name = "proof", .groups = groups, .extension = extension};
