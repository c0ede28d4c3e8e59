/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Tables in csv files.  The first line names the columns, in any order and in any case, and their units:
 * "height (mm)", "height [mm]", "height, mm", "height mm" or "height_mm"; or the line below it has the units.
 * A cell is an expression, and a unit of its own counts; '-' is an empty cell.  A file means the same in
 * every session: names of a session have no value in it, and a bare angle is in radians.
 *
 * A number has a decimal point or a decimal comma.  "1,234" might also be 1234: it has a decimal comma if ';'
 * separates the cells, if the locale has decimal commas, or if another number of the file can have no other
 * meaning; else it is an error.  So is "1.234" in a file with decimal commas.
 */
#ifndef SHELL_CSV_TABLE_H
#define SHELL_CSV_TABLE_H

#include "domino_quad.h"
#include "language/csv.h"

/* A row that is saved has all columns of its kind and the others of its file, and can be read again. */
enum { CSV_COLUMNS_MOST = 12, CSV_OTHERS_MOST = CSV_CELLS_MOST - CSV_COLUMNS_MOST };

/* The traits of a column. */
enum {
    CSV_REQUIRED = 1,  /* every file has it */
    CSV_EMPTY = 2,     /* its cells may be empty */
    CSV_NOT_FIRST = 4, /* the first row needs no value there, and any value is in range */
    CSV_WHOLE = 8,     /* its values are whole numbers */
};

/* A column that tables of a kind may have. */
struct csv_column {
    const char *name;
    const char *synonyms; /* "spacing,distance", or NULL */
    unsigned traits;
    const char *unit;       /* the SI unit of the values; "" for plain numbers, NULL for text */
    const char *units;      /* for messages: all units that a file may use */
    const char *usual;      /* for messages: the unit to propose */
    const char *advice;     /* for messages: "write a length such as 48 mm" */
    double lowest, highest; /* the range of the values, with both ends */
    const char *range;      /* for messages: "0 or more, up to 1e9 m" */
};
#define CSV_ABOVE_0 4.9e-324 /* the lower end of a range without 0 */

/* A kind of table: of rows, of measurements. */
struct csv_kind {
    const struct csv_column *column;
    int columns;              /* at most CSV_COLUMNS_MOST */
    bool headless;            /* a file may begin with its first row: it has these columns in this order */
    size_t rows_most;         /* the largest number of rows */
    const char *item, *items; /* for messages: what one row is, "domino", and what several are, "dominoes" */
    const char *names;        /* for messages: what the first line names */
    const char *example;      /* for messages: a first line */
};

/* What the numbers so far say about the decimal point, or about the decimal comma. */
struct csv_mark {
    bool seen;           /* some number has this mark */
    bool sure;           /* in some number it cannot separate thousands */
    struct csv_place at; /* the first number in which it might separate thousands; line 0 if there is none */
    char before[4], after[4]; /* the digits of that number */
};

/* A table that is being read. */
struct csv_table {
    const struct csv_kind *kind;
    struct csv_file file;
    char *path;                         /* the name of the file in messages */
    struct csv_record head, units, row; /* units: the line below the names, if it has units; else 0 cells */
    bool pending;                       /* `row` has been read already, and is the next row */
    size_t rows;                        /* the number of rows that have been read */
    int column[CSV_COLUMNS_MOST];      /* for each column of the kind: its number in the file, from 1, or 0 */
    domq_real unit[CSV_COLUMNS_MOST];  /* for each column of the kind: the unit that the file names, or 0 */
    domq_real value[CSV_COLUMNS_MOST]; /* for each column of the kind: its value in this row, in SI, or NaN */
    bool other[CSV_CELLS_MOST];        /* for each column of the file: the kind does not have it */
    char unused[200];                  /* the names of these columns, except those of notes; "" for none */
    bool locale_comma;                 /* the locale has decimal commas */
    struct csv_mark point, comma;
};

/*
 * Reads a file and the first line of its table; the path is freed with the table.  Returns a table that may
 * have a problem already, or NULL with errno if there is no memory for one.
 */
struct csv_table *csv_open(FILE *in, char *path, const struct csv_kind *kind, bool locale_comma);
void csv_close(struct csv_table *csv); /* which may be NULL */

/* Reads the next row.  Returns false at the end of the table, or with a problem. */
bool csv_next(struct csv_table *csv);

/* Returns the cell of this row in column k of its kind: an empty one, at the place of the row, if it has
 * none, or if k is -1. */
struct csv_cell csv_cell(const struct csv_table *csv, int k);

/* Returns true if a value is in the range of column k; else describes the problem. */
bool csv_check(struct csv_table *csv, int k, domq_real value);

/* Writes the names of the columns that the kind does not have, or what this row has there, each after a
 * comma.
 */
void csv_write_others(const struct csv_table *csv, bool names, FILE *out);

#endif
