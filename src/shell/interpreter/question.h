/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A question is a command with its arguments, after parsing. The names in the arguments have been resolved,
 * but their values have not been computed. To bind a question means to compute these values in a state, and
 * to check whether they are allowed. A sweep therefore parses its question once and binds it at every point.
 * Several threads can use the same question. The memory of a question is in the arena of the line.
 *
 * The functions that take a reader parse text at its position and move the reader to the end of this text.
 * After an error they set the reader's problem, and return false or NULL. The others have a *problem.
 */
#ifndef SHELL_QUESTION_H
#define SHELL_QUESTION_H

#include "interpreter/reader.h"

/* ---- Commands (command_read.c) ---- */

/*
 * Returns the command of a line and moves the reader to its arguments. Most lines begin with the name of a
 * command. The others are shorthands, such as 2+2 for 'print', r = 2 for 'set', q alone for 'show', or rmax?
 * for 'help'. If a command and a parameter have the same name, the name stands for the command. If the name
 * of a parameter is also an abbreviation of a command, the name stands for the parameter, so 'q' does not
 * mean 'quit'.
 */
const struct command *command_read(struct reader *reader);

/* Finds the command that another command runs, such as 'verdict' in 'assert verdict'. If the text is an
 * expression, as in 'assert rmax < 2', returns 'print'. Other shorthands are not allowed. Completion offers
 * the names in the list `offered`. */
const struct command *command_read_inner(struct reader *reader, names_list *offered);

/* Decides whether the word before c is the beginning of an expression rather than a command. Returns true if
 * there is an operator or 'to' at c. */
bool goes_on(const char *c);

/* Parses the beginning of a definition, up to the '=', as in "x =" or "f(s, d) =". Returns the position after
 * the '='. If the text does not begin in this way, returns NULL. */
const char *definition_head(const char *text, struct variable *variable);

/* Returns true if a variable or function can have this name. Otherwise reports what the name means. */
bool name_free(struct problem *problem, const char *name);

/* ---- Values (item.c) ---- */

/* One value in the arguments of a command. The user has typed it as an expression, or as a word that stands
 * for a value. */
struct item {
    const struct argument *argument;
    const struct tree *value; /* the expression, or NULL if `number` is the value */
    domq_real number;
    const char *word; /* the word, name or path that was typed, or NULL */
    const char *at;   /* the position of the value in the line; may be NULL */
};

/* One "NAME VALUE" pair after 'with', as an element of a linked list. */
struct assignment {
    const struct parameter *parameter;
    struct item item;
    const struct assignment *next;
};

/* Parses an expression for an argument. The item keeps a pointer to the argument. */
bool item_parse(struct reader *reader, const struct argument *argument, struct item *item);

/* Parses value number i of a parameter: a word or an expression. Messages call the value `name`. */
bool item_parse_value(struct reader *reader, const struct parameter *parameter, int i, const char *name,
                      struct item *item);

/* Parses one value of a list such as "r 1.5 s 0.3". If the value of an effect is the word "on", the effect
 * gets its usual value. */
bool item_parse_listed(struct reader *reader, const struct parameter *parameter, struct item *item);

/* Parses one of the argument's choices. The item's number is the index of the choice. */
bool item_parse_choice(struct reader *reader, const struct argument *argument, struct item *item);

/* Parses an angle or one of the argument's choices. For an angle, the item holds an expression. For choice k,
 * it holds the number -1 - k, which cannot be mistaken for an angle. */
bool item_parse_place(struct reader *reader, const struct argument *argument, struct item *item);

/* Parses the name of a parameter of the model or of an effect. If the next word is not a name at all, the
 * error message ends with the text `form`, which shows what the command expects. */
const struct parameter *parameter_parse(struct reader *reader, const char *form);

/* Parses "NAME VALUE NAME VALUE ..." after 'with'. */
const struct assignment *assignments_parse(struct reader *reader);

/* Computes and checks the value of an item. Stores the value in *number. If `quantity` is not NULL, also
 * stores the value with its unit in *quantity. If `text` is not NULL, a problem says at which column of the
 * line the value is. */
bool item_bind(const struct item *item, const struct text *text, const struct query *query,
               struct quantity *quantity, domq_real *number, struct problem *problem);

/* Returns true if the name is known in expressions (see value_names). */
bool is_value_name(const struct state *state, const char *name);

/* A names_list of the parameters of the model and, after them, the effects. */
const char *model_names(const void *context, int k);

/* ---- Names in expressions (resolve.c, lookup.c) ---- */

/*
 * A name can stand for a parameter, a variable, a 'let' function, a command or the last answer. The functions
 * sum, min, max and count take a column of a table. To choose one column of an answer, the user appends a dot
 * and the key of the column, as in 'rmax.r' or 'ans.margin'. To resolve a name means to find what it stands
 * for: a node of kind TREE_SYMBOL. The comment of each symbol says what the member `refers` of the node
 * points to. For a SYMBOL_PARAMETER, SYMBOL_COMMAND or SYMBOL_ANS, the member `value` of the node is its
 * unit.
 */
enum symbol {
    SYMBOL_PARAMETER, /* a struct parameter */
    SYMBOL_ARGUMENT,  /* NULL; the symbol is argument `index` of the function that is being evaluated */
    SYMBOL_ROUTINE,   /* a struct routine */
    SYMBOL_COMMAND,   /* a struct command; the value is column `index` of its answer */
    /* Column `index` of the last answer. `refers` points to the struct command that gave this answer. If
     * `refers` is NULL, the symbol stands for the last value that 'print' has shown. */
    SYMBOL_ANS,
    SYMBOL_COLUMN,    /* a struct command whose answer is a table; the value is column `index` in one row */
    SYMBOL_AGGREGATE, /* NULL; `index` is an enum aggregate of the child node over the rows of a table */
    SYMBOL_WITH,      /* the linked list of assignments that apply while the child node is evaluated */
};

enum aggregate { AGGREGATE_SUM, AGGREGATE_MIN, AGGREGATE_MAX, AGGREGATE_COUNT };

/* A 'let' function in an expression. Each expression has a copy of its own. */
struct routine {
    const struct variable *function;
    const struct tree *body;
    int height;   /* the number of nested levels in the body, including those of the functions that it uses */
    bool is_open; /* the body is being parsed, to detect a function that uses itself */
    struct routine *next;
};

/* Resolves a name. Is the callback reader.names. */
bool name_resolve(struct reader *reader, struct tree *name);

/* Returns the first column of a table in a tree that no aggregate takes, or NULL. */
const struct tree *column_in(const struct tree *tree);

/* Returns false, with an error in *problem, if the value of a tree depends on the row of a table. */
bool is_single(struct problem *problem, const struct tree *tree);

/* Adds the name of a 'let' function to the message of an error that has occurred in its body. `at` is the
 * place where the function is called. Returns false. */
bool routine_wrong(struct problem *problem, const char *at, const struct variable *function);

/* Returns what is needed to evaluate trees in the state of a query. An error has a position if it is one of
 * the expression (problem.at), and none if a command in it has no answer. */
struct evaluation query_evaluation(const struct query *query, struct problem *problem);

/* Makes *changed a copy of e->query in which the parameters after 'with' have their new values. *state
 * becomes the state of the copy. `text` is the line, or NULL. */
bool with_apply(struct evaluation *e, const struct assignment *with, const struct text *text,
                struct state *state, struct query *changed);

/* Adds the name of a value to an error in its expression, and finds the column of the error if `text` is not
 * NULL. Returns false. */
bool item_wrong(struct problem *problem, const struct text *text, const char *name);

/* ---- Questions (question_parse.c, lookup.c) ---- */

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
    const char *name; /* the text from question_name, for messages and headings */
};

bool command_parse(struct reader *reader, struct question *question);

/* Parses the arguments of question->command. They extend to the end of the command, to a '>', or to one of
 * the characters in the reader's `stops`. */
bool question_parse(struct reader *reader, struct question *question);

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

/* Runs a command. If errors are on, runs it a second time in quad precision, to find the errors of its
 * numbers (answer/cell.h). */
bool command_compute(const struct command *command, const struct query *query, struct answer *answer,
                     struct problem *problem);

/* Parses and runs the command at the reader's position, writes its answer to standard output or a file, and
 * moves the reader to where parsing ended. */
void run_command_at(struct session *session, struct reader *line);

#endif
