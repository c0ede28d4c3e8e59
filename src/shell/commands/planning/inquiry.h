/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A question that is asked again and again with other parameters: a command with arguments, or an expression.
 */
#ifndef SHELL_INQUIRY_H
#define SHELL_INQUIRY_H

#include "interpreter/arguments.h"

struct inquiry {
    const struct command *command; /* NULL: an expression */
    int key;                       /* of the command's columns */
    const struct text *text;
    const char *at;         /* where the arguments or the expression begin */
    const char *stops;      /* characters that end the expression; NULL for none */
    char name[NAMES_SHOWN]; /* as it was typed */
};

/* Lists for names.h the commands that an inquiry may be about. */
const char *inquiry_names(const void *context, int k);

/* Reads "COMMAND ARGUMENTS", "COMMAND.KEY ARGUMENTS" or an expression, up to the end of the command. */
bool inquiry_read(struct reader *reader, struct inquiry *inquiry);

/* Reads an expression, which ends before the '='. */
bool inquiry_read_left(struct reader *reader, struct inquiry *inquiry);

/* A parameter of the model that an inquiry varies, in copies of the state of a query. */
struct probe {
    const struct query *query;
    const char *query_command; /* the name of the command that asks */
    const struct inquiry *inquiry;
    const struct parameter *parameter; /* NULL: nothing is changed */
    bool verdict;                      /* asks whether what the command decides is true: 1 or -1 */
    struct problem problem;            /* of the last question that had no answer */
    bool wrong;                        /* the error is in the line: no value of the parameter helps */
    struct quantity unit;              /* of the last answer */
};

/* Returns the answer where the parameter has this value; NaN if there is none, with probe->problem. */
domq_real probe_at(struct probe *probe, domq_real value);

/* Gives the problem of the last question. Returns false. */
bool probe_report(const struct probe *probe, struct problem *problem);

#endif
