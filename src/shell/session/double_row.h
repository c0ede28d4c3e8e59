/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Converts rows to double, in which the library searches and runs many rows, and the results back. */
#ifndef SHELL_DOUBLE_ROW_H
#define SHELL_DOUBLE_ROW_H

#include "domino_quad.h"

/* A row in double. The caller frees `domino`. */
struct double_row {
    struct dom_row row;
    struct dom_compute compute;
    struct dom_domino *domino;
};

/* Converts a row without its engine. Returns false if memory runs out. */
bool double_row_make(const struct domq_row *row, const struct domq_compute *compute, struct double_row *made);

struct dom_train train_in_double(const struct domq_train *train);
/* If the tolerance is too small for double, the result has the default tolerance of double. */
struct dom_compute compute_in_double(const struct domq_compute *compute);
struct dom_domino domino_in_double(const struct domq_domino *domino);

/* Converts a domino that the library has computed in double to quad, with 15 digits. */
struct domq_domino domino_from_double(const struct dom_domino *domino);

#endif
