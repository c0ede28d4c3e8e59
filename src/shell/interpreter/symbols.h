/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The names in expressions: parameters, variables, functions of 'let', the last answer, and commands with
 * their keys. They are resolved once, when a line is parsed; the tree is then evaluated as often as a sweep
 * has points.
 */
#ifndef SHELL_SYMBOLS_H
#define SHELL_SYMBOLS_H

#include "interpreter/command.h"

/* One value of a command: an expression, or a word that stands for a value. */
struct item {
    const struct argument *argument; /* the argument that has this value */
    const struct tree *value;        /* the expression, or NULL if `number` is the value */
    domq_real number;
    const char *word; /* the word, name or path that was typed, or NULL */
    const char *at;   /* its place in the line */
};

/* One NAME VALUE after 'with'. */
struct assignment {
    const struct parameter *parameter;
    struct item item;
    const struct assignment *next;
};

/* What a tree of kind TREE_SYMBOL refers to. */
enum symbol {
    SYMBOL_PARAMETER, /* a struct parameter */
    SYMBOL_ARGUMENT,  /* argument number `index` of the function that is evaluated */
    SYMBOL_ROUTINE,   /* a struct routine */
    SYMBOL_COMMAND,   /* column number `index` of a struct command */
    SYMBOL_ANS,  /* column number `index` of the last answer's struct command; NULL for the last printed value
                  */
    SYMBOL_WITH, /* struct assignments, which hold while the child is evaluated */
};

/* A function of 'let' with its names resolved. Each expression that uses the function has its own. */
struct routine {
    const struct variable *function;
    const struct tree *body;
    int height;   /* levels of the body's tree */
    bool is_open; /* The names of its body are being resolved. */
    struct routine *next;
};

struct resolver {
    const struct state *state;
    const struct ans *ans;
    struct arena *arena;
    struct tree *(*with)(struct parse *parse, struct tree *value); /* for the bodies of functions */
    void *context;                                                 /* of `with` */
    const struct variable *scope; /* the function whose body is being resolved, or NULL */
    struct routine *routines;
    int depth;           /* levels of functions within functions */
    bool names_function; /* The message already says in which function the error is. */
    const char *at;      /* the place of the error */
    char message[EXPRESSION_MESSAGE];
};

/* Resolves every name of a tree. Returns false after an error, with the resolver's message and place. */
bool resolve(struct resolver *resolver, struct tree *tree);

/* Evaluates a resolved tree in the state of a query. After an error either the evaluation has a message, or
 * the problem is described. */
bool query_evaluate(const struct query *query, struct evaluation *evaluation, const struct tree *tree,
                    struct quantity *result, struct problem *problem);

/* Makes a copy of the query's state, assigns values to it, and makes `changed` the query of that copy. */
bool query_with(const struct query *query, const struct assigned *assigned, int count, struct state *state,
                struct query *changed, struct problem *problem);

#endif
