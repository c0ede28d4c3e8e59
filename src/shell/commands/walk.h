/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A walk through the cycles, event by event: where it is, and what is said there. */
#ifndef SHELL_WALK_H
#define SHELL_WALK_H

#include "session/query.h"

/* What a length, a time and an energy of the model are in the cycle of a walk. */
struct walk_units {
    domq_real height; /* of the head, in m */
    domq_real tau;    /* in s */
    domq_real energy; /* m g h / 2 of the head: in J, or in that of the first head where no mass is known */
    const char *energy_unit;
    domq_real weight; /* m g of the head, in N or in that of the first head */
    const char *weight_unit;
};

struct walk_units walk_units(const struct query *query, int cycle);

/* Returns the session's walk, or NULL where none has begun in the train that the session has now. */
const struct walk *walk_now(const struct query *query);

/* Gives the answer its columns with energies in J. */
void columns_in_joules(struct answer *answer);

/* Gives the answer its columns with energies in J if a mass is known. */
void walk_columns_in(const struct query *query, struct answer *answer);

/* Holds why no cycle begins. */
extern const char walk_no_start[];

/* Returns true if the train moves and comes to this tilt; else describes why not. */
bool train_comes_to(const struct query *query, struct problem *problem, domq_real theta);

/* Says the event in words, with the paper's symbols and the numbers of its equations. */
void walk_say(const struct query *query, const struct walk *walk, const struct domq_state *state,
              struct answer *answer);

#endif
