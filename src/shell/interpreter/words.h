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
    const struct text *text;
    const char *at;
    const char *stops; /* in a grid: characters that also end a word or value; else NULL */
    bool last;         /* the argument that is read is the command's last */
};

int reader_column(const struct reader *reader, const char *place);

/* Returns true if the command ends here. Comments begin at a blank. */
bool command_ends(const char *c);

/*
 * Reads a run of characters without blanks, or the text between "...", where '""' is one '"'. NULL: a '"' is
 * never closed, or there is no memory.
 */
char *read_word(struct reader *reader, bool quotes);
extern const char unclosed[];

/* Reads a word that keeps its bytes: Greek letters in it are not replaced, as they are in commands. */
char *read_text(struct reader *reader);

/* Reads such a word as a file name; '~' is the home folder. */
char *read_file(struct reader *reader);

#endif
