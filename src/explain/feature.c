/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "interpreter/feature.h"
#include "domino_methods.h"
#include "train/train.h"

extern const struct command explain_commands[];

static const struct command_group groups[] = {
    {"Where a number comes from", "limits", explain_commands},
    {NULL, NULL, NULL},
};

static const struct method methods[] = {
    {"paper", 0.1, dom_paper_barrier, dom_paper_duration, dom_paper_rmax},
    {"GSL", 0.05, dom_gsl_barrier, dom_gsl_duration, dom_gsl_rmax},
    {.name = NULL},
};

const struct feature explain_feature = {.name = "explain", .groups = groups, .methods = methods};
