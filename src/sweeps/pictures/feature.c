/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "interpreter/feature.h"
#include "pictures/plots/plots.h"

extern const struct command watch_commands[];
extern const struct plot sweep_plots[];

static const struct command_group groups[] = {
    {"Exploring with the arrow keys", "sweeps", watch_commands},
    {NULL, NULL, NULL},
};

static const struct plot *const plots[] = {sweep_plots, NULL};

const struct feature sweeps_pictures_feature = {.name = "sweeps_pictures", .groups = groups, .plots = plots};
