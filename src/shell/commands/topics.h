/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The topics of help: commands, parameters, effects, and the names that 'let' has defined. */
#ifndef SHELL_TOPICS_H
#define SHELL_TOPICS_H

#include "interpreter/command.h"

/* A topic of help, with its texts from the tables of commands and parameters. Texts that a topic does not
 * have are NULL. */
struct topic {
    const struct command *command;     /* the command; NULL for other topics */
    const struct parameter *parameter; /* the parameter or effect; NULL for other topics */
    const char *name, *kind, *summary, *equation, *text, *example, *see, *synonyms;
    char usage[96], keys[ANSWER_HEAD], value[VARIABLE_VALUE], shown[EFFECT_EXAMPLE];
};

/* Fills in topic number k. The commands come first, in the order of 'help', and then the parameters and
 * effects. Returns false if there is no topic with this number. */
bool topic_at(int k, struct topic *topic);

/* Fills in the topic for a variable or function that was defined with 'let'. */
void topic_of_variable(const struct variable *variable, struct topic *topic);

/* Returns 1 if the word occurs in the name, the summary or the synonyms of a topic, or in the words for a
 * parameter's values. Returns 2 if it occurs only in the help text, the equations or the columns, and 0 if it
 * occurs nowhere. Ignores case. */
int topic_mentions(const struct topic *topic, const char *word);

/* Adds a row for a topic to an answer in csv or json. */
void topic_row(struct answer *answer, const struct topic *topic);

/* Prints a prefix and an entry such as "rmax [S]   the largest growth". The summary stands beside the usage,
 * or below it on a narrow terminal. */
void topic_entry(FILE *out, const char *prefix, const char *usage, const char *summary);

/* ---- Paragraphs ---- */

/* Prints a text and a newline. The text is wrapped to the width of help pages, and its lines begin at the
 * column `left`. */
void help_wrapped(FILE *out, const char *text, int left);

/* Formats a text, wraps it to the width of help pages, and prints it with a newline at the end. */
void help_say(FILE *out, const char *format, ...) __attribute__((format(printf, 2, 3)));

#endif
