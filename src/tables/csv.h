/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Tables in csv files. A file consists of cells:
 * - The separator is ';', a tab or ','. The first line of the table shows which one. A line "sep=;" above it
 *   may also name the separator.
 * - A quoted cell may contain separators and newlines. Within the quotes, '""' stands for one quote.
 * - Lines end with LF, CRLF or CR.
 * - A byte order mark, empty lines, and blanks around a cell are skipped.
 * - A line that begins with '#' is a comment.
 * - The decimal mark is a point, or a comma in a file whose separator is ';' or a tab. A file has only one of
 *   them, and no marks between thousands.
 *
 * The cells make a table:
 * - The first line names the columns, in any order, in English, German, Dutch or French. Case and accents
 *   make no difference.
 * - The first line may give units: "height (mm)", "height [mm]", "height, mm", "height mm", "height_mm" or
 *   "height in mm".
 * - A measurement may have several numbered columns, such as "speed 1 (m/s)" and "speed 2 (m/s)", or "trial 1
 *   (m/s)" and "trial 2 (m/s)". Its value is then their mean. A column "average speed" is not used beside
 * them.
 * - A cell is an expression. A cell that contains only a dash counts as empty. If a cell has a unit, the unit
 *   of the column does not apply to the cell.
 * - A file means the same in every session. It cannot use variables, and angles without a unit are in
 *   radians.
 */
#pragma once

#include "language/names.h"
#include "session/query.h"

/* The maximum number of cells in a line, and of bytes in a file. */
enum { CSV_CELLS_MOST = 80, CSV_FILE_MOST = 64 << 20 };

/* A line of a file, and a character of this line. Both count from 1. */
struct csv_place {
    long line;
    int column;
};

struct csv_cell {
    const char *text; /* the contents of the cell without the quotes and blanks around them */
    struct csv_place at;
};

/* A line of cells. A record spans several lines of the file if a quoted cell contains newlines. */
struct csv_record {
    struct csv_cell cell[CSV_CELLS_MOST];
    int cells;
    struct csv_place at;
};

struct csv_file {
    struct csv_problem {
        struct csv_place at;
        char text[640]; /* the message, or "" if there is no problem */
    } problem;
    char *text;
    char *next;            /* the next character of the text to be read */
    struct csv_place at;   /* the position of the character at `next` */
    const char *cut_short; /* the reason why `text` is only the beginning of the file, or NULL if it is the
                              whole file */
    char separator;        /* the separator of cells, or 0 until it is known */
    char mark;             /* the decimal mark of the numbers above, or 0; only if ',' is no separator */
};

/* Sets the message and position of the file's problem. Returns false. */
bool csv_wrong(struct csv_file *file, struct csv_place at, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* After an error, the functions below set file->problem and return false. */

/* Reads a whole file into file->text, which the caller frees. */
bool csv_load(struct csv_file *file, FILE *in);

/* Reads the next record that is not empty. Returns false at the end of the file. */
bool csv_read(struct csv_file *file, struct csv_record *record);

/* Returns the name that messages use for the separator: "','", "';'" or "tab". */
const char *csv_separator_name(const struct csv_file *file);

/* Replaces the decimal commas in the text of a cell by points. In a file whose separator is ',' there are
 * none. All numbers of a file must have the same decimal mark, so that a mark between thousands is an error.
 */
bool csv_marks_read(struct csv_file *file, struct csv_place at, char *text);

/* ---- Kinds of tables ---- */

/* The maximum number of columns that a kind of table knows. A file may also have unknown columns. */
enum { CSV_COLUMNS_MOST = 16 };

/* Properties of a column, as bits. */
enum {
    CSV_REQUIRED = 1,  /* every file must have this column */
    CSV_EMPTY = 2,     /* the cells of the column may be empty */
    CSV_NOT_FIRST = 4, /* the cell of the first row may be empty or out of range */
    CSV_WHOLE = 8,     /* the values of the column are whole numbers */
    CSV_BARE = 16,     /* a number without a unit is in the SI unit of the column */
    CSV_ONE_OF = 32,   /* at most one of the columns with this property may occur, and one must occur if any
                          of them is required */
    CSV_ONE_OF_2 = 64, /* the same for two other groups of columns */
    CSV_ONE_OF_3 = 128,
    CSV_GROUPS = CSV_ONE_OF | CSV_ONE_OF_2 | CSV_ONE_OF_3,
    CSV_REPEATED = 256, /* the column may occur several times; at most one column has this property */
};

/* A column that a kind of table may have. */
struct csv_column {
    const char *name;
    unsigned traits;
    const char *unit;       /* the SI unit of the values; "" for plain numbers */
    const char *units;      /* for messages: a list of the units that a file may use */
    const char *usual;      /* for messages: the unit to suggest */
    const char *advice;     /* advice for messages, for example "write a length such as 48 mm" */
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
    const char *names; /* for messages: a list of the names of the columns */
    /* If the file lacks a required column of this kind, the table may be of the kind `otherwise`, which is
     * tried next. NULL if there is no other kind. If no kind fits, messages are about the first kind that was
     * tried. */
    const struct csv_kind *otherwise;
};

/* ---- Tables ---- */

/* A table that is being read. The arrays `column` and `value` have an element for each column in
 * kind->column. */
struct csv_table {
    const struct csv_kind *kind; /* chosen when the first line has been read */
    struct csv_file file;
    char *path;             /* the path of the file, for messages */
    struct csv_record head; /* the first line */
    struct csv_record row;  /* the current row */
    size_t rows;            /* the number of rows that have been read */
    /* The position of each column in the file, counted from 1, or 0 if the file does not have the column. */
    int column[CSV_COLUMNS_MOST];
    domq_real value[CSV_COLUMNS_MOST]; /* the values of the current row, in SI units, or NaN */
    int trials;                        /* how many numbered columns the repeated measurement has */
    int repeated;                      /* how many of their cells are not empty in the current row */
    /* The sum of the squares of their deviations from their mean, each divided by the mean, over all rows so
     * far, and how many of these cells there are beyond the first of each row. */
    domq_real squares;
    int freedom;
    int of[CSV_CELLS_MOST]; /* for each column of the file its column of the kind, or -1 if it is unknown */
    /* The unit of each column of the file, as a multiple of the SI unit, or 0 if the file gives none. */
    domq_real unit[CSV_CELLS_MOST];
    /* the names of the unknown columns of the file, except columns of notes */
    char unused[200];
};

/* Reads a file and interprets the first line of its table. The table then owns the path. If there is an
 * error in the file, the table holds the problem. If memory runs out, returns NULL and sets errno. */
struct csv_table *csv_open(FILE *in, char *path, const struct csv_kind *kind);

/* Frees a table, which may be NULL. */
void csv_close(struct csv_table *csv);

/* Reads the next row. Returns false at the end. After an error, sets the file's problem and returns false. */
bool csv_next(struct csv_table *csv);

/* Returns the cell of column k in the current row. If the row is too short or the file does not have this
 * column, returns an empty cell, whose position is the beginning of the row. */
struct csv_cell csv_cell(const struct csv_table *csv, int k);

/* Returns true if a value is in the range of a column. Otherwise writes a message and returns false. */
enum { CSV_MESSAGE = 256 };
bool csv_fits(const struct csv_column *column, domq_real value, char message[CSV_MESSAGE]);

/* Returns true if a value is in the range of column k. Otherwise sets the file's problem. */
bool csv_check(struct csv_table *csv, int k, domq_real value);

/* Opens a csv file and reads the first line of its table. The file may be beside the running script, or else
 * in the current directory. On failure, sets *problem and returns NULL. */
struct csv_table *csv_named(const struct run_context *run_context, const char *name,
                            const struct csv_kind *kind, struct problem *problem);

/* Closes a table after it has been read. Returns true if there was no error. Otherwise copies the error from
 * the table to *problem and returns false. If `csv` is NULL, only returns false. */
bool csv_end(struct csv_table *csv, struct problem *problem);
