/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The changes to the measurements of single dominoes, which commands such as 'change' and 'improve' make. */
#ifndef SHELL_ROW_CHANGE_H
#define SHELL_ROW_CHANGE_H

#include "session/scene.h"

/* Returns a pointer to the member that holds a measurement. `domino` may be the
 * member `to` of struct changed_domino. */
domq_real *row_measure_at(struct domq_domino *domino, enum row_measure measure);

/* Returns true if the measurement is a size: the height, the thickness or the width. When a size changes, the
 * domino keeps its density. */
static inline bool row_measure_is_size(enum row_measure measure)
{
    return measure == MEASURE_HEIGHT || measure == MEASURE_THICKNESS || measure == MEASURE_WIDTH;
}

/* Applies the stored changes to domino k of the row, counted from 0. */
void row_changes_apply(const struct scene *scene, size_t k, struct domq_domino *domino);

/* Allocates the changes for a row of `count` dominoes, if necessary. Returns false if memory runs out. */
bool row_changes_open(struct listed_row *row, size_t count);

/* Returns the number of measurements that have been changed. */
size_t row_changes_count(const struct listed_row *row);

/* Returns true if two scenes have made the same changes to a row. */
bool row_changes_equal(const struct scene *a, const struct scene *b);

#endif
