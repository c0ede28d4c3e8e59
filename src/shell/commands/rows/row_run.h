/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One run of the row of the scene, by the model or by the rigid-body engine. */
#ifndef SHELL_ROW_RUN_H
#define SHELL_ROW_RUN_H

#include "interpreter/command.h"

/* The engine keeps a pointer to its report in here: do not copy this struct. */
struct row_run {
    struct scene_row scene; /* with the engine's report, if the engine runs the row */
    struct domq_verdict verdict;
    struct domq_fall *fall; /* for domino 1, 2, ... up to the last that was hit, after row_run */
    size_t hits;
    bool timeless; /* a domino comes so close to a stop that later times have no value */
};

/* Makes the row of the scene, with room for the engine's report. Returns false with a problem, and then there
 * is nothing to free. */
bool row_run_begin(const struct query *query, struct problem *problem, struct row_run *run);
void row_run_free(struct row_run *run);

/* Makes the row of the scene for a picture, runs it and keeps every hit; with `timed`, hits have times.
 * Returns false with a problem, and then there is nothing to free. */
bool row_run(const struct query *query, struct problem *problem, bool timed, struct row_run *run);

/* Returns true if domino k, counted from 0, is the first one and is tipped over its edge, without a push. */
bool row_run_tipped(const struct row_run *run, size_t k);

#endif
