/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The variables and functions that 'let' defines. A function is stored as the text of its expression. */
#pragma once

#include "language/units.h"

enum { EXPRESSION_ARGUMENTS = 4, VARIABLE_NAME = 32, VARIABLES_MOST = 256 };

struct variable {
    char name[VARIABLE_NAME];
    struct quantity value; /* the value of a variable */
    char *body;            /* the text of a function; NULL for a variable */
    int count;             /* the number of arguments of a function */
    char argument[EXPRESSION_ARGUMENTS][VARIABLE_NAME];
};

struct variables {
    struct variable *list;
    size_t count;
};

const struct variable *variable_find(const struct variables *variables, const char *name);

/* Adds a copy of a variable, or replaces the variable of the same name. Returns false if memory runs out. */
bool variable_put(struct variables *variables, const struct variable *variable);

void variable_drop(struct variables *variables, const char *name);

/* Copies all variables. Returns false if memory runs out. */
bool variables_copy(struct variables *to, const struct variables *from);
bool variables_equal(const struct variables *a, const struct variables *b);
void variables_free(struct variables *variables);

/* Returns the left side of a definition, such as "f(s, d)". The text lives until the end of the block that
 * contains the call. */
enum { VARIABLE_HEAD = (EXPRESSION_ARGUMENTS + 1) * (VARIABLE_NAME + 2) };
#define variable_head(variable) variable_head_write(variable, (char[VARIABLE_HEAD]){""})
const char *variable_head_write(const struct variable *variable, char text[VARIABLE_HEAD]);

/* Writes the value of a variable as an expression, such as "0.048 m". Returns `text`. */
enum { VARIABLE_VALUE = 128 };
const char *variable_value(const struct variable *variable, char text[VARIABLE_VALUE]);
