/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The headings of columns in csv files: a name, perhaps the number of a trial, and a unit. */
#ifndef SHELL_CSV_NAMES_H
#define SHELL_CSV_NAMES_H

#include "language/csv_table.h"
#include "language/names.h"

enum { CSV_UNIT = 32 };

/* Extracts the unit from a string such as "mm", "(mm)" or "[mm]". Returns false if the string is not a
 * unit. */
bool csv_unit_copy(const char *text, char unit[CSV_UNIT]);

/* Splits the heading of a column into a name and a unit. Folds the name and returns the unit. The unit
 * follows a bracket or a comma, as in "height (mm)", or it is the last word, as in "height in mm", or it
 * follows a '/', as in "height/mm". If the unit is per cent, the name ends in " %". */
const char *csv_name_split(const char *text, char name[NAMES_SHOWN]);

/* Finds the column of a kind that a file calls by this folded name. A column that may occur several times may
 * have the number of a trial, too. Returns kind->columns if there is no such column. */
int csv_column_find(const struct csv_kind *kind, const char *name, const char *unit);

/* Returns true for a folded name such as "average speed". */
bool csv_is_average(const char *name);

#endif
