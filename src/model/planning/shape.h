/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The shape of a row that is being improved. Converts the free variables of the search into dominoes within
 * the limits. */
#ifndef DOM_SHAPE_H
#define DOM_SHAPE_H

#include "numerics/api.h"

struct shape {
    const struct dom_row *row; /* the row before any change */
    const struct dom_limits *limits;
};

/* Returns the number of variables. These are the logarithms of the gaps, each divided by the height of the
 * domino before it, and, if sizes change, the logarithms of the growths from domino to domino. Only the
 * differences between the growths matter, since the last domino keeps its height. A row whose dimensions may
 * not change has no variables. */
size_t shape_variables(const struct shape *shape);

/* Sets the variables to the values that describe the given row. */
void shape_begin(const struct shape *shape, double *x);

/* Returns the volume of the wood of a domino that is half as wide as it is tall, or 0 if its walls do not
 * fit. */
dom_real wood_volume(const struct dom_row *row, dom_real height, dom_real thickness);

/* Returns true if a domino of this height has the thickness of one of the boards. A domino that is too tall
 * to be solid is a box, which may have any thickness. */
bool shape_from_board(const struct shape *shape, dom_real height);

/* Sets the height and the thickness of a domino, and adapts its mass and the radius of its edges. */
void shape_resize(const struct shape *shape, struct dom_domino *domino, dom_real height, dom_real thickness);

/* Writes the dominoes that the variables describe. Gaps are narrowed if the row would be longer than the
 * hall, or if a gap would be wider than the height of the domino before it. If `final` is true, all lengths
 * that may change are rounded to the grid. Returns false if the dominoes do not fit into the hall. */
bool shape_dominoes(const struct shape *shape, const double *x, bool final, struct dom_domino *domino);

/* Rounds the dimensions of a row: the heights of all dominoes but the first and the last, the thicknesses of
 * all but the first, and the positions. */
void shape_round(const struct shape *shape, struct dom_domino *domino);

/* Returns DOM_OK, or the status that says which limit is outside its range. */
enum dom_status limits_check(const struct dom_limits *limits);

/* Returns true if a row is within the limits. */
bool shape_keeps(const struct shape *shape, const struct dom_domino *domino);

#endif
