/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "explain/formula.h"
#include "language/quad.h"
#include <stdlib.h>
#include <string.h>

/* How tightly operators bind, in increasing order. An operand that binds less tightly than required gets
 * parentheses. */
enum binding { BINDS_COMPARE, BINDS_SUM, BINDS_PRODUCT, BINDS_POWER, BINDS_WORD };

static enum binding binding(const struct tree *t);

static enum binding chain_binding(const struct tree *chain)
{
    const struct tree *second = chain->child->next;
    if (!second)
        return binding(chain->child);
    const enum tree_operator op = second->op;
    return op == OPERATOR_POWER                          ? BINDS_POWER
           : op == OPERATOR_TIMES || op == OPERATOR_OVER ? BINDS_PRODUCT
           : op == OPERATOR_PLUS || op == OPERATOR_MINUS ? BINDS_SUM
                                                         : BINDS_COMPARE;
}

static enum binding binding(const struct tree *t)
{
    return t->kind == TREE_CHAIN                          ? chain_binding(t)
           : t->kind == TREE_MINUS || t->kind == TREE_NOT ? BINDS_SUM
           : t->kind == TREE_NUMBER && t->value.value < 0 ? BINDS_SUM
                                                          : BINDS_WORD;
}

/* Returns how tightly the first operand of a chain must bind to need no parentheses. In a product, the first
 * operand may also be a negated value, as in -a*b. */
static enum binding first_binding(const struct tree *chain)
{
    enum binding level = chain_binding(chain);
    return level == BINDS_POWER                                         ? BINDS_WORD
           : level == BINDS_PRODUCT && chain->child->kind == TREE_MINUS ? BINDS_SUM
                                                                        : level;
}

/* Writes an operand, in parentheses unless it binds at least as tightly as `least`. */
static void operand(const struct formula *f, const struct tree *t, enum binding least)
{
    bool parentheses = binding(t) < least;
    if (parentheses)
        fputs(f->style == FORMULA_TEX ? "\\left(" : "(", f->out);
    formula_write(f, t);
    if (parentheses)
        fputs(f->style == FORMULA_TEX ? "\\right)" : ")", f->out);
}

void formula_number(const struct formula *f, domq_real number, int digits)
{
    char text[WIDE_TEXT];
    quad_write(number, digits, text);
    char *power = strchr(text, 'e');
    if (f->style != FORMULA_TEX || !power) {
        fputs(text, f->out);
        return;
    }
    fprintf(f->out, "%.*s \\cdot 10^{%d}", (int)(power - text), text, atoi(power + 1));
}

/* Writes the factors above or below the fraction bar. A single factor in braces needs no parentheses. */
static void factors(const struct formula *f, const struct tree *chain, bool below, bool braces)
{
    int count = 0;
    bool first = true;
    for (const struct tree *t = chain->child; t; t = t->next)
        count += (t->op == OPERATOR_OVER) == below;
    for (const struct tree *t = chain->child; t; t = t->next) {
        if ((t->op == OPERATOR_OVER) != below)
            continue;
        if (!first)
            fputs(" \\cdot ", f->out);
        operand(f, t,
                braces && count == 1 ? BINDS_COMPARE
                : first && !below    ? first_binding(chain)
                                     : BINDS_PRODUCT);
        first = false;
    }
}

/* Writes a product in TeX, with a fraction bar above the divisors. */
static void fraction(const struct formula *f, const struct tree *chain)
{
    bool divides = false;
    for (const struct tree *t = chain->child; t; t = t->next)
        divides = divides || t->op == OPERATOR_OVER;
    if (!divides) {
        factors(f, chain, false, false);
        return;
    }
    fputs("\\frac{", f->out);
    factors(f, chain, false, true);
    fputs("}{", f->out);
    factors(f, chain, true, true);
    putc('}', f->out);
}

static const char *operator_text(enum formula_style style, enum tree_operator op)
{
    static const char *const text[][FORMULA_STYLES] = {
        [OPERATOR_OR] = {" or ", " or ", " \\lor "}, [OPERATOR_AND] = {" and ", " and ", " \\land "},
        [OPERATOR_LESS] = {" < ", " < ", " < "},     [OPERATOR_AT_MOST] = {" <= ", " ≤ ", " \\le "},
        [OPERATOR_MORE] = {" > ", " > ", " > "},     [OPERATOR_AT_LEAST] = {" >= ", " ≥ ", " \\ge "},
        [OPERATOR_EQUAL] = {" == ", " = ", " = "},   [OPERATOR_UNEQUAL] = {" != ", " ≠ ", " \\ne "},
        [OPERATOR_PLUS] = {" + ", " + ", " + "},     [OPERATOR_MINUS] = {" - ", " − ", " - "},
        [OPERATOR_TIMES] = {"*", "·", " \\cdot "},   [OPERATOR_OVER] = {"/", "/", "/"},
        [OPERATOR_POWER] = {"^", "^", "^"}};
    return text[op][style];
}

static void chain(const struct formula *f, const struct tree *t)
{
    enum binding level = chain_binding(t);
    const struct tree *child = t->child;
    if (level == BINDS_PRODUCT && f->style == FORMULA_TEX) {
        fraction(f, t);
        return;
    }
    operand(f, child, first_binding(t));
    for (child = child->next; child; child = child->next) {
        fputs(operator_text(f->style, child->op), f->out);
        if (level == BINDS_POWER && f->style == FORMULA_TEX) {
            putc('{', f->out);
            formula_write(f, child);
            putc('}', f->out);
        } else
            operand(f, child, level == BINDS_POWER ? BINDS_WORD : level + 1);
    }
}

static void function(const struct formula *f, const struct tree *t)
{
    const char *name = function_name(t->function);
    bool tex = f->style == FORMULA_TEX, is_root = strcmp(name, "sqrt") == 0;
    if (tex && is_root)
        fputs("\\sqrt{", f->out);
    else if (tex && strcmp(name, "ceil") == 0)
        fputs("\\operatorname{ceil}\\left(", f->out);
    else if (tex)
        fprintf(f->out, "\\%s%s\\left(", *name == 'a' && name[1] != 'b' ? "arc" : "", name + (*name == 'a'));
    else
        fprintf(f->out, "%s(", is_root && f->style == FORMULA_LETTERS ? "√" : name);
    for (const struct tree *child = t->child; child; child = child->next) {
        formula_write(f, child);
        fputs(child->next ? ", " : "", f->out);
    }
    fputs(!tex ? ")" : is_root ? "}" : "\\right)", f->out);
}

void formula_write(const struct formula *f, const struct tree *t)
{
    switch (t->kind) {
    case TREE_NUMBER:
        formula_number(f, t->value.value, WIDE_DIGITS / 2);
        break;
    case TREE_NAME:
    case TREE_SYMBOL:
        f->name(f, t);
        break;
    case TREE_FUNCTION:
        function(f, t);
        break;
    case TREE_MINUS:
        fputs(f->style == FORMULA_LETTERS ? "−" : "-", f->out);
        operand(f, t->child, BINDS_PRODUCT);
        break;
    case TREE_CHAIN:
        chain(f, t);
        break;
    case TREE_NOT:
    case TREE_IF:
        fputs(t->kind == TREE_NOT ? "not(" : "if(", f->out);
        for (const struct tree *child = t->child; child; child = child->next) {
            formula_write(f, child);
            fputs(child->next ? ", " : "", f->out);
        }
        putc(')', f->out);
        break;
    }
}
