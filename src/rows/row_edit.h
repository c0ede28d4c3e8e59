/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Changes the dominoes of a row, removes them, and inserts others. */
#ifndef ROWS_ROW_EDIT_H
#define ROWS_ROW_EDIT_H

#include "session/row.h"
#include <stdio.h>

/* A range of consecutive dominoes, counted from 1. */
struct row_range {
    size_t first, last;
};

/* Returns true if domino k is in one of the ranges. */
bool row_selected(const struct row_range *range, int ranges, size_t k);

struct row_change {
    enum row_measure measure;
    enum { CHANGE_TO, CHANGE_BY, CHANGE_TIMES } how; /* replace the measurement, add to it, or multiply it */
    domq_real value; /* a new value or a difference, in m or kg; or a factor */
    bool is_angle;   /* the value is a lean angle in rad, not the distance of the top from plumb */
    bool is_bare;    /* the value was typed without a unit */
};

/* Changes one measurement of all dominoes in the ranges. If the measurement is a size, the domino keeps its
 * density. The changes are lost when the row is replaced. On failure, sets *problem, changes nothing and
 * returns false. */
bool scene_row_change(struct scene *scene, const struct row_change *change, const struct row_range *range,
                      int ranges, struct problem *problem);

/* Gives all dominoes of the row the gaps, heights, thicknesses and radii of the `count` dominoes in `to`, and
 * if `sizes` is true also their widths and the ratios of their masses. On failure, sets *problem and returns
 * false; the row may have changed. */
bool scene_row_set(struct scene *scene, const struct domq_domino *to, size_t count, bool sizes,
                   struct problem *problem);

/* Removes the dominoes in the ranges. The gaps before the other dominoes stay the same. On failure, sets
 * *problem, changes nothing and returns false. */
bool scene_row_remove(struct scene *scene, const struct row_range *range, int ranges,
                      struct problem *problem);

/* Inserts a copy of the domino that has the number k, counted from 1, or of the last one. The copy gets this
 * number. On failure, sets *problem, changes nothing and returns false. */
bool scene_row_insert(struct scene *scene, size_t k, struct problem *problem);

/* Writes the changes as commands for a saved script: 'remove', 'insert' and 'change'. */
void row_changes_save(const struct scene *scene, FILE *out);

#endif
