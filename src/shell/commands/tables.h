/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The tables of commands, and the commands that are defined in other files than their tables. */
#ifndef SHELL_TABLES_H
#define SHELL_TABLES_H

#include "interpreter/command.h"

/* All commands in the order of 'help'. A NULL title ends the list. */
extern const struct command_group all_commands[];

extern const struct command cycle_commands[], walk_commands[], limit_commands[], cost_commands[],
    session_commands[], help_commands[], draw_commands[], plot_commands[], effect_commands[], row_commands[],
    study_commands[], sweep_commands[], design_commands[], prove_commands[], script_commands[];

/* The last members of a row, for a command that answers: its columns and its function. */
#define ANSWER(name_) .columns = name_##_columns, .run = run_##name_

/* Sets the parameter or effect that the call names: 'set' and 'effect'. */
bool run_set(const struct query *query, struct answer *a, struct problem *problem);

/* Commands in files of their own. */
extern const struct column cycle_columns[], count_columns[], why_columns[], animate_columns[];
bool run_cycle(const struct query *query, struct answer *a, struct problem *problem);
bool run_count(const struct query *query, struct answer *a, struct problem *problem);
bool run_why(const struct query *query, struct answer *a, struct problem *problem);

/* Says whether the train goes on, and with how much of the energy that it needs. */
void verdict_train_say(const struct query *query, struct answer *answer, enum dom_status verdict,
                       const struct domq_barrier *barrier);

/* print and let: their parsers and what they do. */
extern const struct column print_columns[];
bool conversion_parse(struct reader *reader, struct question *question);
bool conversion_bind(const struct question *question, const struct query *query, struct arguments *given,
                     struct problem *problem);
bool definition_parse(struct reader *reader, struct question *question);
bool definition_bind(const struct question *question, const struct query *query, struct arguments *given,
                     struct problem *problem);
extern const struct column show_columns[];
bool run_show(const struct query *query, struct answer *a, struct problem *problem);
bool run_diff(const struct query *query, struct answer *a, struct problem *problem);

bool run_lesson(struct session *session, const struct arguments *given, struct answer *a,
                struct problem *problem);
bool run_print(const struct query *query, struct answer *a, struct problem *problem);
/* Shows the variable of the call, or all variables. */
bool show_variables(const struct query *query, struct answer *a);
bool run_let(const struct query *query, struct answer *a, struct problem *problem);

bool run_animate(const struct query *query, struct answer *a, struct problem *problem);

/* Returns the train in double precision: a proof holds for all values that round to it. */
struct dom_train proof_train(const struct domq_train *train);

/* The list, for names.h, of the ways to space the rows of 'cycle'. */
const char *cycle_by(const void *context, int k);

#endif
