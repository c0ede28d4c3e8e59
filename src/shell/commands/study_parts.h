/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A study of placement: what it is about, its answer, and the same in parts. */
#ifndef SHELL_STUDY_PARTS_H
#define SHELL_STUDY_PARTS_H

#include "interpreter/command.h"
#include "session/effects.h"

/*
 * The answer of 'placement' from what was counted: stops[k] of the rows ended at domino k + 1, of `count`.
 * reason, unless NULL, says what is missing.
 */
void study_answer(const struct call *call, domq_real sigma, domq_real heights, const struct domq_study *study,
                  const size_t *stops, size_t count, const char *reason);
extern const struct column placement_columns[];

/*
 * The session's part of a study, as counts of fixed blocks of its rows: whoever computes them, the blocks are
 * the same, and those of all parts are all.
 */
bool study_blocks(struct session *session, const struct call *call, const struct scene_row *scene,
                  const struct domq_placement *placement);

/* The command pool, which adds up the blocks of such parts. */
bool pool_run(struct session *session, const struct call *call);

#endif
