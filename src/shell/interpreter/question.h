/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A question is a command with its arguments, parsed. Names and syntax are looked at once, when the question
 * is parsed; its values are computed in a state when it is bound, which a sweep does at every point. A parsed
 * question does not change, so that threads can share it. It lives in the arena of the line.
 */
#ifndef SHELL_QUESTION_H
#define SHELL_QUESTION_H

#include "interpreter/item.h"

struct question {
    const struct command *command;
    int key;   /* the column of the answer that is asked for, or -1 for the whole answer */
    int count; /* number of arguments */
    struct item item[ARGUMENTS_MAX];
    const struct parameter *parameter; /* named by ARGUMENT_PARAMETER or ARGUMENT_EFFECT, or NULL */
    const struct variable *variable;   /* named by ARGUMENT_PARAMETER, ARGUMENT_TOPIC or 'let', or NULL */
    void *parsed;                      /* the result of argument.parse */
    const struct assignment *with;     /* what follows 'with', or NULL */
    const struct text *text;
    const char *name; /* the question as it was typed, for messages */
};

/* Parses the line's command with its arguments. */
bool command_parse(struct reader *reader, struct question *question);

/* Parses the arguments of question->command, up to the end of the command, '>' or a stop of the reader. */
bool question_parse(struct reader *reader, struct question *question);

/* Parses a question inside of another command: COMMAND, COMMAND.KEY or an expression, which 'print' answers.
 * With `is_number`, the question must ask for one number. */
bool question_parse_any(struct reader *reader, struct question *question, bool is_number);

/* Lists for names.h the commands that a question inside of another command can ask. */
const char *question_names(const void *context, int k);

/* Returns the text of a question for messages, without blanks at its end; in the arena. */
const char *question_name(struct reader *reader, const char *begin, const char *end);

/* A question about to be answered: its values, and the state in which they hold. */
struct call {
    struct query query;
    struct arguments given;
    struct state state; /* only after 'with'; else that of the query is used */
};

/* Binds a question in the state of a query, whose arguments are not used. Call call_free also after a
 * problem. */
bool question_bind(const struct question *question, const struct query *query, struct call *call,
                   struct problem *problem);
void call_free(struct call *call);

/* Binds and answers a question. */
bool question_ask(const struct question *question, const struct query *query, struct answer *answer,
                  struct problem *problem);

/* Answers with one number, the one of the key or the value of an expression, in SI units. */
bool question_value(const struct question *question, const struct query *query, struct quantity *value,
                    struct problem *problem);

/* Returns true if the question is an expression, which 'print' answers. Problems do not name that command. */
bool question_is_expression(const struct question *question);

/* Returns true if the question asks for one number. Otherwise describes a problem with the keys of the
 * answer. */
bool question_needs_number(const struct question *question, struct problem *problem);

#endif
