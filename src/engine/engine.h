/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs a row of boxes in the rigid-body engine Chipmunk. */
#ifndef ENGINE_H
#define ENGINE_H

#include "session/engine_api.h"

/* Loads the engine, unless it is already loaded. Returns ENGINE_OK, ENGINE_NO_LIBRARY or ENGINE_NO_MEMORY. */
enum engine_status engine_load(void);

/* Returns the version of the engine, or NULL if it cannot be loaded. */
const char *engine_version(void);

/*
 * Runs a row once. `hit` is an array of row->count elements and receives a record of each box that is hit. If
 * `hit` is NULL, all times are measured from the start of the run. `visit`, which may be NULL, is called
 * after each step and returns false to end the run.
 *
 * If `hit` and `visit` are both NULL, only the verdict is wanted. The run then ends as soon as it is certain
 * that all boxes fall, and fall->seconds is roughly the time at which the run ended.
 */
enum engine_status engine_run(const struct engine_row *row, const struct engine_grain *grain,
                              const volatile sig_atomic_t *interrupt, struct engine_hit *hit,
                              engine_visit *visit, void *context, struct engine_fall *fall);

/* The resolution of engine_settle's first run if times are requested. It is enough for a rough answer. */
extern const struct engine_grain engine_coarsest;

/*
 * Runs a row repeatedly and halves the step length until the verdict no longer changes. `hit` is an array as
 * in engine_run, and may be NULL if `times` is false.
 * - If `times` is true, halving goes on until no time changes by more than ENGINE_AGREES times the duration.
 * - If `times` is false, a coarse first run is not repeated if its verdict is certain.
 * - No run takes more than ENGINE_FINEST steps per unit of time.
 */
enum engine_status engine_settle(const struct engine_row *row, bool times,
                                 const volatile sig_atomic_t *interrupt, struct engine_hit *hit,
                                 struct engine_settled *settled);

#endif
