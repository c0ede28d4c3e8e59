/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The measures of single dominoes that 'change' and 'place' have changed. */
#ifndef SHELL_ROW_CHANGE_H
#define SHELL_ROW_CHANGE_H

#include "session/scene.h"
#include <stdio.h>

/* Dominoes with successive numbers, from 1. */
struct row_range {
    size_t first, last;
};

/* How a measure of dominoes changes. */
struct row_change {
    enum row_measure measure;
    enum { CHANGE_TO, CHANGE_BY, CHANGE_TIMES } how; /* to a value, by adding one, or by a factor */
    domq_real value;                                 /* in m or kg, or the factor */
    bool is_angle; /* the value of a lean is an angle in rad, not the distance of the top off plumb */
    bool is_bare;  /* the value was typed without a unit */
};

/* Returns the measure of a domino: the member to which the change of a listed_row applies. */
domq_real *row_measure_at(struct domq_domino *domino, enum row_measure measure);

/* Applies all changes to the first `count` dominoes of the row. */
void row_changes_apply(const struct listed_row *row, struct domq_domino *domino, size_t count);

/* Makes room for changes of a row with `count` dominoes. Returns false if there is no memory. */
bool row_changes_open(struct listed_row *row, size_t count);

/* Returns the number of measures that have been changed. */
size_t row_changes_count(const struct listed_row *row);

bool row_changes_equal(const struct listed_row *a, const struct listed_row *b);

/* Writes the commands that restore the changes. */
void row_changes_save(const struct listed_row *row, FILE *out);

/* A names_list (see names.h) of the measures. */
const char *row_measure_names(const void *context, int k);

#endif
