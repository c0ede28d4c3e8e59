/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Functions that parse, bind and run a sweep, for the commands 'sweep' and 'plot sweep'. */
#ifndef SHELL_SWEEP_H
#define SHELL_SWEEP_H

#include "sweeps/grid.h"

/* Callbacks of the arguments GRID and ': ANSWER'. They parse the grid, parse the list of requested answers
 * after the ':', and bind both. */
bool sweep_parse_grid(struct reader *reader, struct question *question);
bool sweep_parse_answers(struct reader *reader, struct question *question);
bool sweep_bind(const struct question *question, const struct query *query, struct arguments *given,
                struct problem *problem);
/* The argument N of 'curve FROM TO N', which is a sweep over s of what growths_command answers. */
bool curve_bind(const struct question *question, const struct query *query, struct arguments *given,
                struct problem *problem);

struct sweep_shape {
    const struct grid *grid;
    const struct command *command; /* the command that is swept, or the first one of a list */
    const char *typed;             /* the answers as they were typed */
    size_t answers;                /* the number of answers; if there are several, each has one column */
};

/* Returns the grid and the answers of a sweep whose arguments have been bound. */
struct sweep_shape sweep_shape(const struct arguments *given);

bool run_sweep(const struct query *query, struct answer *a, struct problem *problem);

#endif
