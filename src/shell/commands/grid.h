/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A grid of values of any parameters and effects: "s 0.1 0.9 81 q hollow, solid friction 0 0.5 6". */
#ifndef SHELL_GRID_H
#define SHELL_GRID_H

#include "interpreter/arguments.h"

enum { AXES_MAX = 8 };

/* The values of one parameter, or of the first argument of one effect. */
struct axis {
    const struct parameter *parameter;
    size_t count;
    domq_real from, to;
    bool logarithmic; /* steps of equal ratio */
    domq_real *list;  /* the values, where they are listed; else NULL */
};

struct grid {
    struct axis axis[AXES_MAX];
    int axes;
    size_t points; /* the product of their counts; the first axis is the slowest */
};

/* Up to a ':' or the end of the command; what is wrong is an error of the session. */
bool grid_read(struct reader *reader, struct grid *grid);
void grid_free(struct grid *grid);

/* What a grid can go over, for names.h: parameters of the model, then effects. */
const char *grid_names(const void *context, int k);

/* Value k, counted from 0; and as a cell. */
domq_real axis_value(const struct axis *axis, size_t k);
struct cell axis_cell(const struct axis *axis, domq_real value);

/* Gives a session the value of each axis.  It borrows what others hold, so it must not be closed. */
void grid_put(const struct grid *grid, const domq_real *value, struct session *session);

/* Do effects of the grid find in the session, once it has values, what they are about?  An error if not. */
bool grid_check(const struct grid *grid, struct session *session);

#endif
