/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Computes the answers at the points of a sweep. */
#ifndef SHELL_POINT_H
#define SHELL_POINT_H

#include "commands/sweeps/grid.h"

/* The question that is evaluated at each point. If there is a list of questions, the answer to each of them
 * is one number. */
struct point_question {
    struct question question;
    struct point_question *next; /* the next question of the list, or NULL */
};

enum { SWEEP_REASON = 256 };

/* Counts of the points that have no answer, and of the points where a value is missing for a known reason. */
struct tally {
    size_t without_answer, with_reason;
    size_t first; /* index of the first point where a value is missing for a known reason */
    char reason[SWEEP_REASON];
};

/* The columns of a sweep: the parameters of the grid, then the columns of the answer. */
struct sweep_columns {
    struct column column[ANSWER_COLUMNS];
    const char *key[ANSWER_COLUMNS]; /* key of the column in the answer; NULL for a parameter of the grid */
    /* Names such as "rmax.s" for those columns of the answer that would otherwise have the same name as a
     * parameter of the grid. */
    char renamed[ASSIGNED_MAX][40];
    struct column answer[ANSWER_COLUMNS]; /* one column for each question of a list */
    char unit[ANSWER_COLUMNS][UNIT_TEXT]; /* the units of expressions in a list */
};

/* The data of one worker. All workers use the same grid, question and query, and do not change them. */
struct sweeper {
    const struct grid *grid;
    const struct point_question *question;
    const struct query *query; /* the state of the session, which each point copies and changes */
    const char *command;       /* the name of the command that does the sweep, for messages */
    struct means means;        /* without the shard of the sweep, because a point is not divided into parts */
    bool styled;               /* true if the grid changes the number of digits */
    /* This worker's part of the answer of the sweep, and the template for the answer at each point. */
    struct answer answer;
    struct sweep_columns columns;
    struct cell sample[ANSWER_COLUMNS]; /* a sample row of the sweep, set by point_probe */
    struct tally tally;
    /* The values of the parameters at the point that is being computed. */
    struct assigned assigned[ASSIGNED_MAX];
    struct cell value[ASSIGNED_MAX];
    struct answer *to;         /* receives the rows: &answer, or NULL to discard them */
    bool answered;             /* true if the answer at this point has at least one row */
    char reason[SWEEP_REASON]; /* why a value is missing, or "" */
    struct problem problem;
};

/* Makes the columns of the sweep: one for each parameter of the grid, and then those of the answer. Leaves
 * out columns that only repeat a parameter of the grid, and columns that take much longer to compute than the
 * others. Sets *problem and returns false if there are too many columns. */
bool sweeper_columns(struct sweeper *w, struct problem *problem);

/* Computes the values of the parameters at point k. */
void point_values(struct sweeper *w, size_t k);

/* Looks among the first 256 points for one that has an answer. If there is one, stores its row in w->sample
 * and sets w->answered. If the question has an error, sets w->problem and returns false. */
bool point_probe(struct sweeper *w);

/* Callbacks of struct workers. point_write writes the rows of point k. If the question has an error, it
 * stores the problem in the sweeper and returns false. sweeper_merge adds the tally of a worker to that of
 * another worker. */
bool point_write(void *sweeper, size_t k, FILE *out);
void sweeper_merge(void *sweeper, const void *worker);

#endif
