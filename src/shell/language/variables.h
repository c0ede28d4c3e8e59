/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What 'let' defines: variables, which hold a value, and functions, which hold the text of an expression. */
#ifndef SHELL_VARIABLES_H
#define SHELL_VARIABLES_H

#include "language/expression.h"

enum { VARIABLE_NAME = 32, VARIABLES_MOST = 256 };

struct variable {
    char name[VARIABLE_NAME];
    struct quantity value;                              /* of a variable */
    char *body;                                         /* of a function; NULL: a variable */
    int count;                                          /* arguments of a function */
    char argument[EXPRESSION_ARGUMENTS][VARIABLE_NAME]; /* their names */
};

struct variables {
    struct variable *list;
    size_t count;
};

const struct variable *variable_find(const struct variables *variables, const char *name);

/* Keeps a variable, which replaces an earlier one of this name; its body is copied.  False: no memory. */
bool variable_put(struct variables *variables, const struct variable *variable);

/* Forgets a variable or function; nothing happens if there is none of this name. */
void variable_drop(struct variables *variables, const char *name);

/* Copies all variables; returns false without memory. */
bool variables_copy(struct variables *to, const struct variables *from);
bool variables_equal(const struct variables *a, const struct variables *b);
void variables_free(struct variables *variables);

/* Writes "x" or "f(s, d)"; and what it stands for, as an expression: "0.048 m", "rmax(s)*s". */
enum { VARIABLE_HEAD = (EXPRESSION_ARGUMENTS + 1) * (VARIABLE_NAME + 2) };
const char *variable_head(const struct variable *variable, char text[VARIABLE_HEAD]);
enum { VARIABLE_VALUE = 128 };
const char *variable_value(const struct variable *variable, char text[VARIABLE_VALUE]);

#endif
