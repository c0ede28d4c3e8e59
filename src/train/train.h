/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The commands about a train, and what their files share. */
#ifndef SHELL_TRAIN_H
#define SHELL_TRAIN_H

#include "interpreter/command.h"

extern const struct command cycle_commands[], walk_commands[], limit_commands[], cost_commands[];

/* The members that most commands about a train share. */
#define TRAIN_COMMAND .precision = PRECISION_AS_SET, .train = true

/* The parts of commands that are defined outside the files of their tables. */
extern const struct column why_columns[];
/* Finds the largest growth with each of the two formulas for the fuel. */
enum dom_status limits_find(struct domq_train train, const struct any_compute *compute,
                            struct domq_limit *exact, struct domq_limit *paper);

bool run_count(const struct query *query, struct answer *a, struct problem *problem);
bool run_why(const struct query *query, struct answer *a, struct problem *problem);

/* Returns a word for the verdict about a train: "goes on", "stops", "locks" or "no fuel". */
struct cell verdict_cell(enum dom_status verdict);

/* Returns the reason why a train with this verdict does not keep falling, or NULL for any other status. */
const char *verdict_reason(enum dom_status verdict);

/* Prints whether the train keeps falling, and its energy divided by the energy that it needs. */
void verdict_train_say(const struct query *query, struct answer *answer, enum dom_status verdict,
                       const struct domq_barrier *barrier);

/* A method that a feature adds to those that 'cost' compares. It computes in double. */
struct method {
    const char *name;
    double share; /* roughly the fraction of the time that the method takes, for the progress display */
    enum dom_status (*barrier)(const struct dom_train *, const struct dom_compute *, struct dom_barrier *);
    enum dom_status (*duration)(const struct dom_train *, const struct dom_compute *, double *);
    enum dom_status (*rmax)(const struct dom_train *, const struct dom_compute *, struct dom_limit *);
};

/* ---- A walk through the cycles of the train, event by event ---- */

/* The units in which the model measures one cycle. The head of each cycle is r times as large as the head
 * before it, and the units grow with the head. If the mass of the dominoes is not known, `energy` is
 * relative to the energy of the first head. */
struct walk_units {
    domq_real height; /* height of the head, in m */
    domq_real tau;    /* unit of time, in s */
    /* m g h / 2 of the head, in J if a mass is known */
    domq_real energy;
    const char *energy_unit;
};

/* Cycles are numbered from 1. */
struct walk_units walk_units(const struct query *query, int cycle);

/* Returns the session's walk. Returns NULL if there is no walk, or if the train or the accuracy has changed
 * since the walk began. */
const struct walk *walk_now(const struct query *query);

/* Replaces the unit mgh/2 by J in the columns of an answer. */
void columns_in_joules(struct answer *answer);
/* Calls columns_in_joules if the mass of the dominoes is known. */
void walk_columns_in(const struct query *query, struct answer *answer);

/* Formats an angle in the session's unit for a sentence, for example as "28.65 deg" or "0.5 rad". */
struct measured angle_text(const struct query *query, domq_real theta, int digits);

#endif
