/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the files about planning give to the table of their commands, in design.c. */
#ifndef SHELL_PLANNING_H
#define SHELL_PLANNING_H

#include "interpreter/question.h"

extern const struct column sensitivity_columns[], solve_columns[], fit_columns[];
bool run_assert(const struct query *query, struct answer *a, struct problem *problem);
bool run_sensitivity(const struct query *query, struct answer *a, struct problem *problem);
bool run_fit(const struct query *query, struct answer *a, struct problem *problem);
bool run_solve(const struct query *query, struct answer *a, struct problem *problem);

/* Parses the command of 'sensitivity', which may have a key. */
bool sensitivity_parse(struct reader *reader, struct question *question);

bool run_watch(struct session *session, const struct arguments *given, struct answer *a,
               struct problem *problem);

/* Parse the arguments of 'solve' and 'watch'; lists for names.h the parameters that they take. */
const char *solve_names(const void *context, int k);
bool solve_parse_parameter(struct reader *reader, struct question *question);
bool solve_parse_answer(struct reader *reader, struct question *question);
bool watch_parse_answer(struct reader *reader, struct question *question);
bool solve_bind(const struct question *question, const struct query *query, struct arguments *given,
                struct problem *problem);

/* Lists for names.h what 'fit' finds. */
const char *fit_names(const void *context, int k);

/* Parses the command or the condition of 'assert'; lists for names.h the commands that decide something. */
bool assert_parse(struct reader *reader, struct question *question);
const char *assert_names(const void *context, int k);

#endif
