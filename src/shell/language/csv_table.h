/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Tables in csv files. The first line names the columns, in any order and in any case, and may give their
 * units: "height (mm)", "height [mm]", "height, mm", "height mm" or "height_mm". The line below it may give
 * the units instead. A cell is an expression, and a unit in the cell takes precedence; '-' is an empty cell.
 * A file means the same in every session: names have no values in it, and an angle without a unit is in
 * radians.
 */
#ifndef SHELL_CSV_TABLE_H
#define SHELL_CSV_TABLE_H

#include "domino_quad.h"
#include "language/csv.h"

/* A row that is saved must be readable again, with all columns of its kind and all other columns of its file.
 */
enum { CSV_COLUMNS_MOST = 12, CSV_OTHERS_MOST = CSV_CELLS_MOST - CSV_COLUMNS_MOST };

/* The traits of a column. */
enum {
    CSV_REQUIRED = 1,  /* every file must have the column */
    CSV_EMPTY = 2,     /* its cells may be empty */
    CSV_NOT_FIRST = 4, /* the first row needs no value, and its value may be out of range */
    CSV_WHOLE = 8,     /* its values are whole numbers */
};

/* A column that tables of a kind may have. */
struct csv_column {
    const char *name;
    const char *synonyms; /* "spacing,distance"; may be NULL */
    unsigned traits;
    const char *unit;       /* the SI unit of the values; "" for plain numbers, NULL for text */
    const char *units;      /* for messages: all units that a file may use */
    const char *usual;      /* for messages: the unit to propose */
    const char *advice;     /* for messages: "write a length such as 48 mm" */
    double lowest, highest; /* the range, which includes both */
    const char *range;      /* for messages: "0 or more, up to 1e9 m" */
};
#define CSV_ABOVE_0 4.9e-324 /* the lowest value of a range that does not include 0 */

/* The units of lengths, for the members unit, units and usual. */
#define CSV_LENGTH "m", "m, mm, cm, km, in, ft, yd", "mm"

/* A kind of table, such as rows of dominoes, or measurements. */
struct csv_kind {
    const struct csv_column *column;
    int columns;              /* at most CSV_COLUMNS_MOST */
    bool headless;            /* a file without names of columns has these columns in this order */
    size_t rows_most;         /* the largest number of rows */
    const char *item, *items; /* for messages: one row and several rows, "domino" and "dominoes" */
    const char *names;        /* for messages: the columns */
    const char *example;      /* for messages: a first line */
};

/* A table that is being read. Arrays of CSV_COLUMNS_MOST have an element for each column of the kind, and
 * arrays of CSV_CELLS_MOST one for each column of the file. */
struct csv_table {
    const struct csv_kind *kind;
    struct csv_file file;
    char *path;                       /* the name of the file in messages */
    struct csv_record head;           /* the first line */
    struct csv_record units;          /* the line below it, if that has the units; otherwise it has 0 cells */
    struct csv_record row;            /* the current row */
    bool is_read_ahead;               /* `row` has been read ahead, and is the next row */
    size_t rows;                      /* the number of rows that have been read */
    int column[CSV_COLUMNS_MOST];     /* the number of the column in the file, from 1, or 0 */
    domq_real unit[CSV_COLUMNS_MOST]; /* the unit that the file names, or 0 */
    domq_real value[CSV_COLUMNS_MOST]; /* the value in the current row, in SI units, or NaN */
    bool other[CSV_CELLS_MOST];        /* the kind does not have this column */
    char unused[200];                  /* the names of those columns, except notes */
};

/*
 * Reads a file, and the first line of its table. Takes ownership of the path. Returns a table, which may have
 * a problem already, or NULL with errno if there is no memory.
 */
struct csv_table *csv_open(FILE *in, char *path, const struct csv_kind *kind, bool locale_comma);

/* Frees a table, which may be NULL. */
void csv_close(struct csv_table *csv);

/* Reads the next row. Returns false at the end of the table, or with a problem. */
bool csv_next(struct csv_table *csv);

/* Returns the cell of the current row in column k of the kind. A row without this cell has an empty cell at
 * its beginning. */
struct csv_cell csv_cell(const struct csv_table *csv, int k);

/* Returns true if a value is in the range of column k. Otherwise describes the problem. */
bool csv_check(struct csv_table *csv, int k, domq_real value);

/* Writes the other columns of the file, each after a comma: their names, or their cells in the current row.
 */
void csv_write_others(const struct csv_table *csv, bool names, FILE *out);

#endif
