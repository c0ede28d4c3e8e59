/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Tables in csv files, as people and spreadsheets write them.
 *
 * The cells of a line are separated by ',', ';' or tabs: the first line decides, or a line "sep=;" above it.
 * A cell between quotes may contain separators, line ends, and '""' for a quote.  A line ends with LF, CRLF
 * or CR.  A byte order mark, empty lines and blanks around a cell do not count, and a '#' at the beginning of
 * a line or after a blank begins a comment.
 *
 * The first line names the columns, in any order and in any case, and their units: "height (mm)", "height
 * [mm]", "height, mm", "height mm" or "height_mm"; or the line below it has the units.  A cell is an
 * expression, and a unit of its own counts; '-' is an empty cell.  A file means the same in every session:
 * names of a session have no value in it, and a bare angle is in radians.
 *
 * A number has a decimal point or a decimal comma.  "1,234" might also be 1234: it has a decimal comma if ';'
 * separates the cells, if the locale has decimal commas, or if another number of the file can have no other
 * meaning; else it is an error.  So is "1.234" in a file with decimal commas.
 */
#ifndef SHELL_CSV_H
#define SHELL_CSV_H

#include "domino_quad.h"
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

enum { CSV_CELLS_MOST = 64, CSV_LINE_MOST = 65536, CSV_FILE_MOST = 64 << 20, CSV_COLUMNS_MOST = 12 };

/* A place in a file: lines and columns count from 1, and a column is a character. */
struct csv_place {
    long line;
    int column;
};

struct csv_problem {
    struct csv_place at;
    char text[640]; /* "" while nothing is wrong */
};

/* ---- Kinds of tables ---- */

/* Properties of a column. */
enum {
    CSV_REQUIRED = 1,    /* each file has it */
    CSV_EMPTY = 2,       /* its cells may be empty */
    CSV_NOT_FIRST = 4,   /* its first cell may be empty, or out of range */
    CSV_ZERO = 8,        /* 0 is in the range */
    CSV_NEGATIVE = 16,   /* the range is that of the absolute value */
    CSV_WHOLE = 32,      /* only whole numbers are in the range */
    CSV_UNIT_KNOWN = 64, /* a number without a unit is in the unit of the column */
    CSV_TEXT = 128,      /* its cells are text */
};

/* A column that tables of a kind may have. */
struct csv_column {
    const char *name, *also; /* its synonyms, as "spacing,distance"; NULL for none */
    unsigned is;
    const char *unit, *units, *usual; /* of its values, in SI, or ""; all, and the usual one, for messages */
    const char *write;                /* for messages: "write a length such as 48 mm" */
    double lowest, highest;           /* values are above 0, and in this range */
    const char *range;
};

struct csv_kind {
    const struct csv_column *column;
    int columns;           /* at most CSV_COLUMNS_MOST */
    bool headless;         /* the first line may be missing: the columns are then those of the table */
    size_t most;           /* the number of rows is at most this */
    const char *row, *all; /* what a row is, "domino", and what several are, "dominoes" */
    const char *names;     /* what the first line names, for messages */
    const char *example;   /* a first line */
};

/* ---- Reading ---- */

struct csv_cell {
    const char *text; /* without its quotes, and without blanks around it */
    struct csv_place at;
    bool quoted;
};

/* A line, or several lines if a cell between quotes contains line ends. */
struct csv_record {
    struct csv_cell cell[CSV_CELLS_MOST];
    int cells;
    struct csv_place at;
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
    struct csv_problem problem;
    char *path, *text, *next; /* the file, and its part that has not been read yet, which is at this place */
    struct csv_place at;
    const char *cut_short; /* why the text is not the whole file, or NULL */
    char separator;        /* 0 until it is known */
    struct csv_record head, units, row;
    bool pending;                 /* `row` is the next row already */
    size_t rows;                  /* read so far */
    int column[CSV_COLUMNS_MOST]; /* where the file has each column of the table, from 1; 0 if it does not */
    domq_real unit[CSV_COLUMNS_MOST];  /* that the first line has; 0 for none */
    domq_real value[CSV_COLUMNS_MOST]; /* of each column of the table in this row, in SI; NaN if the cell is
                                          empty */
    bool other[CSV_CELLS_MOST];        /* the column of the file is not in the table */
    char unused[200];                  /* the names of these, but for notes; "" for none */
    bool locale_comma;                 /* the locale has decimal commas */
    struct csv_mark point, comma;
};

/*
 * Reads a file and the first line of its table.  The path is for messages, and is freed with the table.
 * Returns a table that may have a problem already; NULL with errno if there is no memory for one.
 */
struct csv_table *csv_open(FILE *in, char *path, const struct csv_kind *kind, bool locale_comma);
void csv_close(struct csv_table *csv); /* which may be NULL */

/* Reads the next row into csv->value.  Returns false at the end of the table, or with a problem. */
bool csv_next(struct csv_table *csv);

/* Return the text of the cell that this row has in a column of the table, "" if there is none; and its place,
 * or that of the row if there is none or the column is -1. */
const char *csv_text(const struct csv_table *csv, int k);
struct csv_place csv_at(const struct csv_table *csv, int k);

/* Describes a problem, and returns false. */
bool csv_wrong(struct csv_table *csv, struct csv_place at, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* Returns true if a value is in the range of a column of the table; else describes the problem. */
bool csv_check(struct csv_table *csv, int k, domq_real value);

/* ---- Lines and cells ---- */

/* Loads a file; false if there is no memory, or it cannot be read. */
bool csv_load(struct csv_table *csv, FILE *in);

/* Reads the next record that is not empty.  Returns false at the end of the file, or with a problem. */
bool csv_read(struct csv_table *csv, struct csv_record *record);

/* Returns how messages name the separator: "','", "';'" or "tab". */
const char *csv_separator_name(const struct csv_table *csv);

/* Writes a cell: between quotes if it has one of these characters, and with control characters escaped other
 * than line ends and tabs. */
void csv_write(FILE *out, const char *text, const char *quoted);

/* Writes, each after a comma, the names of the columns that are not in the table, or what this row has there.
 */
void csv_write_others(const struct csv_table *csv, bool names, FILE *out);

#endif
