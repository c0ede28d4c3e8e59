/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "interpreter/feature.h"
#include "pictures/plots/plots.h"

extern const struct command draw_commands[], film_commands[], plot_commands[];

static const struct command_group groups[] = {
    {"The train in pictures", "pictures", draw_commands},
    {"Films", "pictures", film_commands},
    {"Curves", "pictures", plot_commands},
    {NULL, NULL, NULL},
};

extern const struct plot limit_plots[], cycle_plots[];

static const struct plot *const plots[] = {limit_plots, cycle_plots, NULL};

const struct feature pictures_feature = {.name = "pictures", .groups = groups, .plots = plots};
