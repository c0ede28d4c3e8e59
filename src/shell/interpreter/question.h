/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A question is a command with its arguments, parsed. Its syntax is checked and its names are resolved once,
 * when it is parsed. Its values are computed in a state, when it is bound, which a sweep does at every point.
 * A parsed question does not change, so that threads can share it. It lives in the arena of the line. */
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

/* Parses a question inside another command: COMMAND, COMMAND.KEY or an expression, which 'print' answers. If
 * `is_number`, it must ask for one number. */
bool question_parse_any(struct reader *reader, struct question *question, bool is_number);

/* Lists for names.h the commands that such a question can have. */
const char *question_names(const void *context, int k);

/* Returns a copy of a question's text for messages, without blanks at its end. */
const char *question_name(struct reader *reader, const char *begin, const char *end);

/* A question that is bound: its values, and the query that it is run with. */
struct call {
    struct query query;
    struct arguments given;
    struct state state; /* the state that 'with' has changed; not used without 'with' */
};

/* Binds a question in the state of a query. Call call_free also after a problem. */
bool question_bind(const struct question *question, const struct query *query, struct call *call,
                   struct problem *problem);
void call_free(struct call *call);

/* Returns memory for the result of argument.bind, zeroed, which call_free frees. Returns NULL with a problem
 * if there is none. */
void *arguments_take(struct arguments *given, size_t size, const struct query *query,
                     struct problem *problem);

/* Binds a question and runs its command. */
bool question_ask(const struct question *question, const struct query *query, struct answer *answer,
                  struct problem *problem);

/* Asks a question and returns one number of its answer, in SI units: the one of the key, or an expression's
 * value. */
bool question_value(const struct question *question, const struct query *query, struct quantity *value,
                    struct problem *problem);

/* Returns true if the question is an expression. 'print' answers it, which problems do not name. */
bool question_is_expression(const struct question *question);

/* Returns true if the question asks for one number; otherwise a problem lists the keys that could be meant.
 */
bool question_needs_number(const struct question *question, struct problem *problem);

#endif
