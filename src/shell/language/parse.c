/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The syntax of expressions: operators by precedence, names, numbers with units. */
#include "language/expression.h"
#include "language/quad.h"
#include "language/text.h"
#include <ctype.h>
#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

enum { DEPTH_MAX = 100, NODES_MAX = 1000000, NAME_SIZE = 32 };

struct tree *parse_fail(struct parse *p, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(p->message, sizeof p->message, format, arguments);
    va_end(arguments);
    return NULL;
}

static struct tree *node(struct parse *p, enum tree_kind kind, const char *at)
{
    if (++p->nodes > NODES_MAX)
        return parse_fail(p, "the expression has more than %d values", NODES_MAX);
    struct tree *t = arena_take(p->arena, sizeof *t);
    if (!t)
        return parse_fail(p, "out of memory");
    t->kind = kind;
    t->at = at;
    return t;
}

/* Returns a node with one child. */
static struct tree *node_of(struct parse *p, enum tree_kind kind, const char *at, struct tree *child)
{
    struct tree *t = child ? node(p, kind, at) : NULL;
    if (!t)
        return NULL;
    t->child = child;
    t->count = 1;
    return t;
}

/* Joins a value to the last child of a chain. */
static void join(struct tree *chain, struct tree *last, enum tree_operator operator, const char * at,
                 struct tree *value)
{
    value->operator= operator;
    value->operator_at = at;
    last->next = value;
    chain->count++;
}

/* Returns true if this word is here, and no longer one. */
static bool is_word(const char *at, const char *word)
{
    size_t length = strlen(word);
    return strncmp(at, word, length) == 0 && name_length(at) == length;
}

/* ---- Values ---- */

static struct tree *chain(struct parse *p, enum tree_operator least);

/* Parses a unit after a value, with or without a blank before it; the value is a number, or in parentheses.
 */
static struct tree *postfix_unit(struct parse *p, struct tree *value)
{
    const char *c = skip_blanks(p->end);
    if (c > p->end && p->no_unit && name_length(c) == 1 && strchr(p->no_unit, *c))
        return value;
    if (c > p->end && p->no_unit && is_word(c, "feet")) /* the effect */
        return value;
    if (!name_start(*c))
        return value;
    struct quantity unit = {.value = 1};
    const char *stop = unit_scan(c, &unit);
    if (!stop)
        return c > p->end ? value : parse_fail(p, "'%.*s' is not a unit", (int)name_length(c), c);
    p->end = stop;
    if (value->kind == TREE_NUMBER && quantity_bare(value->value)) {
        unit_scan(c, &value->value);
        return value;
    }
    struct tree *chain = node_of(p, TREE_CHAIN, c, value), *factor = chain ? node(p, TREE_NUMBER, c) : NULL;
    if (!factor)
        return NULL;
    factor->value = unit;
    join(chain, value, OPERATOR_TIMES, c, factor);
    return chain;
}

static struct tree *number(struct parse *p)
{
    const char *begin = p->end;
    if (begin[0] == '0' && (begin[1] == 'x' || begin[1] == 'X'))
        return parse_fail(p, "is not a decimal number");
    struct tree *t = node(p, TREE_NUMBER, begin);
    if (!t)
        return NULL;
    char *stop;
    errno = 0;
    t->value.value = quad_read(begin, &stop);
    if (errno == ERANGE)
        return parse_fail(p, quad(fabs)(t->value.value) > 1 ? "is too large for a number"
                                                            : "is too small for a number");
    p->end = stop;
    return postfix_unit(p, t);
}

/* Parses "(a, b)" after a name; "()" has no values. */
static bool call(struct parse *p, struct tree *name)
{
    struct tree **last = &name->child;
    name->called = true;
    p->nested++;
    p->end = skip_blanks(p->end + 1);
    while (*p->end != ')') {
        if (name->count == EXPRESSION_ARGUMENTS)
            return parse_fail(p, "too many values") != NULL;
        struct tree *value = chain(p, OPERATOR_OR);
        if (!value)
            return false;
        *last = value;
        last = &value->next;
        name->count++;
        p->end = skip_blanks(p->end);
        if (*p->end == ')')
            break;
        if (*p->end != ',')
            return parse_fail(p, "',' or ')' is missing") != NULL;
        p->end = skip_blanks(p->end + 1);
        if (*p->end == ')')
            return parse_fail(p, "a value is missing after ','") != NULL;
    }
    p->nested--;
    p->end++;
    return true;
}

static struct tree *name(struct parse *p)
{
    const char *at = p->end;
    size_t length = name_length(at);
    if (length >= NAME_SIZE)
        return parse_fail(p, "this name is too long");
    struct tree *t = node(p, TREE_NAME, at);
    if (!t || !(t->name = arena_text(p->arena, at, length)))
        return parse_fail(p, "out of memory");
    p->end += length;
    if (*p->end == '(' && !call(p, t))
        return NULL;
    if (t->called && strcmp(t->name, "if") == 0) {
        if (t->count != 3) {
            p->end = at;
            return parse_fail(p, "if takes a condition and two values, as in 'if(r > 1.5, 1, 0)'");
        }
        t->kind = TREE_IF;
        return t;
    }
    int wanted;
    if (t->called && (t->function = function_find(t->name, &wanted)) != NULL) {
        t->kind = TREE_FUNCTION;
        if (t->count == wanted)
            return t;
        p->end = at;
        return parse_fail(p, "%s takes %d value%s", t->name, wanted, wanted == 1 ? "" : "s");
    }
    if (!t->called && strcmp(t->name, "pi") == 0) {
        t->kind = TREE_NUMBER;
        t->value.value = QUAD_PI;
        return t;
    }
    if (p->end[0] == '.' && name_start(p->end[1])) {
        size_t n = name_length(p->end + 1);
        if (!(t->key = arena_text(p->arena, p->end + 1, n)))
            return parse_fail(p, "out of memory");
        p->end += 1 + n;
    }
    return t;
}

static struct tree *in_parentheses(struct parse *p)
{
    const char *open = p->end++;
    p->nested++;
    p->end = skip_blanks(p->end);
    struct tree *t = chain(p, OPERATOR_OR);
    p->end = t ? skip_blanks(p->end) : p->end;
    if (t && p->with && is_word(p->end, "with"))
        t = p->with(p, t);
    if (!t)
        return NULL;
    p->nested--;
    p->end = skip_blanks(p->end);
    if (*p->end != ')') {
        p->end = open;
        return parse_fail(p, "this '(' is never closed");
    }
    p->end++;
    return postfix_unit(p, t);
}

static struct tree *primary(struct parse *p)
{
    char c = *p->end;
    if (isdigit((unsigned char)c) || (c == '.' && isdigit((unsigned char)p->end[1])))
        return number(p);
    if (name_start(c))
        return name(p);
    if (c == '(')
        return in_parentheses(p);
    if (c == '*' && p->end > p->text && p->end[-1] == '*')
        return parse_fail(p, "a power is written with '^', as in '2^10'");
    return parse_fail(p, c ? "a value is missing" : "a value is missing at the end");
}

/* ---- Operators ---- */

/* Returns the operator that begins with this character, and its length; equal: a '=' follows. */
static enum tree_operator operator_of(char c, bool equal, size_t *length)
{
    *length = equal && strchr("<>=!", c) ? 2 : 1;
    switch (c) {
    case '<':
        return equal ? OPERATOR_AT_MOST : OPERATOR_LESS;
    case '>':
        return equal ? OPERATOR_AT_LEAST : OPERATOR_MORE;
    case '=':
        return equal ? OPERATOR_EQUAL : OPERATOR_NONE;
    case '!':
        return equal ? OPERATOR_UNEQUAL : OPERATOR_NONE;
    case '+':
        return OPERATOR_PLUS;
    case '-':
        return OPERATOR_MINUS;
    case '*':
        return OPERATOR_TIMES;
    case '/':
        return OPERATOR_OVER;
    case '^':
        return OPERATOR_POWER;
    default:
        return OPERATOR_NONE;
    }
}

/*
 * Returns the operator at this place, the end of a value and blanks, and its length. A bare '>' is the file
 * of an answer, so that it compares only in parentheses; "1 -2" are two values: an argument, and one that
 * begins with its sign.
 */
static enum tree_operator operator_at(const struct parse *p, const char *at, size_t *length)
{
    if (*at == 'a' || *at == 'o') {
        enum tree_operator word = is_word(at, "and")  ? OPERATOR_AND
                                  : is_word(at, "or") ? OPERATOR_OR
                                                      : OPERATOR_NONE;
        *length = word == OPERATOR_AND ? 3 : 2;
        return word;
    }
    enum tree_operator operator= * at ? operator_of(*at, at[1] == '=', length) : OPERATOR_NONE;
    bool sign = operator== OPERATOR_PLUS || operator== OPERATOR_MINUS;
    bool file = operator== OPERATOR_MORE && p->nested == 0;
    bool value = sign && at != p->end && skip_blanks(at + 1) == at + 1;
    return file || value ? OPERATOR_NONE : operator;
}

/* Returns the first operator of those that bind as tightly as this one. */
static enum tree_operator precedence(enum tree_operator operator)
{
    if (operator>= OPERATOR_LESS && operator<= OPERATOR_UNEQUAL)
        return OPERATOR_LESS;
    return operator== OPERATOR_MINUS ? OPERATOR_PLUS : operator== OPERATOR_OVER ? OPERATOR_TIMES : operator;
}

/* Returns the first of the operators that bind more tightly than this first one of its kind. */
static enum tree_operator tighter(enum tree_operator kind)
{
    return kind == OPERATOR_LESS    ? OPERATOR_PLUS
           : kind == OPERATOR_PLUS  ? OPERATOR_TIMES
           : kind == OPERATOR_TIMES ? OPERATOR_POWER
                                    : kind + 1;
}

/* Parses a sign, 'not', or a value with its power: -2^2 is -(2^2). */
static struct tree *factor(struct parse *p)
{
    const char *at = p->end;
    if (++p->depth > DEPTH_MAX)
        return parse_fail(p, "the expression is nested too deeply");
    struct tree *t;
    if (*at == '-' || *at == '+') {
        p->end = skip_blanks(at + 1);
        t = factor(p);
        if (*at == '-')
            t = node_of(p, TREE_MINUS, at, t);
    } else if (*at == 'n' && is_word(at, "not")) {
        p->end = skip_blanks(at + strlen("not"));
        t = node_of(p, TREE_NOT, at, chain(p, OPERATOR_LESS));
    } else
        t = primary(p);
    const char *power = t ? skip_blanks(p->end) : "";
    if (*power == '^') {
        p->end = skip_blanks(power + 1);
        const char *exponent_at = p->end;
        struct tree *exponent = factor(p), *base = t;
        t = exponent ? node_of(p, TREE_CHAIN, power, base) : NULL;
        if (t)
            join(t, base, OPERATOR_POWER, exponent_at, exponent);
    }
    p->depth--;
    return t;
}

/* Parses values joined by operators that bind at least as tightly as this one. */
static struct tree *chain(struct parse *p, enum tree_operator least)
{
    size_t length = 0;
    struct tree *left = factor(p), *last = NULL;
    enum tree_operator of =
        OPERATOR_NONE; /* the kind of operators in the chain `left`; none: it is no such chain */
    while (left) {
        const char *at = skip_blanks(p->end);
        enum tree_operator operator= operator_at(p, at, &length), kind = precedence(operator);
        if (operator== OPERATOR_NONE || kind<least)
            break;
        if (kind == OPERATOR_LESS && of == kind) {
            p->end = at;
            return parse_fail(p, "two values are compared, and comparisons joined by 'and'");
        }
        p->end = skip_blanks(at + length);
        struct tree *right = chain(p, tighter(kind));
        if (!right)
            return NULL;
        if (of != kind) {
            last = left;
            left = node_of(p, TREE_CHAIN, left->at, left);
            of = kind;
        }
        if (left) {
            join(left, last, operator, at, right);
            last = right;
        }
    }
    return left;
}

struct tree *expression_parse(struct parse *p)
{
    p->end = p->text;
    p->message[0] = '\0';
    p->depth = p->nested = p->nodes = 0;
    return chain(p, OPERATOR_OR);
}
