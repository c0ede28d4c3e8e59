/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The names in expressions. A name can stand for a parameter, a variable, a 'let' function, a command or the
 * last answer. The functions sum, min, max and count take a column of a table. To choose one column of an
 * answer, the user appends a dot and the key of the column, as in 'rmax.r' or 'ans.margin'. To resolve a name
 * means to find what it stands for. A sweep resolves the names of its expression once and evaluates the
 * resolved tree at every point. */
#ifndef SHELL_SYMBOLS_H
#define SHELL_SYMBOLS_H

#include "interpreter/command.h"

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

/* What a node of kind TREE_SYMBOL stands for. The comment of each symbol says what the member `refers` of the
 * node points to. For a SYMBOL_PARAMETER, SYMBOL_COMMAND or SYMBOL_ANS, the member `value` of the node is its
 * unit. */
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

/* A 'let' function whose names have been resolved. Each expression has a copy of its own. */
struct routine {
    const struct variable *function;
    const struct tree *body;
    int height; /* the number of nested levels in the body, including those of the functions that it uses */
    /* true while the names of the body are being resolved, to detect a function that uses itself */
    bool is_open;
    struct routine *next;
};

struct resolver {
    const struct state *state;
    const struct last_answer *ans;
    struct arena *arena;
    struct expression_error *error;
    /* Parses 'with' in the bodies of functions; see struct parse. */
    struct tree *(*with)(struct parse *parse, struct tree *value);
    void *context;                /* for `with` */
    const struct variable *scope; /* the function whose body is being resolved, or NULL */
    struct routine *routines;
    /* The child of an aggregate is being resolved. Only there, and not in the body of a function, a name may
     * stand for a column. */
    bool in_aggregate;
    int depth;   /* the level of the node that is being resolved, counted up to NESTING_MOST */
    int deepest; /* the largest level so far */
};

/* Resolves all names of a tree. On failure, sets *resolver->error and returns false. */
bool resolve(struct resolver *resolver, struct tree *tree);

/* Adds the name of a 'let' function to the message of an error that has occurred in its body. `at` is the
 * place where the function is called. */
void routine_wrong(struct expression_error *error, const char *at, const struct variable *function);

/* Evaluates a resolved tree in the state of a query. After an error, sets *error or *problem and returns
 * false. */
bool query_evaluate(const struct query *query, const struct tree *tree, struct quantity *result,
                    struct expression_error *error, struct problem *problem);

#endif
