/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A question: a command with its arguments, parsed. Parsing finds names and the syntax, once; binding gives
 * the arguments values in a state, as often as a sweep has points. Nothing changes a question after it was
 * parsed, so that threads share it. It lives in the arena of the line.
 */
#ifndef SHELL_QUESTION_H
#define SHELL_QUESTION_H

#include "interpreter/resolve.h"
#include "interpreter/words.h"

struct question {
    const struct command *command;
    int key; /* of the answer's columns, where one of them is asked for; -1: the whole answer */
    int count;
    struct item item[ARGUMENTS_MAX];
    const struct parameter *parameter; /* that ARGUMENT_PARAMETER or ARGUMENT_EFFECT names, or NULL */
    const struct variable
        *variable; /* that ARGUMENT_PARAMETER, ARGUMENT_TOPIC or a definition names, or NULL */
    void *own;     /* what argument.parse has found; in the arena */
    const struct assignment *with; /* what holds for this answer alone, or NULL */
    const struct text *text;
    const char *name; /* the question as it was typed */
};

/* Parses the arguments of question->command, up to the end of the command, a '>' or a stop of the reader. */
bool question_parse(struct reader *reader, struct question *question);

/* Parses a question with its command: COMMAND, COMMAND.KEY, or an expression, which is what 'print' answers.
 * With `number` it must be about one number. */
bool question_parse_any(struct reader *reader, struct question *question, bool number);

/* Lists for names.h the commands that a question may be about: their answer has a number, or decides
 * something. */
const char *question_names(const void *context, int k);

/* Returns a question as it was typed, without blanks at its end and as a message can show it; in the arena.
 */
const char *question_name(struct reader *reader, const char *begin, const char *end);

/* Gives the arguments values in the state of a query. Free them with arguments_free, also after a problem. */
bool question_bind(const struct question *question, const struct query *query, struct arguments *given,
                   struct problem *problem);

/* Makes a copy of the query's state with what stands after 'with' in a question. Returns false with a
 * problem. */
bool question_with(const struct question *question, const struct query *query, struct state *state,
                   struct query *changed, struct problem *problem);

/* Binds and answers; query->given is not used. */
bool question_ask(const struct question *question, const struct query *query, struct answer *answer,
                  struct problem *problem);

/* Answers with one number: that of the key, or the value of an expression; and its unit. */
bool question_value(const struct question *question, const struct query *query, struct quantity *value,
                    struct problem *problem);

/* Describes a problem, with the keys of the answer, where a question is about no number of it. */
bool question_needs_number(const struct question *question, struct problem *problem);

/* ---- For the parsers of single commands ---- */

/* Parses an expression for an argument, which outlives the question. */
bool item_parse(struct reader *reader, const struct argument *argument, struct item *item);

/* Parses the i-th value of a parameter: one of its words, or an expression. name: the value in messages. */
bool item_parse_value(struct reader *reader, const struct parameter *parameter, int i, const char *name,
                      struct item *item);

/* Parses one of the argument's names; a word that is none of them is a problem that lists the names. */
bool item_parse_choice(struct reader *reader, const struct argument *argument, struct item *item);

/* Parses a value in a list of names and values, where the next name may follow; an effect that is on takes
 * its usual value. Returns NULL after an error. */
const struct item *item_parse_listed(struct reader *reader, const struct parameter *parameter,
                                     struct item *item);

/* Computes the value of an item and checks it. quantity may be NULL. */
bool item_bind(const struct item *item, const struct text *text, const struct query *query,
               struct quantity *quantity, domq_real *number, struct problem *problem);

/* Parses the name of a parameter of the model or of an effect, as in a grid. form: what would be right. */
const struct parameter *parameter_parse(struct reader *reader, const char *form);

/* Lists for names.h the parameters of the model, then the effects. */
const char *model_names(const void *context, int k);

/* Frees the memory of arguments. */
void arguments_free(struct arguments *given);

#endif
