/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "domino_methods.h"
#include "interpreter/command.h"
#include "train/train.h"

extern const struct command explain_commands[];

static const struct command_group groups[] = {
    {"Where a number comes from", "limits", explain_commands},
    {NULL, NULL, NULL},
};

static const struct method paper = {"paper", dom_paper_barrier, dom_paper_rmax};

const struct feature explain_feature = {.name = "explain", .groups = groups, .method = &paper};
