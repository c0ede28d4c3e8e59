/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "interpreter/feature.h"
#include "engine/engine.h"

static const struct engine_driver driver = {.load = engine_load,
                                            .version = engine_version,
                                            .coarsest = &engine_coarsest,
                                            .run = engine_run,
                                            .settle = engine_settle};

const struct feature engine_feature = {.name = "engine", .engine = &driver};
