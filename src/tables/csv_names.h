/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The columns that a kind of csv file may have, and the headings by which files call them: a name, perhaps
 * the number of a trial, and a unit. */
#ifndef TABLES_CSV_NAMES_H
#define TABLES_CSV_NAMES_H

#include "language/names.h"
#include "tables/csv.h"

/* CSV_COLUMNS_MOST is the maximum number of columns that a kind of table knows. A file may also have unknown
 * columns, but at most CSV_OTHERS_MOST. When a row is saved, the unknown columns are written next to the
 * known ones, and a line can have at most CSV_CELLS_MOST columns. */
enum { CSV_COLUMNS_MOST = 16, CSV_OTHERS_MOST = CSV_CELLS_MOST - CSV_COLUMNS_MOST };

/* Properties of a column, as bits. */
enum {
    CSV_REQUIRED = 1,  /* every file must have this column */
    CSV_EMPTY = 2,     /* the cells of the column may be empty */
    CSV_NOT_FIRST = 4, /* the cell of the first row is ignored, and may be empty or out of range */
    CSV_WHOLE = 8,     /* the values of the column are whole numbers */
    CSV_BARE = 16,     /* a number without a unit is in the SI unit of the column */
    CSV_ONE_OF = 32,   /* at most one of the columns with this property may occur, and one must occur if any
                          of them is required */
    CSV_REPEATED = 64, /* the column may occur several times; at most one column has this property */
};

/* A column that a kind of table may have. */
struct csv_column {
    const char *name;
    unsigned traits;    /* a name that ends in " %" is that of a column in per cent: its values are shares */
    const char *unit;   /* the SI unit of the values; "" for plain numbers, NULL for text */
    const char *units;  /* for messages: a list of the units that a file may use */
    const char *usual;  /* for messages: the unit to suggest */
    const char *advice; /* advice for messages, for example "write a length such as 48 mm" */
    double lowest, highest; /* the ends of the range, which are included */
    const char *range;      /* for messages: the range, such as "0 .. 1e9 m" */
};
#define CSV_ABOVE_0 4.9e-324 /* the smallest double above 0, for a range that does not include 0 */

/* Initialises the members unit, units and usual for a column of lengths. */
#define CSV_LENGTH "m", "m, mm, cm, km, in, ft, yd", "mm"

/* A kind of table, such as a row of dominoes or a series of measurements. */
struct csv_kind {
    const struct csv_column *column;
    int columns; /* at most CSV_COLUMNS_MOST */
    size_t rows_most;
    /* for messages: the noun for what a row describes, and its plural, such as "domino" and "dominoes" */
    const char *item, *items;
    const char *names;   /* for messages: a list of the names of the columns */
    const char *example; /* for messages: an example of a first line */
    /* If the file lacks a required column of this kind, the table may be of the kind `otherwise`, which is
     * tried next. NULL if there is no other kind. If no kind fits, messages are about the first kind that was
     * tried. */
    const struct csv_kind *otherwise;
};

/* ---- Headings ---- */

enum { CSV_UNIT = 32 };

/* Extracts the unit from a string such as "mm", "(mm)" or "[mm]". Returns false if the string is not a
 * unit. */
bool csv_unit_copy(const char *text, char unit[CSV_UNIT]);

/* Splits the heading of a column into a name and a unit. Folds the name and returns the unit. The unit
 * follows a bracket or a comma, as in "height (mm)", or it is the last word, as in "height in mm", or it
 * follows a '/', as in "height/mm". If the unit is per cent, as a sign or a word, the name ends in " %". */
const char *csv_name_split(const char *text, char name[NAMES_SHOWN]);

/* Finds the column of a kind that a file calls by this folded name. A column that may occur several times may
 * have the number of a trial, too. Returns kind->columns if there is no such column. */
int csv_column_find(const struct csv_kind *kind, const char *name, const char *unit);

/* Returns true for a folded name such as "average speed". */
bool csv_is_average(const char *name);

enum { CSV_ADVICE = 128 };

/* Advice for messages: how to head a file that has only one column. "" if no kind has one column. */
const char *csv_single_advice(const struct csv_kind *kind, char text[CSV_ADVICE]);

#endif
