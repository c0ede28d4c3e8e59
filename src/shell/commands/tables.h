/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The parts of the shell's own commands that are defined outside the files of their tables. */
#ifndef SHELL_TABLES_H
#define SHELL_TABLES_H

#include "interpreter/command.h"

/* Runs 'set' and 'effect', which change the parameter or effect that the arguments name. */
bool run_set(const struct query *query, struct answer *a, struct problem *problem);

extern const struct column print_columns[];
bool conversion_parse(struct reader *reader, struct question *question);
bool conversion_bind(const struct question *question, const struct query *query, struct arguments *given,
                     struct problem *problem);
bool definition_parse(struct reader *reader, struct question *question);
bool definition_bind(const struct question *question, const struct query *query, struct arguments *given,
                     struct problem *problem);
extern const struct column show_columns[];
bool run_show(const struct query *query, struct answer *a, struct problem *problem);
const char *show_names(const void *context, int k); /* a names_list: the parameters and "all" */

bool run_print(const struct query *query, struct answer *a, struct problem *problem);
/* Prints the variable that the arguments name, or all variables if they name none. */
bool show_variables(const struct query *query, struct answer *a);
extern const struct column landmarks_columns[];
bool run_landmarks(const struct query *query, struct answer *a, struct problem *problem);
bool run_let(const struct query *query, struct answer *a, struct problem *problem);
bool run_details(struct session *session, const struct arguments *given, struct answer *a,
                 struct problem *problem);
extern const struct column version_columns[];
bool run_version(const struct query *query, struct answer *a, struct problem *problem);

#endif
