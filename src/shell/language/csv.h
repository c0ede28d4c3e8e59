/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The lines and cells of csv files, as people and spreadsheets write them; csv_table.h knows what they mean.
 *
 * The cells of a line are separated by ',', ';' or tabs: the first line decides, or a line "sep=;" above it.
 * A cell between quotes may contain separators, line ends, and '""' for a quote.  A line ends with LF, CRLF
 * or CR.  A byte order mark, empty lines and blanks around a cell do not count, and a '#' at the beginning of
 * a line or after a blank begins a comment.
 */
#ifndef SHELL_CSV_H
#define SHELL_CSV_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/* Limits: the cells of a line, the bytes of a line with its end, and the bytes of a file. */
enum { CSV_CELLS_MOST = 76, CSV_LINE_MOST = 65536, CSV_FILE_MOST = 64 << 20 };

/* A place in a file: lines and columns count from 1, and a column is a character. */
struct csv_place {
    long line;
    int column;
};

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

/* A file that is being read. */
struct csv_file {
    struct csv_problem {
        struct csv_place at;
        char text[640]; /* "" while nothing is wrong */
    } problem;
    char *text, *next; /* next: what has not been read of the text, at this place */
    struct csv_place at;
    bool blank;            /* a blank or a line end is before it */
    const char *cut_short; /* why the text is not the whole file, or NULL */
    char separator;        /* 0 until it is known */
};

/* Describes a problem, and returns false. */
bool csv_wrong(struct csv_file *file, struct csv_place at, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* Reads the text of a file, which the caller frees.  Returns false with a problem. */
bool csv_load(struct csv_file *file, FILE *in);

/* Reads the next record that is not empty.  Returns false at the end of the file, or with a problem. */
bool csv_read(struct csv_file *file, struct csv_record *record);

/* Returns how messages name the separator: "','", "';'" or "tab". */
const char *csv_separator_name(const struct csv_file *file);

/* Writes a cell, between quotes if it has one of these characters. Control characters but line ends and tabs
 * are escaped. */
void csv_write(FILE *out, const char *text, const char *quoted);

#endif
