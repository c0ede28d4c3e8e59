/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "interpreter/feature.h"
#include "fit/fit.h"
#include "pictures/plots/plots.h"

extern const struct plot fit_plots[];

static const struct plot *const plots[] = {fit_plots, NULL};

static const struct feature_picture picture[] = {{"fit", picture_fit}, {NULL, NULL}};

const struct feature fit_pictures_feature = {.name = "fit_pictures", .plots = plots, .picture = picture};
