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

#include "language/variables.h"
#include "session/query.h"

/*
 * How deeply values may be nested. Parsing and evaluating are recursive, and the parser counts the levels: a
 * parenthesis, a sign, an exponent and a call take one level each. A function that 'let' defines adds the
 * levels of its body. A "with" needs more stack than the others, so it counts as several levels.
 */
enum { NESTING_MOST = 200, NESTING_WITH = 4 };
#define NESTED_TOO_DEEPLY "the expression is nested too deeply"

/* The parser makes a TREE_NAME for each name that is not built in. The callback reader.names then resolves
 * the name and replaces the kind by TREE_NUMBER or TREE_SYMBOL. A tree can only be evaluated when all its
 * names have been resolved. */
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
struct reader;

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

/* Report an error in an expression: one in the expression itself, or one that depends on the values of
 * parameters, and need not occur with other values. Both are false, so that a function that fails can end
 * with `return expression_wrong(...)`. */
#define expression_wrong(problem, at_, ...) ((problem)->at = (at_), problem_error(problem, __VA_ARGS__))
#define expression_no_value(problem, at_, ...)                                                               \
    ((problem)->at = (at_), problem_no_answer(problem, __VA_ARGS__))

/* Parses the longest expression at the reader's position, and moves the reader to its end. After an error,
 * sets the reader's problem, leaves the reader at the place of the error, and returns NULL. */
struct tree *expression_parse(struct reader *reader);

struct rows;

struct evaluation {
    struct problem *problem;
    const struct query *query;
    const struct quantity *argument; /* the arguments of the 'let' function that is being evaluated */
    struct rows *rows;               /* the table of the aggregate that is being evaluated */
    /* Computes the value of a TREE_SYMBOL. Returns false after an error. */
    bool (*symbol)(struct evaluation *evaluation, const struct tree *tree, struct quantity *result);
    void *context; /* for `symbol` */
    /* the number of radians in the session's angle unit, which applies to angles typed without a unit */
    domq_real angle;
};

/* After an error, sets evaluation->problem and returns false. */
bool expression_evaluate(struct evaluation *evaluation, const struct tree *tree, struct quantity *result);

/* Returns the built-in function with this name, or NULL. Stores the number of arguments of the function in
 * *arguments. */
const struct function *function_find(const char *name, int *arguments);

/* A names_list (see names.h) of the built-in names. */
const char *expression_names(const void *context, int k);

#endif
