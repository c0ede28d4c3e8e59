/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Splits csv files into lines and cells, which csv_table.h interprets.
 * - The separator is ',', ';' or a tab. The first line of the table shows which one. A line "sep=;" above it
 *   may also name the separator.
 * - A quoted cell may contain separators and newlines. Within the quotes, '""' stands for one quote.
 * - Lines end with LF, CRLF or CR.
 * - A byte order mark, empty lines, and blanks around a cell are skipped.
 * - A '#' at the beginning of a line or after a blank begins a comment.
 *
 * Numbers have a decimal point or a decimal comma. The number "1,234" is ambiguous, because its comma could
 * be a thousands separator. It is read as 1.234 if no number in the file has a decimal point, and if one of
 * these conditions holds:
 * - The separator is ';'.
 * - The locale has decimal commas.
 * - Some other number in the file makes sense only with a decimal comma.
 * Otherwise "1,234" is an error. In a file with decimal commas, "1.234" is an error.
 */
#ifndef SHELL_CSV_H
#define SHELL_CSV_H

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
    bool is_quoted;
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
    bool after_blank;      /* the character before `next` is a blank or a newline */
    const char *cut_short; /* the reason why `text` is only the beginning of the file, or NULL if it is the
                              whole file */
    char separator;        /* the separator of cells, or 0 until it is known */
    bool locale_comma;
    /* How the numbers that have been read so far use '.' and ','. */
    struct csv_mark {
        bool is_used;
        /* true if at least one number can only be read with this character as the decimal mark */
        bool is_clear;
        /* The place of the first ambiguous number. A number is ambiguous if its decimal mark could be a
         * thousands separator. If there is no such number, at.line is 0. */
        struct csv_place at;
        char before[4], after[4]; /* the digits on the two sides of the mark in the ambiguous number */
    } point, comma;
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

/* Replaces the decimal commas in the text of a cell by points, so that the numbers can be read. Records which
 * decimal marks the numbers use, so that csv_marks_check can find ambiguous numbers. `at` is the position of
 * the cell. */
bool csv_marks_read(struct csv_file *file, struct csv_place at, char *text);

/* Must be called after the last number. If a number such as "1,234" is still ambiguous, this is an error. */
bool csv_marks_check(struct csv_file *file);

/* Writes a cell. If the cell contains one of the characters in `quoted`, it is put in quotes. Control
 * characters, invisible characters and bytes that are not UTF-8 become escape sequences, as in escape.h. Only
 * newlines and tabs are written unchanged. */
void csv_write(FILE *out, const char *text, const char *quoted);

#endif
