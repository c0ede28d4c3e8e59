/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The shape of a row that is being improved: turns free variables into dominoes that keep the limits. */
#ifndef DOM_SHAPE_H
#define DOM_SHAPE_H

#include "numerics/api.h"

struct shape {
    const struct dom_row *row; /* the row as it is given */
    const struct dom_limits *limits;
};

/* Returns the number of variables: the logarithms of the gaps and, if sizes change, of the heights of the
 * dominoes between the first and the last. A row whose measures may not change has none. */
size_t shape_variables(const struct shape *shape);

/* Sets the variables to the measures of the row. */
void shape_begin(const struct shape *shape, double *x);

/* Changes the height and the thickness of a domino, and with them its mass and the radius of its edges. */
void shape_resize(const struct shape *shape, struct dom_domino *domino, dom_real height, dom_real thickness);

/* Writes the dominoes that belong to the variables. Gaps are narrowed if the row would be longer than the
 * hall, or a gap wider than the domino before it is tall. If `final` is true, all measures that have changed
 * are rounded to the grid. Returns false if the dominoes do not fit into the hall. */
bool shape_dominoes(const struct shape *shape, const double *x, bool final, struct dom_domino *domino);

/* Returns true if a row keeps the limits. */
bool shape_keeps(const struct shape *shape, const struct dom_domino *domino);

#endif
