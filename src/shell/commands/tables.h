/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The tables of commands, and the commands that are not defined in the same file as the table that lists
 * them. */
#ifndef SHELL_TABLES_H
#define SHELL_TABLES_H

#include "interpreter/command.h"

/* All commands, in the order in which 'help' lists them. A group with a NULL title ends the list. */
extern const struct command_group all_commands[];

extern const struct command cycle_commands[], walk_commands[], limit_commands[], cost_commands[],
    session_commands[], help_commands[], draw_commands[], plot_commands[], effect_commands[], row_commands[],
    study_commands[], sweep_commands[], design_commands[], prove_commands[], explain_commands[],
    script_commands[];

/* Initialises the columns and the function of a command that prints an answer. Both are named after the
 * command. */
#define ANSWER(name_) .columns = name_##_columns, .run = run_##name_

/* Runs 'set' and 'effect', which change the parameter or effect that the arguments name. */
bool run_set(const struct query *query, struct answer *a, struct problem *problem);

/* Commands that are defined in separate files. */
extern const struct column count_columns[], why_columns[], animate_columns[];
bool run_count(const struct query *query, struct answer *a, struct problem *problem);
bool run_why(const struct query *query, struct answer *a, struct problem *problem);

/* Returns a word for the verdict about a train: "goes on", "stops", "locks" or "no fuel". */
struct cell verdict_cell(enum dom_status verdict);

/* Prints whether the train keeps falling, and how much energy it has relative to the energy that it needs. */
void verdict_train_say(const struct query *query, struct answer *answer, enum dom_status verdict,
                       const struct domq_barrier *barrier);

/* The parsers and the functions of the commands print and let, and of show and diff. */
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
/* Prints the variable that the arguments name, or all variables if they name none. */
bool show_variables(const struct query *query, struct answer *a);
bool run_let(const struct query *query, struct answer *a, struct problem *problem);

bool run_animate(const struct query *query, struct answer *a, struct problem *problem);

/* Converts a train to double precision. A proof for the result holds for all parameters that round to these
 * doubles. */
struct dom_train proof_train(const struct domq_train *train);

#endif
