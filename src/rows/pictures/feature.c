/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "interpreter/feature.h"
#include "pictures/plots/plots.h"

extern const struct plot row_plots[];

static const struct plot *const plots[] = {row_plots, NULL};

const struct feature rows_pictures_feature = {.name = "rows_pictures", .plots = plots};
