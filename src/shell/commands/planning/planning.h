/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the files about planning give to the table of their commands, in design.c. */
#ifndef SHELL_PLANNING_H
#define SHELL_PLANNING_H

#include "interpreter/arguments.h"

extern const struct column sensitivity_columns[], solve_columns[], fit_columns[];
bool run_assert(const struct query *query, struct answer *a, struct problem *problem);
bool run_sensitivity(const struct query *query, struct answer *a, struct problem *problem);
bool run_fit(const struct query *query, struct answer *a, struct problem *problem);
bool run_solve(const struct query *query, struct answer *a, struct problem *problem);

/* Reads the command of 'sensitivity', which may have a key. */
bool sensitivity_read(struct reader *reader, struct arguments *call);

bool run_watch(struct session *session, const struct arguments *given, struct answer *a,
               struct problem *problem);
bool watch_read_answer(struct reader *reader, struct arguments *call);

/* Read the arguments of 'solve', of which 'watch' has the first; lists for names.h the parameters that it
 * takes. */
const char *solve_names(const void *context, int k);
bool solve_read_parameter(struct reader *reader, struct arguments *call);
bool solve_read_answer(struct reader *reader, struct arguments *call);

/* Lists for names.h what 'fit' finds. */
const char *fit_names(const void *context, int k);

/* Reads the command of 'assert'; lists for names.h the commands that decide something. */
bool assert_read(struct reader *reader, struct arguments *call);
const char *assert_names(const void *context, int k);

#endif
