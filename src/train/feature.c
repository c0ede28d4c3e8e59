/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "interpreter/feature.h"
#include "train/train.h"

static const struct command_group groups[] = {
    {"One cycle of the train", "cycles", cycle_commands},
    {"The cycle, step by step", "cycles", walk_commands},
    {"How far it can grow", "limits", limit_commands},
    {"What accuracy costs", "limits", cost_commands},
    {"Effects beyond the paper", "settings", effect_commands},
    {NULL, NULL, NULL},
};

const struct feature train_feature = {.name = "train", .groups = groups};
