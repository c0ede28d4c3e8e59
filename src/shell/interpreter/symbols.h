/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The names in expressions: parameters, variables, functions of 'let', the last answer, and commands with
 * their keys. Names are resolved once, when the line is parsed. A sweep then evaluates the resolved tree at
 * every point.
 */
#ifndef SHELL_SYMBOLS_H
#define SHELL_SYMBOLS_H

#include "interpreter/command.h"

/* One value of a command: an expression, or a word that stands for a value. */
struct item {
    const struct argument *argument; /* the argument to which the value belongs */
    const struct tree *value;        /* the expression, or NULL if `number` is the value */
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

/* What a tree of kind TREE_SYMBOL stands for, and what its member `refers` points to. For a parameter, a
 * command and a column of the last answer, the member `value` is the unit. */
enum symbol {
    SYMBOL_PARAMETER, /* a struct parameter */
    SYMBOL_ARGUMENT,  /* argument number `index` of the function that is being evaluated */
    SYMBOL_ROUTINE,   /* a struct routine */
    SYMBOL_COMMAND,   /* a struct command; the value is column `index` of its answer */
    /* The struct command of the last answer; the value is column `index` of that answer. NULL stands for the
     * value that was printed last. */
    SYMBOL_ANS,
    SYMBOL_WITH, /* a list of struct assignment that applies while the child is evaluated */
};

/* A function defined by 'let', with the names in its body resolved. Each expression that uses a function has
 * its own copy. */
struct routine {
    const struct variable *function;
    const struct tree *body;
    int height; /* height of the body's tree */
    /* True while the names of the body are being resolved. This detects a function that uses itself. */
    bool is_open;
    struct routine *next;
};

struct resolver {
    const struct state *state;
    const struct ans *ans;
    struct arena *arena;
    /* Parses 'with' in the bodies of functions; see struct parse. */
    struct tree *(*with)(struct parse *parse, struct tree *value);
    void *context;                /* for `with` */
    const struct variable *scope; /* the function whose body is being resolved, or NULL */
    struct routine *routines;
    int depth;           /* how deeply the function whose body is being resolved is nested in others */
    bool names_function; /* After an error: the message already says in which function the error is. */
    const char *at;      /* after an error: its position in the expression */
    char message[EXPRESSION_MESSAGE];
};

/* Resolves every name of a tree. Returns false after an error, which resolver->message and resolver->at
 * describe. */
bool resolve(struct resolver *resolver, struct tree *tree);

/* Evaluates a resolved tree in the state of a query. After an error, returns false and sets either
 * evaluation->message or the problem. */
bool query_evaluate(const struct query *query, struct evaluation *evaluation, const struct tree *tree,
                    struct quantity *result, struct problem *problem);

/* Copies the query's state to *state, and assigns values to parameters of the copy. Sets *changed to a copy
 * of the query that refers to *state. Returns false with a problem. */
bool query_with(const struct query *query, const struct assigned *assigned, int count, struct state *state,
                struct query *changed, struct problem *problem);

#endif
