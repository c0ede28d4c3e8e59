/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Values as people write them: 7/48, pi/18, 10 deg, 4.8 cm, 0.9*s, rmax(0.3), ans.margin.
 *
 * Where an argument ends: at a blank that no operator bridges ("1 - 2" is one value, "1 -2" are two).
 */
#ifndef SHELL_EXPRESSION_H
#define SHELL_EXPRESSION_H

#include "language/units.h"

enum { EXPRESSION_ARGUMENTS = 4, EXPRESSION_MESSAGE = 256 };

struct expression {
    const char *text; /* where it begins */
    const char *end;  /* the end of the expression; after an error, the place of the error */
    char message[EXPRESSION_MESSAGE];
    bool of_value; /* the error is in the values: with others the same expression may have one */
    /*
     * Names that are neither constants nor functions of the language: parameters, answers, the field's
     * functions; key is what follows a dot, or NULL.  False with a message if there is no such thing.
     */
    bool (*lookup)(struct expression *expression, const char *name, const char *key,
                   const struct quantity *arguments, int count, struct quantity *result);
    void *context;       /* for lookup */
    const char *no_unit; /* letters that are no units after a blank, but names; NULL: none */
    domq_real angle;     /* what 1 is in radians where a bare number stands for an angle */
    int depth;           /* of nested values so far: 0, or that of the expression that calls a function */
    bool named;          /* the message names the function that it is about */
    bool dry;            /* only reads: no name is looked up, and every value is 1 */
};

/* Evaluates the longest expression at expression->text, once.  Returns false after an error: see message and
 * end.
 */
bool expression_evaluate(struct expression *expression, struct quantity *result);

/* Sets the message of an error in the line, or in its values; the names below are also the value false. */
void expression_message(struct expression *expression, bool of_value, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
#define expression_fail(e, ...)     (expression_message(e, false, __VA_ARGS__), false)
#define expression_no_value(e, ...) (expression_message(e, true, __VA_ARGS__), false)

/* Lists for names.h the names that the language itself has. */
const char *expression_names(const void *context, int k);

#endif
