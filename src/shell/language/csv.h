/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Splits csv files, as people and spreadsheets write them, into lines and cells; csv_table.h knows what the
 * cells mean.
 *
 * Cells are separated by ',', ';' or tabs. The first line shows by which of them, or a line "sep=;" above it.
 * A cell between quotes may contain separators and line ends, and '""' stands for a quote there. Lines end
 * with LF, CRLF or CR. A byte order mark, empty lines, and blanks around a cell are skipped. A comment begins
 * with a
 * '#' at the beginning of a line or after a blank.
 *
 * Numbers have a decimal point or a decimal comma. "1,234" might also be 1234. It is a decimal number if ';'
 * separates the cells, if the locale has decimal commas, or if another number in the file can only have a
 * decimal comma. Otherwise it is an error, as is "1.234" in a file with decimal commas.
 */
#ifndef SHELL_CSV_H
#define SHELL_CSV_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/* The most cells of a line, bytes of a line with its line end, and bytes of a file. */
enum { CSV_CELLS_MOST = 76, CSV_LINE_MOST = 65536, CSV_FILE_MOST = 64 << 20 };

/* A place in a file: a line and a character of that line, from 1. */
struct csv_place {
    long line;
    int column;
};

struct csv_cell {
    const char *text; /* without the quotes and blanks around it */
    struct csv_place at;
    bool is_quoted;
};

/* A line of cells, which takes several lines of the file if quotes contain line ends. */
struct csv_record {
    struct csv_cell cell[CSV_CELLS_MOST];
    int cells;
    struct csv_place at;
};

struct csv_file {
    struct csv_problem {
        struct csv_place at;
        char text[640]; /* empty if there is no problem */
    } problem;
    char *text;
    char *next;            /* the first character of the text that has not been read */
    struct csv_place at;   /* the place of that character */
    bool after_blank;      /* a blank or a line end is before that character */
    const char *cut_short; /* why the text is not the whole file; NULL if it is */
    char separator;        /* 0 until it is known */
    bool locale_comma;     /* the locale has decimal commas */
    /* What the numbers so far show about decimal points and decimal commas. */
    struct csv_mark {
        bool is_used;
        bool is_clear;            /* in some number this mark can only be the decimal mark */
        struct csv_place at;      /* the first number where it might separate thousands; its line may be 0 */
        char before[4], after[4]; /* the digits of that number */
    } point, comma;
};

/* Describes a problem. Returns false. */
bool csv_wrong(struct csv_file *file, struct csv_place at, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* Reads the text of a file, which the caller frees. Returns false with a problem. */
bool csv_load(struct csv_file *file, FILE *in);

/* Reads the next record that is not empty. Returns false at the end of the file, or with a problem. */
bool csv_read(struct csv_file *file, struct csv_record *record);

/* Returns the name of the separator in messages: "','", "';'" or "tab". */
const char *csv_separator_name(const struct csv_file *file);

/* Replaces decimal commas in the text of a cell by points. Returns false with a problem. */
bool csv_marks_read(struct csv_file *file, struct csv_place at, char *text);

/* After the last number: returns false, and describes the problem, if a number has two meanings. */
bool csv_marks_check(struct csv_file *file);

/* Writes a cell, between quotes if it has one of the characters `quoted`. Escapes control characters except
 * line ends and tabs. */
void csv_write(FILE *out, const char *text, const char *quoted);

#endif
