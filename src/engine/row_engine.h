/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ENGINE_ROW_ENGINE_H
#define ENGINE_ROW_ENGINE_H

#include "session/engine.h"

/* Chipmunk, as the shell asks it. */
extern const struct engine_driver chipmunk_driver;

#endif
