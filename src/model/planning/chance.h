/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The share of random rows that do not fall, as a smooth function of the gaps and sizes of the row. */
#ifndef DOM_CHANCE_H
#define DOM_CHANCE_H

#include "planning/shape.h"

struct chance {
    const struct shape *shape;
    struct dom_compute compute;
    struct dom_placement placement; /* its rows are those that are run */
    /* For each margin the width of the smoothing: a row with the margins z falls with the probability that is
     * the product of Phi(z / width). Smaller widths are closer to counting. */
    const double *width;
};

/* Finds the share of the rows that do not fall. Unless by_gap is NULL, also finds the derivatives of this
 * share with respect to the gap before each domino, in 1/m, and to the logarithm of the size of each
 * domino. */
enum dom_status chance_find(const struct chance *chance, const struct dom_domino *domino, double *fails,
                            double *by_gap, double *by_size);

/* Finds the margins of each row, 2 * count numbers for each: ln(kinetic / barrier) of each domino, and then
 * the share of its height by which the domino before it reaches beyond the gap. */
enum dom_status chance_margins(const struct chance *chance, const struct dom_domino *domino, double *margin);

#endif
