/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Computes the answers at the points of a sweep. */
#ifndef SHELL_POINT_H
#define SHELL_POINT_H

#include "sweeps/sweeps.h"

/* The question that is evaluated at each point. In a list of questions, each answer is one number. */
struct point_question {
    struct question question;
    struct point_question *next;
};

enum { SWEEP_REASON = 256 };

/* Counts two kinds of points: points without any answer, and points with a reason why a value is missing. A
 * point without an answer also has a reason, so it is in both counts. */
struct tally {
    size_t without_answer, with_reason;
    size_t first; /* index of the first point that has a reason */
    char reason[SWEEP_REASON];
};

/* The columns of a sweep: the parameters of the grid, then the columns of the answer. */
struct sweep_columns {
    struct column column[ANSWER_COLUMNS];
    const char *key[ANSWER_COLUMNS]; /* key in the answer; NULL for a parameter of the grid */
    /* The unit may change from point to point. Cells whose unit is not that of the first point are empty. */
    bool is_fixed[ANSWER_COLUMNS];
    /* new names, such as "rmax.s", for columns of the answer whose key is also the name of a parameter of the
     * grid */
    char renamed[ASSIGNED_MAX][40];
    struct column answer[ANSWER_COLUMNS]; /* one column for each question in a list */
    char unit[ANSWER_COLUMNS][UNIT_TEXT]; /* the units of expressions in a list */
};

/* The data of one worker. All workers use the same grid, question and query, and do not change them. */
struct sweeper {
    const struct grid *grid;
    const struct point_question *question;
    const struct query *query; /* the state of the session, which each point copies and changes */
    const char *command;       /* the name of the command that does the sweep, for messages */
    /* query->run_context without --shard, because the answer at a point is not divided */
    struct run_context run_context;
    bool styled; /* true if the grid changes the precision or the tolerance */
    /* Receives this worker's part of the sweep. It is also the template from which the answer at each point
     * is made. */
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

/* Makes the columns of the sweep. Two kinds of columns of the answer are left out: columns that only repeat a
 * parameter of the grid, and columns that take a long time to compute (sweep.echo and
 * sweep.slow_column of struct command). Fails if there are too many columns. */
bool sweeper_columns(struct sweeper *w, struct problem *problem);

/* Stores the values of the parameters at point k in w->assigned and w->value. */
void point_values(struct sweeper *w, size_t k);

/* Looks for a point with an answer among the first 256 points. If there is one, stores its first row in
 * w->sample, and sets w->answered. If the question has an error, sets w->problem and returns false. */
bool point_probe(struct sweeper *w);

/* Callbacks of struct workers. On an error, point_write stores it in sweeper->problem and returns false. */
bool point_write(void *sweeper, size_t k, FILE *out);
/* Adds the tally of `worker` to the tally of `sweeper`. */
void sweeper_merge(void *sweeper, const void *worker);

#endif
