/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The row of the scene on a stage, as it is set up and while it falls, and sentences about it. */
#ifndef SHELL_FALLING_ROW_H
#define SHELL_FALLING_ROW_H

#include "commands/rows/falling.h"
#include "picture/stage.h"

/* Lengths are in m, and times in s on the clock of struct domq_fall. */
struct falling_row {
    struct row_run run;
    struct stage stage;
    double *slid;       /* how far each foot has slid at the moment that is shown */
    double end;         /* when the motion ends; NaN where a time has no value */
    struct marks marks; /* how sentences name the dominoes that are marked */
};

/* Runs the row, and sets it up on its stage. Returns false after describing a problem; then nothing is to be
 * freed. */
bool falling_row_make(const struct query *query, struct problem *problem, struct marks marks,
                      struct falling_row *row);
void falling_row_free(struct falling_row *row);

/*
 * Returns when domino k is hit. The first domino of a row without a push is never hit: for it this is the
 * time, before 0, from which it is seen to move. Returns NaN for a domino that is never hit, or whose time
 * has no value.
 */
double falling_row_hit(const struct falling_row *row, size_t k);

/* Calls visit for the row at each of these times, which do not decrease. */
enum dom_status falling_row_watch(const struct falling_row *row, const domq_real *times, size_t count,
                                  domq_moment_visit *visit, void *context);

/* Shows the row at a moment, or as it is set up if moment is NULL. */
void falling_row_pose(struct falling_row *row, const struct domq_moment *moment);

/* Lets the stage end where the last dominoes stand or, if lying, where their tops will lie. */
void falling_row_reach(struct falling_row *row, bool lying);

/* Returns the height of the smallest domino. */
double falling_row_smallest(const struct falling_row *row);

/* ---- Sentences ---- */

enum { SENTENCE = 256 };

/* Writes how many dominoes there are: "7 dominoes, 4.8 cm to 54.7 cm tall". */
void falling_row_summary(const struct falling_row *row, char text[SENTENCE]);

/* Writes how the row ends. */
void falling_row_verdict(const struct falling_row *row, char text[SENTENCE]);

/* Writes which domino is the weakest, and how much energy it has, or "". */
void falling_row_weakest(const struct falling_row *row, char text[SENTENCE]);

/* Writes what happens at a moment: "2.500 s after the push: domino 3 falls, 7 still stand." */
void falling_row_moment(const struct falling_row *row, const struct domq_moment *moment, char text[SENTENCE]);

#endif
