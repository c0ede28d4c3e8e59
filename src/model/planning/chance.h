/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The fraction of random rows that do not fall, as a smooth function of the gaps and sizes of the row. */
#ifndef DOM_CHANCE_H
#define DOM_CHANCE_H

#include "planning/shape.h"

struct chance {
    const struct shape *shape;
    struct dom_compute compute;
    struct dom_placement placement; /* the random rows that are run */
    /* The width of the smoothing for each margin. A row counts as falling with a probability that is the
     * product of Phi(margin / width) over all margins. With smaller widths, the result is closer to the count
     * of rows that fall. */
    const double *width;
};

/* Finds the fraction of the rows that do not fall. Unless by_gap is NULL, also finds the derivatives of this
 * fraction with respect to the gap before each domino, in 1/m, and with respect to the logarithm of the size
 * of each domino. */
enum dom_status chance_find(const struct chance *chance, const struct dom_domino *domino, double *fails,
                            double *by_gap, double *by_size);

/* Finds the margins of each row, as 2 * count numbers per row: first ln(kinetic / barrier) for each domino,
 * and then, for each domino, how far the previous domino reaches beyond the gap between the two, as a
 * fraction of the height of the previous domino. */
enum dom_status chance_margins(const struct chance *chance, const struct dom_domino *domino, double *margin);

#endif
