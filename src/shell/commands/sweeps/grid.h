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
    domq_real *list;  /* the values of a list; else NULL */
};

struct grid {
    struct axis axis[AXES_MAX];
    int axes;
    size_t points; /* the product of the counts; the first axis changes slowest */
};

/* Reads a grid up to ':' or the end of the command. Reports an error if it is wrong. */
bool grid_read(struct reader *reader, struct grid *grid);
void grid_free(struct grid *grid);

/* Returns the name of parameter k of a grid, for names.h: those of the model, then effects. */
const char *grid_names(const void *context, int k);

/* Return value k, counted from 0; and a value as a cell. */
domq_real axis_value(const struct axis *axis, size_t k);
struct cell axis_cell(const struct axis *axis, domq_real value);

/* Sets the values in a copy of a state, which shares its memory with the original and must not be closed. */
void grid_put(const struct grid *grid, const domq_real *value, struct state *state);

/* Reports an error if an effect of the grid needs another effect that is off. */
bool grid_check(const struct grid *grid, const struct scene *scene, struct problem *problem);

#endif
