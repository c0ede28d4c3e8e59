/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Measures how much computing time accuracy costs. One quantity is computed by every method, in every
 * precision and with smaller and smaller tolerances. A measurement records the time and the true error, which
 * is the difference from a more accurate reference value.
 */
#ifndef SHELL_COST_H
#define SHELL_COST_H

#include "session/query.h"

/* The names of the quantities that can be measured, as a names_list (see names.h). */
const char *cost_names(const void *context, int k);

struct cost_row {
    enum dom_method method;
    enum dom_precision precision;
    double tol;
    enum dom_status status; /* if `status` is not DOM_OK, the members below are not set */
    domq_real error; /* relative error, or the error bound of the reference value if this bound is larger */
    struct dom_work work;
    double seconds; /* the shortest time of several runs, in s */
};

enum { COST_ROWS = 64 };

struct cost {
    struct cost_row row[COST_ROWS];
    int rows;
    double cheapest; /* time of the quickest measurement, in seconds */
};

/* For the train of the scene, measures the quantity with index `which` in cost_names. On failure, sets
 * *problem and returns false. */
bool cost_measure(const struct query *query, int which, struct cost *cost, struct problem *problem);

/* Measures how long a call of `answer` takes. The calls are made in batches, each long enough to be measured
 * by the clock. Returns the seconds per call in the fastest batch, or NaN if a call returns false. */
double seconds_of(bool (*answer)(void *context), void *context);

#endif
