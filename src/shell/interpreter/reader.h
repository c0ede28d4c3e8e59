/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The reader: how far a line has been parsed, and the words that follow. */
#ifndef SHELL_READER_H
#define SHELL_READER_H

#include "interpreter/command.h"
#include "language/text.h"

enum { OFFER_LISTS = 8 };

/* What can follow besides names and values. */
enum offer_kind { OFFER_FILE = 1, OFFER_UNIT = 2, OFFER_VARIABLE = 4 };

/*
 * What may follow in a line that is being typed. Such a line is parsed with a cursor at its end, a character
 * that no parser accepts, and every function that tries to read at the cursor records here what it would
 * have accepted. Completion, hints and colours show what is recorded.
 */
struct offer {
    const char *cursor;
    int lists; /* number of lists that a name was looked up in */
    names_list *names[OFFER_LISTS];
    const void *context[OFFER_LISTS];
    struct argument value; /* the argument that an expression would give; ARGUMENT_NONE if none would */
    bool is_inside;        /* the expression has begun before the cursor */
    unsigned kinds;        /* bits of enum offer_kind */
    const struct command *command;     /* the command with an argument at the cursor, or NULL */
    int argument;                      /* index of that argument */
    const struct parameter *parameter; /* the parameter or effect that gets a value at the cursor, or NULL */
    size_t typed;                      /* typed length of the last command's name, which may be abbreviated */
    bool *is_command; /* If not NULL, the bytes that belong to a command's name are set to true. */
};

struct reader {
    const struct query *query; /* the state whose names are known */
    struct problem *problem;
    const struct text *text; /* the line, or NULL for the text of a function, where problems have no place */
    const char *at;          /* the next character */
    struct arena *arena;     /* memory of the trees */
    const char *stops;       /* more characters that end a word or value, such as ",:" in a grid, or NULL */
    const char *no_unit;     /* letters that are names, and not units, when they follow a blank; or NULL */
    bool unresolved;         /* Names in expressions are resolved later. */
    bool evaluates;          /* Each value is also computed and checked. */
    bool last;               /* No other argument follows the one that is read. */
    struct offer *offer;     /* NULL for a line that is run */
};

/* Record what may stand where the reader is, if that is the cursor. */
void offer_kind(const struct reader *reader, enum offer_kind kind);
void offer_names(const struct reader *reader, names_list *list, const void *context);
void offer_value(const struct reader *reader, const struct argument *argument, bool is_inside);

/* Returns the record of the line if the reader is at its cursor, else NULL. */
struct offer *reader_offer(const struct reader *reader);

/* Records that a command's name was typed between these places. */
void reader_named(const struct reader *reader, const char *begin, const char *end);

/* Sets the place in the line that the next problem is about. */
void reader_place(const struct reader *reader, const char *at);

/* Returns true at the end of a command; a '#' here begins a comment. */
bool command_ends(const char *c);

/* Skips blanks. Returns true if no argument follows: at the end of the command, at '>', '|', 'with' or a
 * stop. */
bool reader_ends(struct reader *reader);

/* Returns true if this whole word is next. */
bool word_is_next(const struct reader *reader, const char *word);

/* If this whole word is next, skips it and the blanks after it, and returns true. */
bool reader_takes(struct reader *reader, const char *word);

/*
 * Reads a word, which ends at a blank, or, if `quotes` is true, a text between "...", in which '""' stands
 * for one '"'. The result is in the arena. Returns NULL if a '"' is never closed or memory is short.
 */
char *read_word(struct reader *reader, bool quotes);
extern const char unclosed[];

/* Reads a word or a quoted text as it was typed: its Greek letters are not replaced by their names. */
char *read_text(struct reader *reader);

/* Reads the name of a file. A '~' at its beginning is the home folder. */
char *read_file(struct reader *reader);

#endif
