/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Expressions: 7/48, pi/18, 10 deg, 4.8 cm, 0.9*s, rmax(0.3), ans.margin, if(r > 1.5, 1, 0).
 *
 * The parser turns an expression into a tree. Evaluation does not change the tree, so threads can share it.
 *
 * A chain is a node for several operators of the same precedence, as in "a - b + c". Its children are the
 * operands a, b and c. Each operand except the first stores the operator before it.
 *
 * A blank ends an expression unless an operator follows, so a line can hold several expressions. After a
 * blank, a sign directly before a value belongs to that value: "1 - 2" is one expression, but "1 -2" is two.
 * In parentheses, there is only one expression, so "(1 -2)" is a difference.
 */
#ifndef SHELL_EXPRESSION_H
#define SHELL_EXPRESSION_H

#include "language/arena.h"
#include "language/units.h"

enum { EXPRESSION_ARGUMENTS = 4, EXPRESSION_MESSAGE = 256 };

/*
 * How deeply values may be nested. Parsing and evaluating are recursive, and the parser counts the levels: a
 * parenthesis, a sign, an exponent and a call take one level each. A function that 'let' defines adds the
 * levels of its body. A "with" needs more stack than the others, so it counts as several levels.
 */
enum { NESTING_MOST = 200, NESTING_WITH = 4 };
#define NESTED_TOO_DEEPLY "the expression is nested too deeply"

/* The parser makes a TREE_NAME for each name that is not built in. The callback parse.names then resolves the
 * name and replaces the kind by TREE_NUMBER or TREE_SYMBOL. A tree can only be evaluated when all its names
 * have been resolved. */
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
struct variables;

struct tree {
    enum tree_kind kind;
    enum tree_operator op; /* for an operand of a chain: the operator before the operand */
    /* Where an error in the operation `op` is reported: at the operator or, for '^', at the exponent. */
    const char *op_at;
    const char *at;        /* where an error in this node is reported */
    struct quantity value; /* TREE_NUMBER: the number; TREE_SYMBOL: the unit, if the name has one */
    /* TREE_NAME: in "ans.margin", the name is "ans" and the key is "margin". Without '.', the key is NULL. */
    const char *name, *key;
    bool called;               /* TREE_NAME: the name is followed by arguments in parentheses */
    int count;                 /* the number of children; only a chain has more than EXPRESSION_ARGUMENTS */
    struct tree *child, *next; /* the first child and the next sibling of this node */
    const struct function *function; /* TREE_FUNCTION: the function */
    /* TREE_SYMBOL: the next three members are set by the code that resolves names */
    int symbol, index;
    const void *refers;
};

/* Why an expression cannot be parsed, resolved or evaluated. */
struct expression_error {
    const char *at; /* the position of the error in the expression */
    bool of_value;  /* the error depends on the values of parameters, and need not occur with other values */
    bool names_function; /* the message already names the 'let' function that has the error */
    /* "" if the error has already been reported as a struct problem */
    char message[EXPRESSION_MESSAGE];
};

/* Stores an error. The two macros below also store an error. Their value is false, so that a function that
 * fails can end with `return expression_wrong(...)`. */
void expression_report(struct expression_error *error, const char *at, bool of_value, const char *format, ...)
    __attribute__((format(printf, 4, 5)));
#define expression_wrong(error, at, ...)    (expression_report(error, at, false, __VA_ARGS__), false)
#define expression_no_value(error, at, ...) (expression_report(error, at, true, __VA_ARGS__), false)

struct parse {
    const char *text; /* the beginning of the expression */
    const char *end;  /* the end of the expression, or the position of an error */
    struct expression_error *error;
    struct arena *arena;
    /* Letters that are names, not units, when they stand alone after a blank. For example, if the letters are
     * "sg", then the s in "r 2 s 0.3" is the parameter s, not seconds. If this member is not NULL, the word
     * "feet" after a blank is also a name, because there is an effect called feet. */
    const char *no_unit;
    /* The names that 'let' has defined, or NULL. They hide landmarks. */
    const struct variables *variables;
    /* Resolves a name whose arguments have been parsed. On failure, sets *parse->error and returns false. If
     * the pointer is NULL, names stay as they are. */
    bool (*names)(struct parse *parse, struct tree *name);
    /* Parses a "with" after a value in parentheses, as in "(rmax with q hollow d 0.1)". The "with" begins at
     * parse->end. Returns a tree for the value and its "with", or NULL after an error. If the pointer `with`
     * itself is NULL, the parser does not accept "with". */
    struct tree *(*with)(struct parse *parse, struct tree *value);
    void *context; /* for `names` and `with` */
    /* The level of the next value, counted up to NESTING_MOST. The caller sets the level of the first one. */
    int depth;
    int deepest; /* the largest level so far */
    int nested;  /* the number of open parentheses */
    int nodes;
};

/* Parses the longest expression that begins at parse->text. After an error, sets *parse->error and returns
 * NULL. */
struct tree *expression_parse(struct parse *parse);

struct evaluation {
    struct expression_error *error;
    /* Computes the value of a TREE_SYMBOL. Returns false after an error. */
    bool (*symbol)(struct evaluation *evaluation, const struct tree *tree, struct quantity *result);
    void *context; /* for `symbol` */
    /* the number of radians in the session's angle unit, which applies to angles typed without a unit */
    domq_real angle;
};

/* After an error, sets *evaluation->error and returns false. */
bool expression_evaluate(struct evaluation *evaluation, const struct tree *tree, struct quantity *result);

/* Returns the built-in function with this name, or NULL. Stores the number of arguments of the function in
 * *arguments. */
const struct function *function_find(const char *name, int *arguments);

/* A names_list (see names.h) of the built-in names. */
const char *expression_names(const void *context, int k);

#endif
