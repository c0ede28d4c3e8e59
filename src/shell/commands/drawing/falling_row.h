/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The row of the scene on a stage: as it is set up, and at any time while it falls; and what is said of it.
 */
#ifndef SHELL_FALLING_ROW_H
#define SHELL_FALLING_ROW_H

#include "commands/rows/row_run.h"
#include "picture/stage.h"

/* Lengths in m, times in s on the clock of struct domq_fall. */
struct falling_row {
    struct row_run run;
    struct stage stage;
    double *slid;      /* how far each foot has slid at the moment that is watched */
    double end;        /* when the motion ends; NaN: a time has no value */
    struct marks mark; /* how captions name the marked dominoes */
};

/* Makes the row, runs it, and sets it up on its stage. False: an error was reported, and nothing is to be
 * freed. */
bool falling_row_make(const struct query *query, struct problem *problem, struct marks mark,
                      struct falling_row *row);
void falling_row_free(struct falling_row *row);

/* Returns when a domino is hit; of the first one of a row that starts without a push, the time from which on
 * it is seen to move, which is below 0. NaN: it is never hit, or the time has no value. */
double falling_row_hit(const struct falling_row *row, size_t k);

/* Calls visit for the row at each of these times, which do not decrease. */
enum dom_status falling_row_watch(const struct falling_row *row, const domq_real *times, size_t count,
                                  domq_moment_visit *visit, void *context);

/* Shows the row at a moment; NULL: as it is set up. */
void falling_row_pose(struct falling_row *row, const struct domq_moment *moment);

/* Lets the stage reach as far as the last dominoes stand, or lie. */
void falling_row_reach(struct falling_row *row, bool lying);

enum { SENTENCE = 256 };

/* Writes how many dominoes there are, and how tall: "7 dominoes, 4.8 cm to 54.7 cm tall". */
void falling_row_summary(const struct falling_row *row, char text[SENTENCE]);

/* Writes how the row ends, in one sentence. */
void falling_row_verdict(const struct falling_row *row, char text[SENTENCE]);

/* Writes which domino is the weakest, and how much energy it has, or "". */
void falling_row_weakest(const struct falling_row *row, char text[SENTENCE]);

/* Writes what happens at a moment: "2.500 s after the push: domino 3 falls, 7 still stand." */
void falling_row_moment(const struct falling_row *row, const struct domq_moment *moment, char text[SENTENCE]);

#endif
