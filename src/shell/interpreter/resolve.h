/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The names in expressions: parameters, the last answer, variables, functions, and commands with their keys.
 */
#ifndef SHELL_RESOLVE_H
#define SHELL_RESOLVE_H

#include "interpreter/command.h"

/* A value that is still to be computed, or that a word has given. */
struct item {
    const struct argument *argument; /* how the value is checked */
    const struct tree *value;        /* the expression; NULL: number is the value */
    domq_real number;
    const char *word; /* the word, name or file that was typed; or NULL */
    const char *at;   /* its place in the text of the line */
};

/* NAME VALUE after 'with', and the next one or NULL. */
struct assignment {
    const struct parameter *parameter;
    struct item item;
    const struct assignment *next;
};

enum symbol {
    SYMBOL_PARAMETER, /* refers to a struct parameter */
    SYMBOL_ARGUMENT,  /* the index-th argument of the function that is evaluated */
    SYMBOL_ROUTINE,   /* refers to a struct routine: a function that 'let' has defined */
    SYMBOL_COMMAND,   /* refers to a struct command; index is the column */
    SYMBOL_ANS,  /* the last answer: refers to its struct command, index is the column; or NULL, its value */
    SYMBOL_WITH, /* refers to a struct assignment: the child in another state */
};

/* A function of 'let' with its names resolved, once for each expression that uses it. */
struct routine {
    const struct variable *function;
    const struct tree *body;
    int height; /* of the body, in nested values */
    bool busy;  /* its names are being resolved */
    struct routine *next;
};

/* Gives every name of a tree its meaning in a state. Returns false after an error: see message and at. */
struct resolver {
    const struct state *state;
    const struct ans *ans;
    struct arena *arena;
    const struct variable *scope; /* the function whose body is resolved; NULL: none */
    struct routine *routines;
    struct tree *(*with)(struct parse *parse, struct tree *value); /* of the bodies of functions */
    void *context;
    int depth; /* of routines */
    const char *at;
    bool named; /* the message names the function that it is about */
    char message[EXPRESSION_MESSAGE];
};
bool resolve(struct resolver *resolver, struct tree *tree);

#endif
