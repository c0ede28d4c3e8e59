/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Draws the row of the scene on a stage, before or while it falls, and describes it in sentences. */
#pragma once

#include "pictures/picture/stage.h"
#include "rows/rows.h"

/* A row that has been run, and the stage on which it is drawn. Lengths are in m. Times are in s, as in struct
 * domq_fall. */
struct falling_row {
    struct row_run run;
    struct stage stage;
    double *slid;    /* how far each foot has slid at the moment that is shown */
    double end;      /* the time when the motion ends, or NaN if it cannot be computed */
    bool has_tower;  /* the last domino of the run is drawn as a tower */
    size_t dominoes; /* the number of dominoes, not counting the tower */
};

/* Runs the row and draws it as it stands before the fall. With `has_tower`, the last domino is the tower of
 * tower_make. After a failure nothing needs to be freed. */
bool falling_row_make(const struct query *query, struct problem *problem, bool has_tower,
                      struct falling_row *row);
void falling_row_free(struct falling_row *row);

/* Returns the time when domino k, counted from 0, is hit, or NaN if this never happens or cannot be computed.
 * For k = 0, returns the time 0 at which the clock starts. */
double falling_row_hit(const struct falling_row *row, size_t k);

/* Runs the row again and calls `visit` at each of the times, which must not decrease. Infinity stands for the
 * end of the motion. */
enum dom_status falling_row_watch(const struct falling_row *row, const double *times, size_t count,
                                  dom_moment_visit *visit, void *context);

/* Draws the dominoes at a moment or, if `moment` is NULL, before the fall. */
void falling_row_pose(struct falling_row *row, const struct dom_moment *moment);

/* Sets the right end of the stage to the right end of the standing row or, if `lying` is true, of the fallen
 * row. */
void falling_row_reach(struct falling_row *row, bool lying);

/* Returns the height of the tallest or the smallest one of the first `count` dominoes. */
double falling_row_extreme(const struct falling_row *row, size_t count, bool tallest);

/* ---- 'draw tower' and 'animate tower' ---- */

/* A query about the row that the last 'count' found. One more domino, as tall as the tower, ends this row. */
struct tower {
    struct query query;
    struct state state; /* shares memory with the state of the original query */
    struct listed_row *row;
};

/* On failure, sets *problem and returns false. Even then, the caller must call tower_free. */
bool tower_make(const struct query *query, struct tower *tower, struct problem *problem);
void tower_free(struct tower *tower);

/* ---- Sentences ---- */

enum { SENTENCE = 256 };

/* Writes the number of dominoes and their heights, for example "7 dominoes, 4.8 cm to 54.7 cm tall". */
void falling_row_summary(const struct falling_row *row, char text[SENTENCE]);

/* Writes how the fall ends. */
void falling_row_verdict(const struct falling_row *row, char text[SENTENCE]);

/* Writes which domino is the weakest, and how much energy it has. Writes "" if the drawing marks no domino as
 * the weakest. */
void falling_row_weakest(const struct falling_row *row, char text[SENTENCE]);

/* Writes what the builder does to start the row. A push is given as a speed, which one can judge. */
void falling_row_begin(const struct falling_row *row, char text[SENTENCE]);

/* Returns the event at which the clock starts: "first hit", "push" or "release". */
const char *falling_row_start(const struct falling_row *row);

/* Writes what happens at a moment, for example "2.500 s after the push: domino 3 falls; 7 dominoes still
 * stand." */
void falling_row_moment(const struct falling_row *row, const struct dom_moment *moment, char text[SENTENCE]);
