/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The words of a line: up to a blank, between quotes, as they were typed, or as the name of a file. */
#ifndef SHELL_WORDS_H
#define SHELL_WORDS_H

#include "interpreter/command.h"
#include "language/text.h"

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
};

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
