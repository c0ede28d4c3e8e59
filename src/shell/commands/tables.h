/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Declares the tables of commands, and the commands whose table is in another file.
 *
 * To add a command, add a struct command (see command.h) to one of these tables. Write its columns and its
 * function run_NAME in the file of the table. If you write them in another file, declare them here or in the
 * header of that file's folder.
 */
#ifndef SHELL_TABLES_H
#define SHELL_TABLES_H

#include "interpreter/command.h"

/* All commands, in the order in which 'help' lists them. A group with a NULL title ends the list. */
extern const struct command_group all_commands[];

extern const struct command cycle_commands[];   /* cycle.c */
extern const struct command walk_commands[];    /* step.c */
extern const struct command limit_commands[];   /* limit.c */
extern const struct command prove_commands[];   /* prove.c */
extern const struct command explain_commands[]; /* explain/explain.c */
extern const struct command draw_commands[];    /* drawing/draw.c */
extern const struct command plot_commands[];    /* plots/plot.c */
extern const struct command sweep_commands[];   /* sweeps/sweep_table.c */
extern const struct command effect_commands[];  /* effect.c */
extern const struct command row_commands[];     /* rows/row.c */
extern const struct command design_commands[];  /* planning/planning_table.c */
extern const struct command study_commands[];   /* rows/study.c */
extern const struct command cost_commands[];    /* cost.c */
extern const struct command session_commands[]; /* settings.c */
extern const struct command script_commands[];  /* script.c */
extern const struct command help_commands[];    /* help.c */

/* The columns and the function of a command that prints an answer, both named after the command. */
#define ANSWER(name_) .columns = name_##_columns, .run = run_##name_

/* Runs 'set' and 'effect', which change the parameter or effect that the arguments name. */
bool run_set(const struct query *query, struct answer *a, struct problem *problem);

/* The parts of commands that are defined outside the files of their tables. */
extern const struct column costs_columns[];
bool run_costs(const struct query *query, struct answer *a, struct problem *problem);
extern const struct column count_columns[], why_columns[], animate_columns[];
bool run_count(const struct query *query, struct answer *a, struct problem *problem);
bool run_why(const struct query *query, struct answer *a, struct problem *problem);

/* Returns a word for the verdict about a train: "goes on", "stops", "locks" or "no fuel". */
struct cell verdict_cell(enum dom_status verdict);

/* Prints whether the train keeps falling, and its energy divided by the energy that it needs. */
void verdict_train_say(const struct query *query, struct answer *answer, enum dom_status verdict,
                       const struct domq_barrier *barrier);

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
bool run_diff(const struct query *query, struct answer *a, struct problem *problem);

bool run_lesson(struct session *session, const struct arguments *given, struct answer *a,
                struct problem *problem);
bool run_print(const struct query *query, struct answer *a, struct problem *problem);
/* Prints the variable that the arguments name, or all variables if they name none. */
bool show_variables(const struct query *query, struct answer *a);
bool run_let(const struct query *query, struct answer *a, struct problem *problem);

bool run_animate(const struct query *query, struct answer *a, struct problem *problem);

/* Rounds the parameters of a train to double precision. domino_proof.h says for which trains a proof about
 * the rounded train holds. */
struct dom_train proof_train(const struct domq_train *train);

#endif
