/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The help topics: commands, parameters, effects, and the names that 'let' has defined. */
#ifndef SHELL_TOPICS_H
#define SHELL_TOPICS_H

#include "interpreter/command.h"

/* A help topic. If a topic does not have one of these texts, the pointer to the text is NULL. For example,
 * `see` is NULL for a parameter. */
enum { TOPIC_SEE = 128 };
struct topic {
    const struct command *command;     /* the command; NULL for other topics */
    const struct parameter *parameter; /* the parameter or effect; NULL for other topics */
    const char *name, *kind, *summary, *equation, *text, *example, *see, *synonyms;
    char usage[96], keys[ANSWER_HEADER], value[VARIABLE_VALUE];
    char seen[TOPIC_SEE]; /* the text of `see` */
};

/* Fills in topic number k, or returns false if there is none. Commands come first, in the order of 'help',
 * then parameters and effects. */
bool topic_at(int k, struct topic *topic);

/* Fills in the topic for a variable or function that was defined with 'let'. */
void topic_of_variable(const struct variable *variable, struct topic *topic);

/* The part of a topic in which a word occurs: */
enum topic_match {
    MATCH_TOPIC,   /* in the name, the summary, the synonyms, or the words for a parameter's values */
    MATCH_DETAILS, /* only in the help text, the equations or the columns */
    MATCH_NONE
};

/* Does not distinguish upper and lower case. */
enum topic_match topic_match(const struct topic *topic, const char *word);

/* Adds a row for a topic to an answer in csv or json. */
void topic_row(struct answer *answer, const struct topic *topic);

/* Prints a prefix and an entry such as "rmax [S]   the largest growth". On a narrow terminal, the summary is
 * below the usage. */
void topic_entry(FILE *out, const char *prefix, const char *usage, const char *summary);

/* ---- Paragraphs ---- */

/* Returns the width of the terminal, but at most 100, because longer lines are hard to read. */
int help_width(FILE *out);

/* Prints a text and a newline, wrapped to the width of help pages. The lines after the first begin at column
 * `left`. */
void help_wrapped(FILE *out, const char *text, int left);

/* Like help_wrapped with `left` = 0, but takes a format and its arguments, as printf does. */
void help_say(FILE *out, const char *format, ...) __attribute__((format(printf, 2, 3)));

#endif
