/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The commands 'maximize' and 'minimize', and their charts. */
#ifndef SHELL_OPTIMUM_H
#define SHELL_OPTIMUM_H

#include "sweeps/peak.h"
#include "sweeps/sweeps.h"

enum { OPTIMUM_AXES = 2, OPTIMUM_POINTS = 41 /* along each of two parameters */ };

/* The arguments of a search, after binding. */
struct optimum {
    struct ranged range[OPTIMUM_AXES];
    int axes;
    const struct question *question;
    bool is_minimum;
};

/* A search for the best answer. With two parameters, the answer for a value of the first one is the best
 * answer over the range of the second one. Values that are sought as minima have the opposite sign here. */
struct hunt {
    const struct optimum *optimum;
    struct probe probe;
    struct slope slope[OPTIMUM_AXES];
    double first;               /* the value of the first parameter, while the second one is varied */
    struct problem fault;       /* the last error in the question itself; its kind is PROBLEM_NONE before */
    double value[PEAK_POINTS];  /* the answers at the points along the first parameter */
    bool is_wrong[PEAK_POINTS]; /* the question itself turned out to be wrong at this point */
    size_t count, missing;      /* the number of these points, and of those without an answer */
    struct peak peak[OPTIMUM_AXES]; /* the result for each parameter */
    domq_real best;                 /* the best answer, with its own sign */
    domq_real off;                  /* its error is at most this */
    char reason[PROBLEM_TEXT / 2];  /* why the first of the missing answers is missing */
    char beyond[PROBLEM_TEXT / 2];  /* why there is no answer beyond the best place, or "" */
};

/* Searches the whole range. The caller frees *hunt. On failure, sets *problem and returns NULL. */
struct hunt *optimum_find(const struct optimum *optimum, const struct query *query, struct problem *problem);

/* Callbacks of the arguments of 'maximize', 'minimize' and 'plot'. */
bool maximize_parse(struct reader *reader, struct question *question);
bool minimize_parse(struct reader *reader, struct question *question);
bool optimum_parse_answer(struct reader *reader, struct question *question);
bool optimum_bind(const struct question *question, const struct query *query, struct arguments *given,
                  struct problem *problem);
const char *optimum_names(const void *context, int k); /* a names_list of the parameters */

#endif
