/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The session's row for pictures: where its dominoes stand along a tape measure, and how each leans at a
 * time. */
#ifndef SHELL_FALLING_ROW_H
#define SHELL_FALLING_ROW_H

#include "picture/scene.h"
#include "session/effects.h"

/* A row and how it falls. Lengths in m, times in s on the clock of struct dom_fall. */
struct falling_row {
    struct scene_row scene;
    size_t count;
    double *at;    /* of each domino: its back, from the back of the first: the tape measure */
    double *hit;   /* when it is hit; NaN: never, or it is the first and tips over its edge */
    double *slid;  /* how far its foot has slid at the moment that is watched */
    double *share; /* the energy that it has, of the energy that it needs; NaN: not known */
    struct domq_verdict verdict;
    double end;      /* when the motion ends; NaN: a time has no value */
    double smallest; /* heights */
    double tallest;
    bool tipped; /* it starts without a push: times before 0 are those of the first domino alone */
};

/* Makes the row, and runs it. False: an error was reported, and nothing is to be freed. */
bool falling_row_make(const struct query *query, struct problem *problem, struct falling_row *row);
void falling_row_free(struct falling_row *row);

/* Returns the time from which on a row that is tipped over its edge is seen to move; 0 for one that is
 * pushed. */
double falling_row_begins(const struct falling_row *row);

/* Calls visit for the row at each of these times, which do not decrease. */
enum dom_status falling_row_watch(const struct falling_row *row, const domq_real *times, size_t count,
                                  domq_moment_visit *visit, void *context);

/* Returns the tilt of domino k, from 0, before it is hit. */
double falling_row_lean(const struct falling_row *row, size_t k);

/* Returns domino k, from 0, at this tilt: number, corners in m, no contact. */
struct drawn falling_row_domino(const struct falling_row *row, size_t k, double tilt);

/* Return true for domino k, from 0, if the row ends there without having fallen, and if it is the weakest. */
bool row_ends_at(const struct falling_row *row, size_t k);
bool row_weakest_is(const struct falling_row *row, size_t k);

/* Returns 1, 2 or 5 times a power of ten, the least that is not below this. */
double row_step(double least);

/* Writes how many dominoes there are, and how tall: "7 dominoes, 4.8 cm to 54.7 cm tall". */
enum { ROW_SENTENCE = 512 };
void falling_row_summary(const struct falling_row *row, char text[ROW_SENTENCE]);

/* Writes how the row ends, in one sentence; mark says how the picture shows the domino where it does. */
void falling_row_verdict(const struct falling_row *row, const char *mark, char text[ROW_SENTENCE]);

/* Writes which domino is the weakest, and how much energy it has, or "". */
void falling_row_weakest(const struct falling_row *row, const char *mark, char text[ROW_SENTENCE]);

/* Writes what happens at a time, in a few words: "domino 3 falls, 4 to 10 stand". */
void falling_row_moment(const struct falling_row *row, size_t head, double time, char text[ROW_SENTENCE]);

#endif
