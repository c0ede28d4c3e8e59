/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "interpreter/feature.h"
#include "pictures/plots/plots.h"

extern const struct plot placement_plots[];

static const struct plot *const plots[] = {placement_plots, NULL};

const struct feature chance_pictures_feature = {.name = "chance_pictures", .plots = plots};
