/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The answers at one point of a sweep. */
#ifndef SHELL_POINT_H
#define SHELL_POINT_H

#include "commands/sweeps/grid.h"

/* The question that is asked at each point; or a list of questions, each about one number in its column. */
struct point_question {
    struct question question;
    struct point_question *next; /* NULL after the last, and for a question that is no list */
};

enum { SWEEP_REASON = 256 };

/* Points without an answer, or whose answer lacks a value. */
struct tally {
    size_t without_answer, with_reason;
    size_t first; /* the first point with a reason, and its reason */
    char reason[SWEEP_REASON];
};

/* The columns of a sweep: the parameters of the grid, and then those of the answers. */
struct sweep_columns {
    struct column column[ANSWER_COLUMNS];
    const char *key[ANSWER_COLUMNS]; /* the key of each column in the answer */
    char renamed[ASSIGNED_MAX][40];  /* "rmax.s" for a column of the answer with the name of a parameter */
    struct column answer[ANSWER_COLUMNS]; /* the columns of the answer, if it is a list of questions */
    char unit[ANSWER_COLUMNS][24];        /* their units, of expressions */
};

/* The data of a worker. The sweep and the query are shared, and do not change. */
struct sweeper {
    const struct grid *grid;
    const struct point_question *question;
    const struct query *query; /* each point changes a copy of its state */
    const char *command;       /* the name of the command that sweeps, for problems */
    struct means means;        /* of the points */
    bool styled;               /* the grid changes how numbers are written */
    struct answer answer;      /* of the sweep, before its first row */
    struct sweep_columns columns;
    struct cell sample[ANSWER_COLUMNS]; /* a row of the first point that has an answer, after point_probe */
    struct tally tally;
    /* Of the point that is computed: */
    struct assigned assigned[ASSIGNED_MAX];
    struct cell value[ASSIGNED_MAX];
    struct answer *to;         /* where its rows go, or NULL */
    bool answered;             /* its answer has a row */
    char reason[SWEEP_REASON]; /* why it lacks something, or "" */
    struct problem problem;
};

/*
 * Makes the columns. A column of the answer that only repeats a parameter of the grid is left out, unless an
 * argument takes the place of this parameter. Returns false with a problem if there are too many columns.
 */
bool sweeper_columns(struct sweeper *w, struct problem *problem);

/* Sets w->value and w->assigned to the values of point k. */
void point_values(struct sweeper *w, size_t k);

/* Looks for an answer among the first points, for w->sample. Returns false with w->problem if a question is
 * wrong. */
bool point_probe(struct sweeper *w);

/* Writes the rows of point k. Returns false with w->problem if a question is wrong. A `point` of struct
 * workers, whose copies are merged by sweeper_merge. */
bool point_write(void *sweeper, size_t k, FILE *out);
void sweeper_merge(void *sweeper, const void *worker);

#endif
