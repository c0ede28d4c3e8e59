/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Parses expressions by recursive descent. */
#include "interpreter/question.h"
#include "language/quad.h"
#include "language/text.h"
#include "language/variables.h"
#include <ctype.h>
#include <errno.h>
#include <string.h>

enum { NODES_MAX = 1000000, NAME_SIZE = 32 };

/* Reports a syntax error at r->at. The value of the macro is NULL. */
#define parse_fail(r, ...) (expression_wrong((r)->problem, (r)->at, __VA_ARGS__) ? (struct tree *)NULL : NULL)

static struct tree *make_node(struct reader *r, enum tree_kind kind, const char *at)
{
    if (++r->nodes > NODES_MAX)
        return parse_fail(r, "the expression has more than %d values", NODES_MAX);
    struct tree *t = reader_memory(r, sizeof *t);
    if (!t)
        return NULL;
    t->kind = kind;
    t->at = at;
    return t;
}

/* Makes a node with one child. If the child is NULL because of an error, returns NULL as well. */
static struct tree *make_parent(struct reader *r, enum tree_kind kind, const char *at, struct tree *child)
{
    struct tree *t = child ? make_node(r, kind, at) : NULL;
    if (!t)
        return NULL;
    t->child = child;
    t->count = 1;
    return t;
}

/* Appends an operand to a chain. `op` is the operator before the operand, and `last` is the last child of the
 * chain so far. */
static void append(struct tree *chain, struct tree *last, char op, const char *at, struct tree *value)
{
    value->op = op;
    value->op_at = at;
    last->next = value;
    chain->count++;
}

/* Returns true if the text begins with `word`, and not with a longer word. */
static bool is_word(const char *at, const char *word)
{
    size_t length = strlen(word);
    return strncmp(at, word, length) == 0 && name_length(at) == length;
}

/* ---- Values ---- */

/* The levels of precedence. Operators of the first level bind most loosely. */
enum level { LEVEL_OR, LEVEL_AND, LEVEL_COMPARE, LEVEL_SUM, LEVEL_PRODUCT, LEVEL_POWER };

static struct tree *parse_chain(struct reader *r, enum level least);

/* Parses the unit after a number or a ')', if there is one. Returns the value with its unit, or NULL after an
 * error. */
static struct tree *parse_unit(struct reader *r, struct tree *value)
{
    const char *c = skip_blanks(r->at);
    if (c > r->at && r->no_unit && name_length(c) == 1 && strchr(r->no_unit, *c))
        return value;
    if (c > r->at && r->no_unit && is_word(c, "feet"))
        return value;
    if (*c == '%' && value->kind == TREE_NUMBER && quantity_is_number(value->value)) {
        value->value.value /= 100;
        r->at = c + 1;
        return value;
    }
    if (!name_start(*c))
        return value;
    struct quantity unit = {.value = 1};
    const char *stop = unit_scan(c, &unit);
    if (!stop)
        return c > r->at ? value : parse_fail(r, "'%.*s' is not a unit", (int)name_length(c), c);
    r->at = stop;
    if (value->kind == TREE_NUMBER && quantity_is_number(value->value)) {
        unit_scan(c, &value->value);
        return value;
    }
    struct tree *chain = make_parent(r, TREE_CHAIN, c, value),
                *factor = chain ? make_node(r, TREE_NUMBER, c) : NULL;
    if (!factor)
        return NULL;
    factor->value = unit;
    append(chain, value, '*', c, factor);
    return chain;
}

static struct tree *parse_number(struct reader *r)
{
    const char *begin = r->at;
    if (begin[0] == '0' && (begin[1] == 'x' || begin[1] == 'X'))
        return parse_fail(r, "this is not a decimal number");
    struct tree *t = make_node(r, TREE_NUMBER, begin);
    if (!t)
        return NULL;
    char *stop;
    errno = 0;
    t->value.value = quad_read(begin, &stop);
    if (errno == ERANGE)
        return parse_fail(r, quad(fabs)(t->value.value) > 1 ? "this number is too large"
                                                            : "this number is too close to 0");
    r->at = stop;
    return parse_unit(r, t);
}

/* Parses the arguments of a name, as in "(a, b)" or "()". */
static bool parse_arguments(struct reader *r, struct tree *name)
{
    struct tree **last = &name->child;
    name->called = true;
    r->nested++;
    r->at = skip_blanks(r->at + 1);
    while (*r->at != ')') {
        if (name->count == EXPRESSION_ARGUMENTS)
            return parse_fail(r, "too many values") != NULL;
        struct tree *value = parse_chain(r, LEVEL_OR);
        if (!value)
            return false;
        *last = value;
        last = &value->next;
        name->count++;
        r->at = skip_blanks(r->at);
        if (*r->at == ')')
            break;
        if (*r->at != ',')
            return parse_fail(r, "',' or ')' is missing") != NULL;
        r->at = skip_blanks(r->at + 1);
        if (*r->at == ')')
            return parse_fail(r, "a value is missing after ','") != NULL;
    }
    r->nested--;
    r->at++;
    return true;
}

static struct tree *parse_name(struct reader *r)
{
    const char *at = r->at, *end, *name;
    struct quantity value;
    char first[NAME_SIZE];
    size_t length = name_length(at);
    if (!name_copy(at, length, first, sizeof first))
        return parse_fail(r, "this name is too long");
    /* a name that contains blanks, as in "big ben", unless its first word is a variable */
    const bool has_blanks = r->query && feature_value(at, &name, &end, &value) && end > at + length &&
                            !variable_find(&r->query->state->variables, first);
    length = has_blanks ? (size_t)(end - at) : length;
    struct tree *t = make_node(r, TREE_NAME, at);
    if (!t || !(t->name = has_blanks ? name : reader_copy(r, at, length)))
        return NULL;
    r->at += length;
    if (*r->at == '(' && !parse_arguments(r, t))
        return NULL;
    if (t->called && strcmp(t->name, "if") == 0) {
        if (t->count != 3) {
            r->at = at;
            return parse_fail(r, "'if' takes a condition and two values, as in 'if(r > 1.5, 1, 0)'");
        }
        t->kind = TREE_IF;
        return t;
    }
    int wanted;
    if (t->called && (t->function = function_find(t->name, &wanted)) != NULL) {
        t->kind = TREE_FUNCTION;
        if (t->count == wanted)
            return t;
        t->kind = TREE_NAME; /* perhaps of a column, as in max(chain(0).weight) */
        if (t->count != 1 || (strcmp(t->name, "min") != 0 && strcmp(t->name, "max") != 0)) {
            r->at = at;
            return parse_fail(r, "%s takes %d value%s", t->name, wanted, wanted == 1 ? "" : "s");
        }
    }
    if (!t->called && strcmp(t->name, "pi") == 0) {
        t->kind = TREE_NUMBER;
        t->value.value = QUAD_PI;
        return t;
    }
    if (r->at[0] == '.' && name_start(r->at[1])) {
        size_t n = name_length(r->at + 1);
        if (!(t->key = reader_copy(r, r->at + 1, n)))
            return NULL;
        r->at += 1 + n;
    }
    return !r->names || r->names(r, t) ? t : NULL;
}

static struct tree *parse_parentheses(struct reader *r)
{
    const char *open = r->at++;
    r->nested++;
    r->at = skip_blanks(r->at);
    struct tree *t = parse_chain(r, LEVEL_OR);
    r->at = t ? skip_blanks(r->at) : r->at;
    if (!t)
        return NULL;
    r->nested--;
    r->at = skip_blanks(r->at);
    if (*r->at != ')') {
        r->at = open;
        return parse_fail(r, "this '(' is never closed");
    }
    r->at++;
    return parse_unit(r, t);
}

static struct tree *parse_primary(struct reader *r)
{
    char c = *r->at;
    if (isdigit((unsigned char)c) || (c == '.' && isdigit((unsigned char)r->at[1])))
        return parse_number(r);
    if (name_start(c))
        return parse_name(r);
    if (c == '(')
        return parse_parentheses(r);
    return parse_fail(r, c ? "a value is missing" : "a value is missing at the end");
}

/* ---- Operators ---- */

/* "<=" comes before its prefix "<". parse_factor handles '^'. */
static const struct op {
    const char *text;
    char op; /* as in struct tree */
    enum level level;
} operators[] = {
    {"+", '+', LEVEL_SUM},      {"-", '-', LEVEL_SUM},      {"*", '*', LEVEL_PRODUCT},
    {"/", '/', LEVEL_PRODUCT},  {"<=", 'l', LEVEL_COMPARE}, {">=", 'g', LEVEL_COMPARE},
    {"==", '=', LEVEL_COMPARE}, {"!=", '!', LEVEL_COMPARE}, {"<", '<', LEVEL_COMPARE},
    {">", '>', LEVEL_COMPARE},  {"and", '&', LEVEL_AND},    {"or", '|', LEVEL_OR},
};

/* Returns the operator that continues an expression, or NULL if there is none. `at` is the first position
 * after a value and the blanks that follow it. Outside parentheses, there are two exceptions. A '>' is not an
 * operator, because it redirects the answer. In "1 -2", the sign is not an operator, because it begins a
 * second value. */
static const struct op *op_at(const struct reader *r, const char *at)
{
    const struct op *op = NULL;
    for (size_t k = 0; k < sizeof operators / sizeof *operators && !op; k++) {
        const char *text = operators[k].text;
        if (*at == *text && (name_start(*text) ? is_word(at, text) : strncmp(at, text, strlen(text)) == 0))
            op = &operators[k];
    }
    if (!op)
        return NULL;
    bool is_sign = op->level == LEVEL_SUM && at != r->at && skip_blanks(at + 1) == at + 1;
    bool redirects = op->op == '>';
    return (is_sign || redirects) && r->nested == 0 ? NULL : op;
}

bool goes_on(const char *c)
{
    const struct reader r = {.at = isspace((unsigned char)c[-1]) ? c - 1 : c};
    return *c == '^' || op_at(&r, c) || (is_word(c, "to") && isspace((unsigned char)c[2]));
}

/* Parses a value. It may have an exponent after it, and signs or a 'not' before it. An exponent binds more
 * tightly than a sign, so -2^2 is -(2^2). */
static struct tree *parse_factor(struct reader *r)
{
    const char *at = r->at;
    if (++r->depth > NESTING_MOST)
        return parse_fail(r, NESTED_TOO_DEEPLY);
    r->deepest = r->depth > r->deepest ? r->depth : r->deepest;
    struct tree *t;
    if (*at == '-' || *at == '+') {
        r->at = skip_blanks(at + 1);
        t = parse_factor(r);
        if (*at == '-')
            t = make_parent(r, TREE_MINUS, at, t);
    } else if (*at == 'n' && is_word(at, "not")) {
        r->at = skip_blanks(at + strlen("not"));
        t = make_parent(r, TREE_NOT, at, parse_chain(r, LEVEL_COMPARE));
    } else
        t = parse_primary(r);
    const char *power = t ? skip_blanks(r->at) : "";
    if (*power == '^') {
        r->at = skip_blanks(power + 1);
        const char *exponent_at = r->at;
        struct tree *exponent = parse_factor(r), *base = t;
        t = exponent ? make_parent(r, TREE_CHAIN, power, base) : NULL;
        if (t)
            append(t, base, '^', exponent_at, exponent);
    }
    r->depth--;
    return t;
}

/* People write 3/8 in for (3/8) in. If `over` is a number with a unit, moves its unit to the number `top`. */
static void unit_move(struct tree *top, struct tree *over)
{
    char *end;
    struct tree *number = top->kind == TREE_MINUS ? top->child : top;
    if (number->kind != TREE_NUMBER || over->kind != TREE_NUMBER || !quantity_is_number(number->value) ||
        !isdigit((unsigned char)*over->at))
        return;
    const struct quantity plain = {.value = quad_read(over->at, &end)};
    const char *unit = skip_blanks(end);
    if (!quantity_is_number(over->value))
        unit_scan(unit, &number->value);
    else if (*unit == '%')
        number->value.value /= 100;
    else
        return;
    over->value = plain;
}

/* Parses values that are joined by operators of the level `least` or of higher levels. Operators of higher
 * levels bind more tightly. */
static struct tree *parse_chain(struct reader *r, enum level least)
{
    struct tree *left = parse_factor(r), *last = NULL;
    /* the last operator of the chain `left`, or NULL if `left` is not a chain yet */
    const struct op *before = NULL;
    while (left) {
        const char *at = skip_blanks(r->at);
        const struct op *op = op_at(r, at);
        if (!op || op->level < least)
            break;
        if (before && before->level == LEVEL_COMPARE && op->level == LEVEL_COMPARE) {
            r->at = at;
            return parse_fail(
                r, "a comparison has two values; join comparisons with 'and', as in '1 < r and r < 2'");
        }
        r->at = skip_blanks(at + strlen(op->text));
        struct tree *right = parse_chain(r, op->level + 1);
        if (!right)
            return NULL;
        if (op->op == '/' && !(before && before->op == '/'))
            unit_move(before ? last : left, right);
        if (!before || before->level != op->level) {
            last = left;
            left = make_parent(r, TREE_CHAIN, left->at, left);
        }
        before = op;
        if (left) {
            append(left, last, op->op, at, right);
            last = right;
        }
    }
    return left;
}

struct tree *expression_parse(struct reader *r)
{
    r->nested = r->nodes = 0;
    return parse_chain(r, LEVEL_OR);
}
