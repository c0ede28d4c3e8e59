/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * What accuracy costs in time: one answer, asked of every method and precision at one tolerance after the
 * other, with its true error against a finer reference, and the time it takes.
 */
#ifndef SHELL_COST_H
#define SHELL_COST_H

#include "domino_quad.h"

/* An answer that has a tolerance: one number, and the bound of its error. */
struct costed {
    const char *name, *says;
    enum dom_status (*ask)(const struct domq_train *train, const struct domq_compute *compute,
                           struct domq_value *answer);
};

/* Ends with a NULL name. */
extern const struct costed cost_answers[];

/* Lists for names.h the names of these answers. */
const char *cost_names(const void *context, int k);

struct cost_row {
    enum dom_method method;
    enum dom_precision precision;
    double tol;
    enum dom_status status; /* of the answer; the rest only where it is DOM_OK */
    domq_real error;        /* relative; not below what the reference itself may be wrong by */
    struct dom_work work;
    double seconds; /* least of several runs */
};

enum { COST_ROWS = 64 };

struct cost {
    struct cost_row row[COST_ROWS];
    int rows;
    double cheapest; /* seconds */
    domq_real value; /* of the reference */
};

/* Fills cost. Returns another status than DOM_OK if the answer does not exist, or after an interrupt. */
enum dom_status cost_measure(const struct costed *answer, const struct domq_train *train,
                             const struct domq_compute *compute, struct cost *cost);

/* Fills cost for the train of the scene, or describes a problem and returns false. */
struct query;
struct problem;
bool cost_of(const struct query *query, struct problem *problem, const struct costed *answer,
             struct cost *cost);

/* Returns the name of a method, such as "GSL". */
const char *cost_method(enum dom_method method);

/* Returns the quickest row whose relative error is at most this; NULL if there is none. */
const struct cost_row *cost_reaching(const struct cost *cost, enum dom_method method,
                                     enum dom_precision precision, double error);

#endif
