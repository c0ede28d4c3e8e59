/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A question is a command with its arguments, after parsing. The names in the arguments have been resolved,
 * but their values have not been computed. To bind a question means to compute these values in a state. A
 * sweep therefore parses its question once and binds it at every point. Several threads can use the same
 * question. The memory of a question is in the arena of the line.
 */
#ifndef SHELL_QUESTION_H
#define SHELL_QUESTION_H

#include "interpreter/item.h"

struct question {
    const struct command *command;
    int key; /* index of the requested column of the answer, or -1 for the whole answer */
    int count;
    struct item item[ARGUMENTS_MAX];
    /* These two members are copied to struct arguments. */
    const struct parameter *parameter;
    const struct variable *variable;
    void *parsed;                  /* the result of argument.parse */
    const struct assignment *with; /* the assignments after 'with', or NULL */
    bool details;                  /* the command ends with the word 'details' */
    const struct text *text;
    const char *file; /* the file for the answer, if it was typed without '>'; otherwise NULL */
    const char *name; /* the text from question_name, for messages and headings */
};

/* If one of the functions below returns false, it has stored the error in *problem or, if it takes a reader,
 * in *reader->problem. */

bool command_parse(struct reader *reader, struct question *question);

/* Parses the arguments of question->command. They extend to the end of the command, to a '>', or to one of
 * the characters in the reader's `stops`. */
bool question_parse(struct reader *reader, struct question *question);

/* Parses a question inside another command, such as 'sweep'. The question can be a command, a command with
 * the key of a column, such as "rmax.r", or an expression, which stands for 'print'. The answer must be one
 * number. If `is_number` is false, it may also be yes or no. */
bool question_parse_any(struct reader *reader, struct question *question, bool is_number);

/* A names_list of the commands that completion offers for question_parse_any. */
const char *question_names(const void *context, int k);

/* Returns a copy of the text from `begin` to `end` without trailing blanks, shortened and escaped. */
const char *question_name(struct reader *reader, const char *begin, const char *end);

/* The result of question_bind: the values of the arguments, and the query that the command answers. */
struct call {
    struct query query;
    struct arguments given;
    struct state state; /* the state after the assignments of 'with', if there are any */
};

/* Binds a question in the state of a query. Even after an error, the caller must free call->given.memory. */
bool question_bind(const struct question *question, const struct query *query, struct call *call,
                   struct problem *problem);

/* Allocates zeroed memory in the arena given->memory and stores its address in given->bound. The function
 * argument.bind calls this function to get memory for its result. Returns NULL if memory runs out. */
void *arguments_take(struct arguments *given, size_t size, const struct query *query,
                     struct problem *problem);

/* Binds a question and runs its command. */
bool question_ask(const struct question *question, const struct query *query, struct answer *answer,
                  struct problem *problem);

/* Binds a question and computes its value, which is one number in SI units. For a command, this number is
 * the cell in column question->key of the answer. For 'print', it is the value of the expression. */
bool question_value(const struct question *question, const struct query *query, struct quantity *value,
                    struct problem *problem);

/* Like question_value. Also stores the unit of the number, as text for the head of a column. */
bool question_measure(const struct question *question, const struct query *query, struct quantity *value,
                      char unit[UNIT_TEXT], struct problem *problem);

/* Returns true if the answer to the question is one number. Otherwise reports a problem that lists the keys
 * from which the user can choose. */
bool question_needs_number(const struct question *question, struct problem *problem);

#endif
