/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Arguments that are keywords with values, in any order, as in 'title "Growth" width 8 cm' and 'slow speed
 * 2'. */
#ifndef SHELL_OPTIONS_H
#define SHELL_OPTIONS_H

#include "interpreter/question.h"

enum { OPTIONS_MOST = 12, OPTION_VALUES = 2 };

/* A set of words, such as BIT(2) | BIT(5). */
#define BIT(k) (1u << (k))

struct option {
    const char *name;                /* "" for a value without a keyword; such words come last */
    const struct argument *argument; /* how to parse a value; NULL if the value is a text */
    int values;                      /* the number of values after the keyword */
    unsigned beside;                 /* the words that may stand beside this one */
    unsigned after;                  /* words that must come before this one */
    double least, most;              /* the range of a number, if `most` is not 0 */
    const char *unit;                /* its unit in messages, such as " cm"; may be NULL */
    int time;                        /* 1 if the value may be a time, -1 if it may be a rate */
};

/* A command's words. The last name is NULL. */
struct option_list {
    const struct option *options;
    const char *no_unit; /* as in struct reader, while values are parsed */
    const char *usage;   /* the end of messages about missing values, and about other words */
    bool is_whole;       /* nothing else may follow in the command */
};

/* The words that were typed. */
struct options_parsed {
    const struct option_list *list;
    unsigned seen;
    int column[OPTIONS_MOST]; /* where the word begins in the typed line */
    struct item item[OPTIONS_MOST][OPTION_VALUES];
    const char *text[OPTIONS_MOST];
};

/* The words, with their values. Lengths are in cm if the unit of the word is " cm". */
struct options {
    bool has[OPTIONS_MOST];
    int column[OPTIONS_MOST];
    domq_real value[OPTIONS_MOST][OPTION_VALUES]; /* for choices, the index of the choice */
    const char *text[OPTIONS_MOST];
};

/* Parses words. Stops before the first other word, which is an error if the list is whole. */
bool options_parse(struct reader *reader, const struct option_list *list, struct options_parsed *parsed);

bool options_bind(const struct options_parsed *parsed, const struct text *text, const struct query *query,
                  struct options *options, struct problem *problem);

/* Callback of an argument whose q->parsed is a struct options_parsed. Binds it to a struct options. */
bool options_bind_argument(const struct question *question, const struct query *query,
                           struct arguments *given, struct problem *problem);

/* Returns the words of a command whose arguments options_bind_argument has bound. */
const struct options *options_of(const struct query *query);

#endif
