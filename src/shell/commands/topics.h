/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The topics of help: commands, parameters, effects, and the names that 'let' has defined. */
#ifndef SHELL_TOPICS_H
#define SHELL_TOPICS_H

#include "interpreter/command.h"

/* What the tables say about a topic. Texts that a topic lacks are NULL. */
struct topic {
    const struct command *command;     /* NULL for other topics */
    const struct parameter *parameter; /* a parameter or an effect; NULL for other topics */
    const char *name, *kind, *summary, *equation, *text, *example, *see, *synonyms;
    char usage[96], keys[ANSWER_HEAD], value[VARIABLE_VALUE], shown[EFFECT_EXAMPLE];
};

/* Describes topic k: first the commands, in the order of 'help', and then the parameters and effects. Returns
 * false behind the last topic. */
bool topic_at(int k, struct topic *topic);

/* Describes a variable or function. */
void topic_of_variable(const struct variable *variable, struct topic *topic);

/* Returns true if the word is in the name, the summary or the synonyms of a topic; or, for
 * topic_details_mention, in the other texts. Capital letters do not matter. */
bool topic_mentions(const struct topic *topic, const char *word);
bool topic_details_mention(const struct topic *topic, const char *word);

/* Writes a topic for programs, after topic_rows_begin. */
void topic_rows_begin(struct answer *answer);
void topic_row(struct answer *answer, const struct topic *topic);

/* Writes "rmax [S]   the largest growth" behind a prefix: the usage, and the summary beside it, or below it
 * on a narrow terminal. */
void topic_entry(FILE *out, const char *prefix, const char *usage, const char *summary);

/* ---- Paragraphs ---- */

/* Writes text that may begin in another column than the first, wrapped to the width of help, and a line end.
 */
void help_wrapped(FILE *out, const char *text, int left);

/* Writes a sentence, wrapped, and a line end. */
void help_say(FILE *out, const char *format, ...) __attribute__((format(printf, 2, 3)));

#endif
