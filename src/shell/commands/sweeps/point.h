/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The answers at one point of a sweep. */
#ifndef SHELL_POINT_H
#define SHELL_POINT_H

#include "commands/sweeps/grid.h"

/* The question that is asked at each point, or a list of questions about one number each. */
struct point_question {
    struct question question;
    struct point_question *next; /* NULL after the last question of a list, and without a list */
};

enum { SWEEP_REASON = 256 };

/* Counts the points that have no answer, and those where some value is missing for a reason. */
struct tally {
    size_t without_answer, with_reason;
    size_t first; /* the first point with a reason */
    char reason[SWEEP_REASON];
};

/* The columns of a sweep: the parameters of the grid, then the columns of the answer. */
struct sweep_columns {
    struct column column[ANSWER_COLUMNS];
    const char *key[ANSWER_COLUMNS];      /* how the answer calls this column, or NULL */
    char renamed[ASSIGNED_MAX][40];       /* names such as "rmax.s", if the answer has a column s, too */
    struct column answer[ANSWER_COLUMNS]; /* one column for each question of a list */
    char unit[ANSWER_COLUMNS][24];        /* the units of expressions in a list */
};

/* The data of one worker. Workers share what the pointers point to, and do not change it. */
struct sweeper {
    const struct grid *grid;
    const struct point_question *question;
    const struct query *query; /* each point changes a copy of its state */
    const char *command;       /* the name of the sweeping command, for messages */
    struct means means;        /* the means of each point: no shard */
    bool styled;               /* the grid changes the number of digits */
    struct answer answer;      /* the answer of the sweep, from which its parts are made */
    struct sweep_columns columns;
    struct cell sample[ANSWER_COLUMNS]; /* set by point_probe */
    struct tally tally;
    /* The point that is being computed. */
    struct assigned assigned[ASSIGNED_MAX];
    struct cell value[ASSIGNED_MAX];
    struct answer *to;         /* takes the rows, or NULL to drop them */
    bool answered;             /* the answer has at least one row */
    char reason[SWEEP_REASON]; /* why a value is missing, or "" */
    struct problem problem;
};

/*
 * Makes the columns of the sweep. If the command repeats a parameter of the grid in a column of its answer,
 * this column is left out, unless an argument of the command replaces the parameter. Returns false with a
 * problem if there are too many columns.
 */
bool sweeper_columns(struct sweeper *w, struct problem *problem);

/* Computes the values of the parameters at point k. */
void point_values(struct sweeper *w, size_t k);

/* Stores the row of the first point that has an answer in w->sample, and sets w->answered if there is one
 * among the first 256. Returns false with w->problem if the question has an error. */
bool point_probe(struct sweeper *w);

/* The functions `point` and `merge` of struct workers: the first writes the rows of point k, and returns
 * false with w->problem if the question has an error; the second adds the tally of a worker to that of
 * another. */
bool point_write(void *sweeper, size_t k, FILE *out);
void sweeper_merge(void *sweeper, const void *worker);

#endif
