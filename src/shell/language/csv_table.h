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

/* How many columns a kind of table has at most, and how many others a file may have: both are read back. */
enum { CSV_COLUMNS_MOST = 12, CSV_OTHERS_MOST = CSV_CELLS_MOST - CSV_COLUMNS_MOST };

/* Properties of a column: each file has it; its cells may be empty; its first cell may be empty or out of
 * range; its values are whole numbers. */
enum { CSV_REQUIRED = 1, CSV_EMPTY = 2, CSV_NOT_FIRST = 4, CSV_WHOLE = 8 };

/* A column that a kind of table may have; the texts are for messages. */
struct csv_column {
    const char *name, *also; /* its synonyms, as "spacing,distance"; NULL for none */
    unsigned is;
    const char *unit, *units, *usual; /* of its values, in SI, "" for plain numbers, NULL for text; all that a
                                         file may have; and the one that is proposed */
    const char *write;                /* "write a length such as 48 mm" */
    double lowest, highest;           /* values, of which 0 is CSV_ABOVE_0 */
    const char *range;                /* "0 or more, up to 1e9 m" */
};
#define CSV_ABOVE_0 4.9e-324 /* the lowest value of a range that begins above 0 */

struct csv_kind {
    const struct csv_column *column;
    int columns;           /* at most CSV_COLUMNS_MOST */
    bool headless;         /* the first line may be missing: the columns are then these, in this order */
    size_t most;           /* rows */
    const char *row, *all; /* what a row is, "domino", and what several are, "dominoes" */
    const char *names;     /* what the first line names, for messages */
    const char *example;   /* a first line */
};

/* What is known of decimal points, or of decimal commas. */
struct csv_mark {
    bool seen, sure;          /* sure: in some number the mark can only be a decimal one */
    struct csv_place at;      /* of the first number in which it might separate thousands; line 0 for none */
    char before[4], after[4]; /* the digits of that number */
};

/* A table that is being read. */
struct csv_table {
    const struct csv_kind *kind;
    struct csv_file file;
    char *path; /* of the file, for messages */
    struct csv_record head, units, row;
    bool pending;                      /* the row has been read, and is the next one */
    size_t rows;                       /* that were read */
    int column[CSV_COLUMNS_MOST];      /* where the file has each column of its kind, from 1; 0 for nowhere */
    domq_real unit[CSV_COLUMNS_MOST];  /* of each, by the first lines; 0 for none */
    domq_real value[CSV_COLUMNS_MOST]; /* of each in this row, in SI; NaN if its cell is empty */
    bool other[CSV_CELLS_MOST];        /* the column of the file is not one of its kind */
    char unused[200];                  /* the names of these, but for notes; "" for none */
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

/* Writes, each after a comma, the names of the other columns, or what this row has there. */
void csv_write_others(const struct csv_table *csv, bool names, FILE *out);

#endif
