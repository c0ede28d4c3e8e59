/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Converts the variables of the search for a better row into dominoes that are within the limits. */
#ifndef DOM_SHAPE_H
#define DOM_SHAPE_H

#include "numerics/api.h"

struct shape {
    const struct dom_row *row; /* the row before any change */
    const struct dom_limits *limits;
};

/*
 * Returns the number of variables. Each gap has one: ln(gap / height of the domino before it). If sizes may
 * change, each gap has a second variable: ln of the growth across the gap. Adding a constant to all second
 * variables does not change the row.
 */
size_t shape_variables(const struct shape *shape);

/* Sets the variables x to the values that describe shape->row. */
void shape_begin(const struct shape *shape, double *x);

/* Returns true if a domino of this height must be as thick as one of the boards. Boxes may have any
 * thickness. */
bool shape_from_board(const struct shape *shape, dom_real height);

/* Sets the height and the thickness of a domino, and adapts its mass and the radius of its edges. */
void shape_resize(const struct shape *shape, struct dom_domino *domino, dom_real height, dom_real thickness);

/* Writes the dominoes for the variables x. Narrows gaps that are too wide for the hall or for a domino's
 * reach. If `final` is true, rounds lengths to the grid. Returns false if the hall is too short even without
 * gaps. */
bool shape_dominoes(const struct shape *shape, const double *x, bool final, struct dom_domino *domino);

/* Rounds the dimensions of a row to the grid and to the boards. The first domino keeps its sizes, and the
 * last its height. */
void shape_round(const struct shape *shape, struct dom_domino *domino);

/* Returns DOM_OK, or a status that says which of the limits is outside its range. */
enum dom_status limits_check(const struct dom_limits *limits);

/* Returns true if a row is within the limits. */
bool shape_keeps(const struct shape *shape, const struct dom_domino *domino);

#endif
