/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The errors of an answer. If 'errors' is on, an answer is computed twice: as the session asks, and with the
 * digits of quad precision. The error of a number is the difference, plus the rounding error of the number,
 * plus the uncertainty that the search for it has left (cell_uncertain). This is not a proof: if both
 * computations make the same mistake, the difference does not show it.
 */
#ifndef SHELL_REFERENCE_H
#define SHELL_REFERENCE_H

#include "answer/cell.h"

/* The rows of the same answer in quad precision. */
struct reference {
    struct cell *cell; /* the cells of all rows */
    size_t columns;    /* the number of cells in a row */
    size_t first;      /* the index of the first row: with --shard, it may be above 0 */
    size_t rows, room;
    /* True if nothing can be compared with these rows: the computation failed, or a part of it has only one
     * precision. */
    bool is_void;
};

/* Adds the row with the index `at`. Rows come in order. */
void reference_add(struct reference *reference, size_t at, const struct cell *cells, size_t columns);

/* Sets the errors of the numbers in the row with the index `at`. If a word, a count or a yes-or-no cell of
 * this row differs from the reference, no error of the row is known: the two computations have come to
 * different conclusions. */
void reference_compare(const struct reference *reference, size_t at, const struct answer_style *style,
                       struct cell *cells, size_t columns);

void reference_free(struct reference *reference);

#endif
