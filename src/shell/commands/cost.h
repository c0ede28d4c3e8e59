/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * What accuracy costs in time: one answer is computed with every method and precision, to one tolerance after
 * the other. A row has its true error, which is its distance from a finer reference, and its time.
 */
#ifndef SHELL_COST_H
#define SHELL_COST_H

#include "session/query.h"

/* The list, for names.h, of the answers that can be measured. */
const char *cost_names(const void *context, int k);

struct cost_row {
    enum dom_method method;
    enum dom_precision precision;
    double tol;
    enum dom_status status; /* the members below are valid only if it is DOM_OK */
    domq_real error;        /* relative; at least the bound of the reference's own error */
    struct dom_work work;
    double seconds; /* the shortest of several runs */
};

enum { COST_ROWS = 64 };

struct cost {
    struct cost_row row[COST_ROWS];
    int rows;
    double cheapest; /* seconds of the quickest row */
};

/* Measures answer number `which` of cost_names for the train of the scene. Returns false with a problem. */
bool cost_measure(const struct query *query, int which, struct cost *cost, struct problem *problem);

/* Returns the seconds that an answer takes: the shortest of several batches, each of which is long enough for
 * the clock. Returns NaN if the answer fails. */
double seconds_of(bool (*answer)(void *context), void *context);

#endif
