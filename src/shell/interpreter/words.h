/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The words of a line: up to a blank, between quotes, as they were typed, or as the name of a file. */
#ifndef SHELL_WORDS_H
#define SHELL_WORDS_H

#include "interpreter/command.h"
#include "language/text.h"

enum { OFFER_LISTS = 8 };

/* Other things than names and values that a line may go on with. */
enum offer_kind { OFFER_FILE = 1, OFFER_UNIT = 2, OFFER_VARIABLE = 4 };

/*
 * What a line that is being typed may go on with. The line is parsed with a cursor at its end, a character
 * that no parser accepts, and each function that reads at the cursor records here what it would have read.
 * Completion, hints and colours all show what is recorded.
 */
struct offer {
    const char *cursor;
    int lists; /* the lists of names that were looked for */
    names_list *names[OFFER_LISTS];
    const void *context[OFFER_LISTS];
    struct argument value; /* the argument that an expression may give; its kind may be ARGUMENT_NONE */
    bool is_inside;        /* the cursor is inside that expression, and not where it begins */
    unsigned kinds;        /* bits of enum offer_kind */
    const struct command *command; /* the command whose argument the cursor is at, or NULL */
    int argument;
    const struct parameter *parameter; /* the parameter or effect that gets a value at the cursor, or NULL */
    size_t typed;     /* length of the last command's name as it was typed, which may be a beginning */
    bool *is_command; /* unless NULL, marks each byte of the line that belongs to the name of a command */
};

/* The place of reading in a line that is being run. */
struct reader {
    const struct query *query; /* gives values to names */
    struct problem *problem;
    const struct text *text; /* NULL: problems have the place that they have */
    const char *at;
    struct arena *arena; /* of what is parsed */
    const char *stops;   /* characters that also end a word or value, as ',' and ':' in a grid; else NULL */
    const char *no_unit; /* letters that are names after a value, and no units; NULL for none */
    bool unresolved;     /* names in expressions get their meaning later */
    bool evaluates;      /* each value is also computed and checked, at once */
    bool last;           /* the argument that is read is the command's last */
    struct offer *offer; /* NULL unless the line is being typed */
};

/* Record what may stand where the reader is, if the cursor is there. */
void offer_kind(const struct reader *reader, enum offer_kind kind);
void offer_names(const struct reader *reader, names_list *list, const void *context);
void offer_value(const struct reader *reader, const struct argument *argument, bool is_inside);

/* Returns the record if the reader is at the cursor; NULL elsewhere, and in a line that is run. */
struct offer *reader_offer(const struct reader *reader);

/* Records that the name of a command was typed here. */
void reader_named(const struct reader *reader, const char *begin, const char *end);

int reader_column(const struct reader *reader, const char *place);

/* Returns true if the command ends here. Comments begin at a blank. */
bool command_ends(const char *c);

/* Passes blanks. Returns true if the arguments end there: at the end of the command, '>', '|', 'with', or a
 * stop. */
bool reader_ends(struct reader *reader);

/* Returns true if exactly this word is next. */
bool word_is_next(const struct reader *reader, const char *word);

/* Passes exactly this word and the blanks after it, if it is next. */
bool reader_takes(struct reader *reader, const char *word);

/*
 * Reads a run of characters without blanks, or the text between "...", where '""' is one '"'; it is in the
 * arena. NULL: a '"' is never closed, or there is no memory.
 */
char *read_word(struct reader *reader, bool quotes);
extern const char unclosed[];

/* Reads a word that keeps its bytes: Greek letters in it are not replaced, as they are in commands. */
char *read_text(struct reader *reader);

/* Reads such a word as a file name; '~' is the home folder. */
char *read_file(struct reader *reader);

/* Sets the place of the next problem to this place in the line. */
void reader_place(struct reader *reader, const char *at);

#endif
