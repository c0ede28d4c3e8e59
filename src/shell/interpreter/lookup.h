/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The values of expressions in a state. */
#ifndef SHELL_LOOKUP_H
#define SHELL_LOOKUP_H

#include "interpreter/resolve.h"

/* Evaluates a tree whose names are resolved, in the state of a query. Without a message a problem is
 * described. */
bool query_evaluate(const struct query *query, struct evaluation *evaluation, const struct tree *tree,
                    struct quantity *result, struct problem *problem);

/* Makes a copy of the query's state with these values, and a query that has it. Returns false with a problem.
 */
bool query_with(const struct query *query, const struct assigned *assigned, int count, struct state *state,
                struct query *changed, struct problem *problem);

#endif
