/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Tables in csv files.
 * - The first line names the columns, in any order, in English, German, Dutch or French. Case and accents
 * make no difference.
 * - The first line may give units: "height (mm)", "height [mm]", "height, mm", "height mm", "height_mm",
 *   "height/mm" or "height in mm". The second line may also give them.
 * - A cell is an expression. A cell that contains only a dash counts as empty. If a cell has a unit or a
 *   per cent sign, the unit of the column does not apply to the cell.
 * - A measurement may have several columns, such as "speed 1 (m/s)" and "speed 2 (m/s)", or "trial 1 (m/s)"
 *   and "trial 2 (m/s)". Its value is then their mean. A column "average speed" is not used beside them.
 * - A file means the same in every session. It cannot use variables, and angles without a unit are in
 *   radians.
 */
#ifndef TABLES_CSV_TABLE_H
#define TABLES_CSV_TABLE_H

#include "domino_quad.h"
#include "tables/csv.h"
#include "tables/csv_names.h"
#include <signal.h>

/* A table that is being read. The arrays `column`, `unit` and `value` have an element for each column in
 * kind->column. */
struct csv_table {
    const struct csv_kind *kind; /* chosen when the first line has been read */
    struct csv_file file;
    char *path;             /* the path of the file, for messages */
    struct csv_record head; /* the first line */
    /* The second line, if this line gives the units. Otherwise a record without cells. */
    struct csv_record units;
    struct csv_record row; /* the current row */
    bool is_read_ahead;    /* `row` has been read ahead: it is the next row, not the current one */
    size_t rows;           /* the number of rows that have been read */
    /* The position of each column in the file, counted from 1, or 0 if the file does not have the column. */
    int column[CSV_COLUMNS_MOST];
    /* The unit of each column, as a multiple of the SI unit, or 0 if the file gives none. */
    domq_real unit[CSV_COLUMNS_MOST];
    domq_real value[CSV_COLUMNS_MOST];      /* the values of the current row, in SI units, or NaN */
    bool repeats[CSV_CELLS_MOST];           /* true for each column of a measurement with several columns */
    int repeated;                           /* how many values the current row has in these columns */
    domq_real squares;                      /* the sum of the squares of their deviations from the mean */
    bool other[CSV_CELLS_MOST];             /* true for each unknown column of the file */
    const volatile sig_atomic_t *interrupt; /* once this flag is raised, no more rows are read; may be NULL */
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

/* Writes the unknown columns of the file. Each of them is preceded by a comma. If `names` is true, writes the
 * names and units of the columns. Otherwise writes their cells in the current row. */
void csv_write_others(const struct csv_table *csv, bool names, FILE *out);

#endif
