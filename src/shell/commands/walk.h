/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A walk through the cycles of the train, event by event. */
#ifndef SHELL_WALK_H
#define SHELL_WALK_H

#include "session/query.h"

/* The units of the model in one cycle of the train. They grow from cycle to cycle, as the head does. */
struct walk_units {
    domq_real height; /* height of the head, in m */
    domq_real tau;    /* unit of time, in s */
    /* The unit of energy, m g h / 2 of the head: in J or, if no mass is known, relative to m g h / 2 of the
     * first head. */
    domq_real energy;
    const char *energy_unit;
    /* The weight m g of the head: in N or, if no mass is known, relative to m g of the first head. */
    domq_real weight;
    const char *weight_unit;
};

/* Returns the units of measurement in a cycle. Cycles are numbered from 1. */
struct walk_units walk_units(const struct query *query, int cycle);

/* Returns the session's walk, or NULL if there is none or the train has changed since the walk began. */
const struct walk *walk_now(const struct query *query);

/* Replaces the unit mgh/2 by J in the columns of an answer. */
void columns_in_joules(struct answer *answer);
/* Calls columns_in_joules if the mass of the dominoes is known. */
void walk_columns_in(const struct query *query, struct answer *answer);

/* The message that no cycle begins, because falling releases no energy. */
extern const char walk_no_start[];

/* Returns true if the train moves and its head reaches the tilt theta. Otherwise sets *problem and returns
 * false. */
bool train_comes_to(const struct query *query, struct problem *problem, domq_real theta);

/* Finds the events of a cycle, for a picture of it. Sets *stops to true if the train stops, and to false
 * otherwise. If there is no cycle to show, sets *problem and returns false. */
bool cycle_events(const struct query *query, const struct domq_compute *compute,
                  struct domq_event event[DOM_EVENTS_MAX], int *count, bool *stops, struct problem *problem);

/* Formats an angle in the session's unit for a sentence, for example as "28.65 deg" or "0.5 rad". */
struct measured angle_text(const struct query *query, domq_real theta, int digits);

/* Prints what happens at the current position of a walk, with the symbols of the paper and the numbers of its
 * equations. */
void walk_say(const struct query *query, const struct walk *walk, const struct domq_state *state,
              struct answer *answer);

#endif
