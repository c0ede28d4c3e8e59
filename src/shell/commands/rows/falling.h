/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The row of the scene: one run of it, by the model or by the rigid-body engine, and words about it. */
#ifndef SHELL_FALLING_H
#define SHELL_FALLING_H

#include "interpreter/command.h"

/* ---- A run of the row ---- */

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

/* ---- Words and numbers ---- */

/* Returns a cell with so many digits in a table; no bound of its error is known. */
struct cell cell_narrow(domq_real value, int digits);

/* Rounds a positive number to so many significant digits, up or down. Returns any other number as it is. */
domq_real round_digits(domq_real value, int digits, bool up);

struct words {
    char text[CELL_TEXT + 40];
};

/* Returns "96 % of the energy that it needs", or "12 times the energy that it needs". */
struct words energy_words(domq_real share);

/* Returns "All 8 fall", "Both fall" or "It falls". */
struct words all_fall_words(size_t count);

/* Returns the energy of a domino that is hit, as a share of the energy that it needs to go on. Returns NaN if
 * it needs none, or if no energy is enough. */
domq_real fall_share(const struct domq_fall *fall);

/* Says which domino has the least energy to spare, if one is known. */
void weakest_say(struct answer *answer, const struct domq_verdict *verdict);

/* Describes why there is no answer about the row of the scene: any status but DOM_OK. Returns false. */
bool row_status(const struct query *query, struct problem *problem, enum dom_status status);

#endif
