/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Arguments that are words with values, in any order, as in 'speed 0.5 tower'. */
#ifndef SHELL_OPTIONS_H
#define SHELL_OPTIONS_H

#include "interpreter/question.h"

enum { OPTIONS_MOST = 8 };

/* A set of words, such as BIT(2) | BIT(5). */
#define BIT(k) (1u << (k))

struct option {
    const char *name;                /* "" for a value without a keyword; such words come last */
    const struct argument *argument; /* how to parse the value after the keyword; NULL if there is none */
    unsigned beside;                 /* the words that may stand beside this one */
    unsigned after;                  /* words that must come before this one */
    double least, most;              /* the range of a number, if `most` is not 0 */
    const char *unit;                /* its unit in messages, such as " frames per second"; may be NULL */
    int time;                        /* 1 if the value may be a time, -1 if it may be a rate */
};

/* A command's words. The last name is NULL. */
struct option_list {
    const struct option *options;
    const char *usage; /* the end of messages about missing values, and about other words */
};

/* The words that were typed. */
struct options_parsed {
    const struct option_list *list;
    unsigned seen;
    int column[OPTIONS_MOST]; /* where the word begins in the typed line */
    struct item item[OPTIONS_MOST];
};

/* The words, with their values. */
struct options {
    bool has[OPTIONS_MOST];
    int column[OPTIONS_MOST];
    domq_real value[OPTIONS_MOST];
};

/* Parses the words of a command to its end. Returns NULL on failure. The result is in q->parsed, which
 * options_bind_argument, a callback of the argument, binds to a struct options. */
const struct options_parsed *options_parse(struct reader *reader, struct question *q,
                                           const struct option_list *list);
bool options_bind_argument(const struct question *question, const struct query *query,
                           struct arguments *given, struct problem *problem);

/* Returns the words of a command whose arguments options_bind_argument has bound. */
const struct options *options_of(const struct query *query);

#endif
