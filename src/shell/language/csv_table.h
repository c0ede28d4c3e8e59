/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Tables in csv files. The first line names the columns, in any order and in any case, and may give their
 * units: "height (mm)", "height [mm]", "height, mm", "height mm" or "height_mm". Alternatively the second
 * line gives the units. A cell is an expression. A unit in a cell takes precedence over the unit of the
 * column. A cell with '-' is empty. A file means the same in every session: it cannot use the variables of
 * the session, and an angle without a unit is in radians.
 */
#ifndef SHELL_CSV_TABLE_H
#define SHELL_CSV_TABLE_H

#include "domino_quad.h"
#include "language/csv.h"

/* A row of dominoes that has been saved must be readable again, with all columns of its kind and all other
 * columns of the original file. */
enum { CSV_COLUMNS_MOST = 16, CSV_OTHERS_MOST = CSV_CELLS_MOST - CSV_COLUMNS_MOST };

/* The traits of a column, as bits. */
enum {
    CSV_REQUIRED = 1,  /* every file must have the column */
    CSV_EMPTY = 2,     /* its cells may be empty */
    CSV_NOT_FIRST = 4, /* the cell in the first row is not used, and may be empty or out of range */
    CSV_WHOLE = 8,     /* its values are whole numbers */
    CSV_BARE = 16,     /* a number without a unit is in the SI unit of the column */
};

/* A column that a table of some kind may have. */
struct csv_column {
    const char *name;
    const char *synonyms; /* synonyms separated by commas, such as "spacing,distance"; may be NULL */
    unsigned traits;
    const char *unit;       /* the SI unit of the values; "" for plain numbers, NULL for text */
    const char *units;      /* for messages: a list of the units that a file may use */
    const char *usual;      /* for messages: the unit to suggest */
    const char *advice;     /* for messages: advice such as "write a length such as 48 mm" */
    double lowest, highest; /* the range, inclusive */
    const char *range;      /* for messages: the range, such as "0 or more, up to 1e9 m" */
};
#define CSV_ABOVE_0 4.9e-324 /* the lower bound on a range that excludes 0 */

/* The units of lengths, for the members unit, units and usual. */
#define CSV_LENGTH "m", "m, mm, cm, km, in, ft, yd", "mm"

/* A kind of table, such as a row of dominoes or a series of measurements. */
struct csv_kind {
    const struct csv_column *column;
    int columns; /* at most CSV_COLUMNS_MOST */
    /* the first line may be missing; the file must then have all columns of the kind, in their order */
    bool headless;
    size_t rows_most; /* the maximum number of rows */
    const char *item,
        /* For messages: what one row and several rows describe, such as "domino" and "dominoes". */
        *items;
    const char *names;   /* for messages: a list of the columns */
    const char *example; /* for messages: an example of a first line */
    /* Another kind to try, or NULL. A file gets the first kind all of whose required columns it has. If no
     * kind fits, the file gets this kind, so that messages are about this kind. */
    const struct csv_kind *otherwise;
};

/* A table that is being read. `kind` is chosen when the first line has been read. Arrays of size
 * CSV_COLUMNS_MOST have one element for each column of the kind, and arrays of size CSV_CELLS_MOST have one
 * element for each column of the file. */
struct csv_table {
    const struct csv_kind *kind;
    struct csv_file file;
    char *path;             /* the name of the file in messages */
    struct csv_record head; /* the first line */
    /* The line below the first line, if it gives units. Otherwise a record without cells. */
    struct csv_record units;
    struct csv_record row; /* the current row */
    bool is_read_ahead;    /* `row` has been read ahead, and is the next row instead of the current one */
    size_t rows;           /* the number of rows that have been read */
    /* The number, from 1, of each column in the file, or 0 if the file does not have the column. */
    int column[CSV_COLUMNS_MOST];
    /* The unit of each column, as a multiple of the SI unit, or 0 if the file gives no unit for the
     * column. */
    domq_real unit[CSV_COLUMNS_MOST];
    domq_real value[CSV_COLUMNS_MOST]; /* the value in the current row, in SI units, or NaN */
    bool other[CSV_CELLS_MOST];        /* true for a column of the file that the kind does not have */
    /* the names of the columns of the file that are ignored, except columns for notes */
    char unused[200];
};

/* Reads a file and parses the first line of its table. Takes ownership of the path unless it returns NULL. If
 * the file is wrong, the returned table has a problem. Returns NULL and sets errno if memory runs out. */
struct csv_table *csv_open(FILE *in, char *path, const struct csv_kind *kind, bool locale_comma);

/* Frees a table, which may be NULL. */
void csv_close(struct csv_table *csv);

/* Reads the next row. Returns false at the end of the table, or with a problem. */
bool csv_next(struct csv_table *csv);

/* Returns the cell of column k of the kind in the current row. If the row has no such cell, returns an empty
 * cell at the beginning of the row. */
struct csv_cell csv_cell(const struct csv_table *csv, int k);

/* Returns true if a value is in the range of a column. Otherwise writes a message. */
enum { CSV_MESSAGE = 256 };
bool csv_fits(const struct csv_column *column, domq_real value, char message[CSV_MESSAGE]);

/* Returns true if a value is in the range of column k. Otherwise reports a problem. */
bool csv_check(struct csv_table *csv, int k, domq_real value);

/* Writes the columns of the file that the kind does not have, each after a comma. If `names` is true, writes
 * their names and units, and otherwise their cells in the current row. */
void csv_write_others(const struct csv_table *csv, bool names, FILE *out);

#endif
