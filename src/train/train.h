/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The commands about a train, and what their files share. */
#ifndef SHELL_TRAIN_H
#define SHELL_TRAIN_H

#include "interpreter/command.h"

extern const struct command cycle_commands[], walk_commands[], limit_commands[], cost_commands[],
    effect_commands[];

/* The members that most commands about a train share. */
#define TRAIN_COMMAND .precision = PRECISION_AS_SET, .train = true

/* The parts of commands that are defined outside the files of their tables. */
extern const struct column count_columns[], why_columns[], growths_columns[], fewest_columns[];

/* What 'curve' shows for each separation. */
extern const struct command growths_command;
bool run_fewest(const struct query *query, struct answer *a, struct problem *problem);
bool run_count(const struct query *query, struct answer *a, struct problem *problem);
bool run_why(const struct query *query, struct answer *a, struct problem *problem);

/* Returns a word for the verdict about a train: "goes on", "stops", "locks" or "no fuel". */
struct cell verdict_cell(enum dom_status verdict);

/* Prints whether the train keeps falling, and its energy divided by the energy that it needs. */
void verdict_train_say(const struct query *query, struct answer *answer, enum dom_status verdict,
                       const struct domq_barrier *barrier);

#endif
