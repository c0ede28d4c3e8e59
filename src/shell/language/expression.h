/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Values as people write them: 7/48, pi/18, 10 deg, 4.8 cm, 0.9*s, rmax(0.3), ans.margin, if(r > 1.5, 1, 0).
 *
 * An expression is parsed into a tree once, and evaluated as often as needed, also by several threads:
 * evaluation changes nothing in the tree. A chain is values joined by operators of one precedence, from the
 * left. An argument ends at a blank that no operator bridges ("1 - 2" is one value, "1 -2" are two).
 */
#ifndef SHELL_EXPRESSION_H
#define SHELL_EXPRESSION_H

#include "language/arena.h"
#include "language/units.h"

enum { EXPRESSION_ARGUMENTS = 4, EXPRESSION_MESSAGE = 256 };

/* A name is given a meaning after parsing: whoever knows the names sets the kind to TREE_NUMBER or
 * TREE_SYMBOL. */
enum tree_kind {
    TREE_NUMBER,
    TREE_NAME,
    TREE_SYMBOL,
    TREE_FUNCTION,
    TREE_MINUS,
    TREE_CHAIN,
    TREE_NOT,
    TREE_IF
};

enum tree_operator {
    OPERATOR_NONE,
    OPERATOR_OR,
    OPERATOR_AND,
    OPERATOR_LESS,
    OPERATOR_AT_MOST,
    OPERATOR_MORE,
    OPERATOR_AT_LEAST,
    OPERATOR_EQUAL,
    OPERATOR_UNEQUAL,
    OPERATOR_PLUS,
    OPERATOR_MINUS,
    OPERATOR_TIMES,
    OPERATOR_OVER,
    OPERATOR_POWER,
};

struct function;

struct tree {
    enum tree_kind kind;
    enum tree_operator operator;     /* joins this child of a chain to those before it */
    const char *operator_at;         /* its place in the text; of a power that of the exponent */
    const char *at;                  /* the place in the text that an error is about */
    struct quantity value;           /* of TREE_NUMBER */
    const char *name, *key;          /* of a name, in the arena; key is what follows its dot, or NULL */
    bool called;                     /* parentheses follow the name */
    int count;                       /* children, at most EXPRESSION_ARGUMENTS but in a chain */
    struct tree *child, *next;       /* the first child; the next child of the same parent */
    const struct function *function; /* of TREE_FUNCTION */
    int symbol, index;               /* of TREE_SYMBOL: what it is, which one, and what it refers to */
    const void *refers;
};

/* The syntax of one expression. */
struct parse {
    const char *text; /* where it begins */
    const char *end;  /* where it ends; after an error, the place of the error */
    struct arena *arena;
    const char *no_unit; /* letters that are no units after a blank, but names; NULL: none */
    /* Parses "with NAME VALUE ..." at p->end, behind a value in parentheses; returns what then stands in the
     * place of the value, or NULL after an error. NULL: there is no such form here. */
    struct tree *(*with)(struct parse *parse, struct tree *value);
    void *context;     /* of with */
    int depth, nested; /* values within values; open parentheses */
    int nodes;         /* of the tree so far */
    char message[EXPRESSION_MESSAGE];
};

/* Parses the longest expression at parse->text. Returns NULL after an error: see message and end. */
struct tree *expression_parse(struct parse *parse);

/* Sets the message of an error of syntax, and returns NULL. */
struct tree *parse_fail(struct parse *parse, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* One evaluation of a tree. */
struct evaluation {
    /* Gives the value of a TREE_SYMBOL. Returns false with a message; without one, a problem is described
     * elsewhere. */
    bool (*symbol)(struct evaluation *evaluation, const struct tree *tree, struct quantity *result);
    void *context;   /* of symbol */
    domq_real angle; /* what 1 is in radians where a bare number stands for an angle */
    const char *at;  /* after an error: its place in the text */
    bool of_value;   /* the error is in the values: with others the same expression may have one */
    bool named;      /* the message names the function that it is about */
    char message[EXPRESSION_MESSAGE];
};

/* Evaluates a tree without TREE_NAME. Returns false after an error: see message and at. */
bool expression_evaluate(struct evaluation *evaluation, const struct tree *tree, struct quantity *result);

/*
 * Reads a whole text as an expression without names, as files have them. Returns false with a message after
 * an error, and where there is more text: *end, unless NULL, is then where.
 */
bool expression_constant(const char *text, struct quantity *result, char message[EXPRESSION_MESSAGE],
                         const char **end);

/* Set the message of an error in the line, or in its values; both are the value false. */
void evaluation_message(struct evaluation *evaluation, bool of_value, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
#define evaluation_fail(e, ...)     (evaluation_message(e, false, __VA_ARGS__), false)
#define evaluation_no_value(e, ...) (evaluation_message(e, true, __VA_ARGS__), false)

/* Returns true for a finite number in a unit whose exponents do not overflow: what each step may give. */
bool evaluation_finite(struct evaluation *evaluation, const char *at, const struct quantity *quantity);

/* Returns the function of the language with this name and the number of its values, or NULL. */
const struct function *function_find(const char *name, int *values);

/* Lists for names.h the names that the language itself has. */
const char *expression_names(const void *context, int k);

#endif
