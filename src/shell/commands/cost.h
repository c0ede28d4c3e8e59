/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Measures what accuracy costs in computing time. One quantity is computed with every method and precision,
 * and with smaller and smaller tolerances. Each measurement has its time and its true error, which is the
 * distance from a more accurate reference.
 */
#ifndef SHELL_COST_H
#define SHELL_COST_H

#include "session/query.h"

/* Lists, in the form that names.h expects, the names of the quantities that can be measured. */
const char *cost_names(const void *context, int k);

/* One measurement. */
struct cost_row {
    enum dom_method method;
    enum dom_precision precision;
    double tol;
    enum dom_status status; /* if `status` is not DOM_OK, the members below are not set */
    domq_real error;        /* relative error, never less than the error bound on the reference */
    struct dom_work work;
    double seconds; /* shortest time of several runs */
};

enum { COST_ROWS = 64 };

struct cost {
    struct cost_row row[COST_ROWS];
    int rows;
    double cheapest; /* time of the quickest measurement, in seconds */
};

/* Measures the quantity with index `which` in cost_names for the train of the scene. If this fails, sets
 * *problem and returns false. */
bool cost_measure(const struct query *query, int which, struct cost *cost, struct problem *problem);

/* Times the callback `answer`. Calls it in several batches, each long enough for the clock to resolve, and
 * returns the seconds per call in the fastest batch. Returns NaN if a call returns false. */
double seconds_of(bool (*answer)(void *context), void *context);

#endif
