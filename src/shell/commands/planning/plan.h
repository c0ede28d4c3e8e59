/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A designed row as dominoes: what to saw, where to place each, and its file. */
#ifndef SHELL_PLAN_H
#define SHELL_PLAN_H

#include "interpreter/command.h"

/* The row of the design as dominoes, and what builders want to know of it. */
struct plan {
    struct domq_domino *domino;
    size_t count;
    domq_real mass; /* of the first; 0: not known */
    bool hollow;
};

/* Makes the dominoes; the last is exactly `height` tall. False: no memory, which was reported. */
bool plan_make(const struct query *query, struct problem *problem, const struct domq_design *design,
               domq_real height, struct plan *plan);

/* Returns the surface of a hollow domino, half as wide as tall, or the volume of another one. */
domq_real plan_material(const struct plan *plan, const struct domq_domino *domino);

/* Writes the dominoes for people, with the place of each, from the back of the first. */
void plan_list(const struct answer *answer, const struct plan *plan);

/* Writes the row into a file, with the columns that 'effect row FILE' reads. */
void plan_file(struct answer *answer, const struct plan *plan);

#endif
