/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Splits csv files into lines and cells, which csv_table.h interprets.
 * - The separator is ';', a tab or ','. The first line of the table shows which one. A line "sep=;" above it
 *   may also name the separator.
 * - A quoted cell may contain separators and newlines. Within the quotes, '""' stands for one quote.
 * - Lines end with LF, CRLF or CR.
 * - A byte order mark, empty lines, and blanks around a cell are skipped.
 * - A line that begins with '#' is a comment.
 * - The decimal mark is a point, or a comma in a file whose separator is ';' or a tab, or in a quoted cell. A
 * mark that could be a thousands separator is an error.
 */
#ifndef TABLES_CSV_H
#define TABLES_CSV_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/* The maximum number of cells and bytes in a line, and of bytes in a file. */
enum { CSV_CELLS_MOST = 80, CSV_LINE_MOST = 65536, CSV_FILE_MOST = 64 << 20 };

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
    bool has_comma;        /* a number above has a decimal comma */
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

/* Replaces the decimal commas in the text of a cell by points, so that the numbers can be read. `at` is the
 * position of the cell. */
bool csv_marks_read(struct csv_file *file, struct csv_place at, char *text);

#endif
