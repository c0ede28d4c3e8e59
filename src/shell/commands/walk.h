/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A walk through the cycles of the train, event by event. */
#ifndef SHELL_WALK_H
#define SHELL_WALK_H

#include "session/query.h"

/* The units of the model in a given cycle: they grow from cycle to cycle. */
struct walk_units {
    domq_real height; /* of the head, in m */
    domq_real tau;    /* in s */
    domq_real
        energy; /* m g h / 2 of the head: in J, or divided by that of the first head if no mass is known */
    const char *energy_unit;
    domq_real weight; /* m g of the head: in N, or divided by that of the first head */
    const char *weight_unit;
};

struct walk_units walk_units(const struct query *query, int cycle);

/* Returns the session's walk, or NULL if none has begun in the train that the session has now. */
const struct walk *walk_now(const struct query *query);

/* Gives an answer its columns with energies in J; walk_columns_in does it only if a mass is known. */
void columns_in_joules(struct answer *answer);
void walk_columns_in(const struct query *query, struct answer *answer);

/* The reason why no cycle begins. */
extern const char walk_no_start[];

/* Returns true if the train moves and comes to this tilt. Otherwise describes the problem. */
bool train_comes_to(const struct query *query, struct problem *problem, domq_real theta);

/* Returns "28.65 deg" or "0.5 rad", for sentences. */
struct measured angle_text(const struct query *query, domq_real theta, int digits);

/* Describes the place of a walk, with the symbols of the paper and the numbers of its equations. */
void walk_say(const struct query *query, const struct walk *walk, const struct domq_state *state,
              struct answer *answer);

#endif
