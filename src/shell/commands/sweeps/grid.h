/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A grid of values of any parameters and effects: "s 0.1 0.9 81 q hollow, solid friction 0 0.5 6". */
#ifndef SHELL_GRID_H
#define SHELL_GRID_H

#include "interpreter/question.h"

/* The values of one parameter, or of the first argument of one effect. */
struct axis {
    const struct parameter *parameter;
    size_t count;
    domq_real from, to;
    bool logarithmic; /* steps of equal ratio */
    domq_real *list;  /* the values of a list; else NULL */
};

struct grid {
    struct axis axis[ASSIGNED_MAX];
    int axes;
    size_t points; /* the product of the counts; the first axis changes slowest */
};

/* The same as it was parsed. */
struct value_parsed {
    struct item item;
    struct value_parsed *next;
};
struct axis_parsed {
    const struct parameter *parameter;
    struct value_parsed *first; /* of the list, or FROM */
    size_t count;               /* of the list; 0: FROM TO N */
    struct item to, steps;
    bool logarithmic;
    const char *log_at; /* where 'log' is */
};
struct grid_parsed {
    struct axis_parsed axis[ASSIGNED_MAX];
    int axes;
};

/* Parses a grid up to ':' or the end of the command. */
bool grid_parse(struct reader *reader, struct grid_parsed *grid);

/* Gives the grid its values in the state of a query. Free it with grid_free, also after a problem. */
bool grid_bind(const struct grid_parsed *parsed, const struct text *text, const struct query *query,
               struct grid *grid, struct problem *problem);
void grid_free(struct grid *grid);

/* Return value k, counted from 0; and a value as a cell. */
domq_real axis_value(const struct axis *axis, size_t k);
struct cell axis_cell(const struct axis *axis, domq_real value);

#endif
