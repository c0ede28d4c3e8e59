/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Computes points in parallel, for features whose answers have many. */
#include "interpreter/feature.h"

const struct feature parallel_feature = {.name = "parallel"};
