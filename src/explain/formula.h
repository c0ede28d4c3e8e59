/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Writes an expression as a formula: as it is typed, with Greek letters, or in TeX. */
#ifndef SHELL_FORMULA_H
#define SHELL_FORMULA_H

#include "language/expression.h"
#include <stdio.h>

enum formula_style { FORMULA_PLAIN, FORMULA_LETTERS, FORMULA_TEX, FORMULA_STYLES };

struct formula {
    FILE *out;
    enum formula_style style;
    /* Writes a TREE_NAME or TREE_SYMBOL, or the number that it stands for. A negative number needs
     * parentheses. */
    void (*name)(const struct formula *formula, const struct tree *tree);
    void *context; /* for `name` */
};

void formula_write(const struct formula *formula, const struct tree *tree);

/* Writes a number in the form that the parser accepts. In TeX, an exponent is written as a power of ten. */
void formula_number(const struct formula *formula, domq_real number, int digits);

#endif
