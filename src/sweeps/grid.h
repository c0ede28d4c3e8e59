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
    bool logarithmic; /* true if neighbouring values have a constant ratio instead of a constant difference */
    const domq_real *list; /* the values of a list, or NULL */
};

struct grid {
    struct axis axis[ASSIGNED_MAX]; /* the value of the first axis changes slowest */
    int axes;
    size_t points; /* the product of the counts of all axes */
};

struct grid_parsed {
    struct axis_parsed {
        const struct parameter *parameter;
        struct value_parsed {
            struct item item;
            struct value_parsed *next;
        } * first;    /* the value FROM, or a linked list of all values if the axis is a list */
        size_t count; /* the number of values in a list, or 0 if the axis has the form FROM TO N */
        struct item to, steps;
        const char *log_at; /* points to the word 'log' in the command, or is NULL */
    } axis[ASSIGNED_MAX];
    int axes;
    size_t listed; /* the number of values in all lists */
};

/* Parses a grid up to the ':'. */
bool grid_parse(struct reader *reader, struct grid_parsed *grid);

/* Evaluates a parsed grid in the state of a query. `listed` has room for the values of all lists. */
bool grid_bind(const struct grid_parsed *parsed, const struct text *text, const struct query *query,
               domq_real *listed, struct grid *grid, struct problem *problem);

/* Returns value number k of an axis, counted from 0. */
domq_real axis_value(const struct axis *axis, size_t k);

struct cell axis_cell(const struct axis *axis, domq_real value);

#endif
