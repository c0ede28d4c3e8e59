/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The row of the scene, run once: what each domino had when it was hit, and how the row ends. */
#ifndef SHELL_ROW_RUN_H
#define SHELL_ROW_RUN_H

#include "interpreter/command.h"

struct row_run {
    struct scene_row scene;
    struct domq_fall *fall; /* of domino 1, 2, ... up to the last that was hit */
    size_t hits;
    bool timeless; /* a domino comes so close to a stop that later times have no value */
    struct domq_verdict verdict;
};

/* Makes the row of the scene and runs it; timed: with the times of the hits. False: an error was reported,
 * and nothing is to be freed. */
bool row_run(const struct query *query, struct problem *problem, bool timed, struct row_run *run);
void row_run_free(struct row_run *run);

/* Returns true if domino k, from 0, is the first one and is tipped over its edge, without a push. */
bool row_run_tipped(const struct row_run *run, size_t k);

#endif
