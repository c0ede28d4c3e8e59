/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Measures the computing time that accuracy costs. Several methods compute the same quantity in several
 * precisions, with smaller and smaller tolerances. The error of a result is its difference from a more
 * accurate reference. */
#ifndef SHELL_COST_H
#define SHELL_COST_H

#include "session/query.h"

/* The names of the quantities that can be measured, as a names_list (see names.h). */
const char *cost_names(const void *context, int k);

struct cost_row {
    enum dom_method method;
    enum precision precision;
    double tol;
    enum dom_status status; /* if `status` is not DOM_OK, the members below are not set */
    domq_real error;        /* the relative error of the result, or that of the reference if it is larger */
    struct dom_work work;
    double seconds; /* the time that an answer takes: the shortest of up to seven measurements */
};

enum { COST_ROWS = 65 };

struct cost {
    struct cost_row row[COST_ROWS];
    int rows;
    double cheapest; /* time of the quickest measurement, in seconds */
};

/* Measures the quantity with index `which` in cost_names, for the train of the scene. */
bool cost_measure(const struct query *query, int which, struct cost *cost, struct problem *problem);

#endif
