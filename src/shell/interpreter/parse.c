/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Parses expressions by recursive descent. */
#include "interpreter/question.h"
#include "language/quad.h"
#include "language/text.h"
#include "language/units.h"
#include <ctype.h>
#include <errno.h>
#include <string.h>

enum { NODES_MAX = 1000000, NAME_SIZE = 32 };

/* Reports a syntax error at r->at. The value of the macro is NULL. */
#define parse_fail(r, ...) (expression_wrong((r)->problem, (r)->at, __VA_ARGS__) ? (struct tree *)NULL : NULL)

static struct tree *make_node(struct reader *r, evaluator *compute, const char *at)
{
    if (++r->nodes > NODES_MAX)
        return parse_fail(r, "the expression has more than %d values", NODES_MAX);
    struct tree *t = reader_memory(r, sizeof *t);
    if (!t)
        return NULL;
    t->compute = compute;
    t->at = at;
    return t;
}

/* Makes a node with one child. If the child is NULL because of an error, returns NULL as well. */
static struct tree *make_parent(struct reader *r, evaluator *compute, const char *at, struct tree *child)
{
    struct tree *t = child ? make_node(r, compute, at) : NULL;
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

/* Makes a chain of two values. If one of them is NULL because of an error, returns NULL as well. */
static struct tree *join(struct reader *r, const char *at, struct tree *left, char op, const char *op_at,
                         struct tree *right)
{
    struct tree *t = right ? make_parent(r, chain_value, at, left) : NULL;
    if (t)
        append(t, left, op, op_at, right);
    return t;
}

/* Returns true if the text begins with `word`, and not with a longer word. */
static bool is_word(const char *at, const char *word)
{
    size_t length = strlen(word);
    return strncmp(at, word, length) == 0 && name_length(at) == length;
}

static bool is_plain_number(const struct tree *t)
{
    return t->compute == number_value && quantity_is_number(t->value);
}

/* ---- Parsing values ---- */

/* The levels of precedence. Operators of the first level bind most loosely. */
enum level { LEVEL_OR, LEVEL_AND, LEVEL_COMPARE, LEVEL_SUM, LEVEL_PRODUCT, LEVEL_POWER };

static struct tree *parse_chain(struct reader *r, enum level least);

/* Parses the unit after a number or a ')', if there is one. Returns the value with its unit, or NULL after an
 * error. */
static struct tree *parse_unit(struct reader *r, struct tree *value)
{
    const char *c = skip_blanks(r->at);
    const bool is_apart = c > r->at,
               is_name = is_apart && r->no_unit &&
                         ((name_length(c) == 1 && strchr(r->no_unit, *c)) || is_word(c, "feet"));
    struct quantity unit = {.value = 1};
    if (*c == '%' && is_plain_number(value)) {
        value->value.value /= 100;
        r->at = c + 1;
        return value;
    }
    if (!name_start(*c) || is_name)
        return value;
    const char *stop = unit_scan(c, &unit);
    if (!stop)
        return is_apart ? value : parse_fail(r, "'%.*s' is not a unit", (int)name_length(c), c);
    r->at = stop;
    if (is_plain_number(value)) {
        unit_scan(c, &value->value);
        if (isfinite(value->value.value))
            return value;
        r->at = value->at;
        return parse_fail(r, "this number is too large");
    }
    struct tree *factor = make_node(r, number_value, c);
    if (factor)
        factor->value = unit;
    return join(r, c, value, '*', c, factor);
}

static struct tree *parse_number(struct reader *r)
{
    const char *begin = r->at;
    if (begin[0] == '0' && (begin[1] == 'x' || begin[1] == 'X'))
        return parse_fail(r, "this is not a decimal number");
    struct tree *t = make_node(r, number_value, begin);
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
    for (bool more = *r->at != ')'; more; name->count++) {
        if (name->count == EXPRESSION_ARGUMENTS)
            return parse_fail(r, "too many values") != NULL;
        struct tree *value = *last = parse_chain(r, LEVEL_OR);
        if (!value)
            return false;
        last = &value->next;
        r->at = skip_blanks(r->at);
        more = *r->at == ',';
        if (!more && *r->at != ')')
            return parse_fail(r, "',' or ')' is missing") != NULL;
        r->at = skip_blanks(r->at + more);
    }
    r->nested--;
    r->at++;
    return true;
}

/* Resolves the name of a built-in value or function. Returns false after an error. Other names stay as they
 * are. */
static bool built_in_resolve(struct reader *r, struct tree *t)
{
    int wanted = 0;
    const struct function *f = t->called ? function_find(t->name, &wanted) : NULL;
    if (!t->called && strcmp(t->name, "pi") == 0) {
        t->compute = number_value;
        t->value.value = QUAD_PI;
    }
    if (f && t->count == wanted) {
        t->compute = wanted == 3 ? if_value : function_value;
        t->refers = f;
    }
    if (!f || t->count == wanted)
        return true;
    if (aggregates && aggregates->resolve(r, t)) /* a function of a column, as in max(chain(0).weight) */
        return t->compute || !r->names;
    r->at = t->at;
    if (wanted == 3)
        (void)parse_fail(r, "'if' takes a condition and two values, as in 'if(r > 1.5, 1, 0)'");
    else
        (void)parse_fail(r, "%s takes %d value%s", t->name, wanted, wanted == 1 ? "" : "s");
    return false;
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
    const bool has_blanks = r->query && isalnum((unsigned char)*skip_blanks(at + length)) &&
                            feature_value(at, &name, &end, &value) && end > at + length &&
                            !variable_find(&r->query->state->variables, first);
    length = has_blanks ? (size_t)(end - at) : length;
    struct tree *t = make_node(r, NULL, at);
    if (!t || !(t->name = has_blanks ? name : reader_copy(r, at, length)))
        return NULL;
    r->at += length;
    if ((*r->at == '(' && !parse_arguments(r, t)) || !built_in_resolve(r, t))
        return NULL;
    if (t->compute)
        return t;
    if (r->at[0] == '.' && name_start(r->at[1])) {
        size_t n = name_length(r->at + 1);
        if (!(t->key = reader_copy(r, r->at + 1, n)))
            return NULL;
        r->at += 1 + n;
    }
    return !r->names || r->names(r, t) ? t : NULL;
}

static struct tree *parse_primary(struct reader *r)
{
    const char c = *r->at, *open = r->at;
    if (isdigit((unsigned char)c) || (c == '.' && isdigit((unsigned char)r->at[1])))
        return parse_number(r);
    if (name_start(c))
        return parse_name(r);
    if (c != '(')
        return parse_fail(r, c ? "a value is missing" : "a value is missing at the end");
    r->nested++;
    r->at = skip_blanks(r->at + 1);
    struct tree *t = parse_chain(r, LEVEL_OR);
    if (!t)
        return NULL;
    r->nested--;
    r->at = skip_blanks(r->at);
    if (word_is_next(r, "with"))
        return parse_fail(r, "'with' belongs at the end of the command, as in '2*rmax with q hollow'");
    if (*r->at != ')' && strchr(r->at, ')'))
        return parse_fail(
            r, "an operator or a ')' is missing; in an expression, write 'rmax(0.4)' for 'rmax 0.4'");
    if (*r->at != ')') {
        r->at = open;
        return parse_fail(r, "this '(' is never closed");
    }
    r->at++;
    return parse_unit(r, t);
}

/* ---- Parsing operators ---- */

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
    if (command_ends(at))
        return NULL;
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
        return parse_fail(r, "the expression is nested too deeply");
    struct tree *t;
    if (*at == '-' || *at == '+') {
        r->at = skip_blanks(at + 1);
        t = parse_factor(r);
        if (*at == '-')
            t = make_parent(r, minus_value, at, t);
    } else if (*at == 'n' && is_word(at, "not")) {
        r->at = skip_blanks(at + strlen("not"));
        t = make_parent(r, not_value, at, parse_chain(r, LEVEL_COMPARE));
    } else
        t = parse_primary(r);
    const char *power = t ? skip_blanks(r->at) : "";
    if (*power == '^') {
        const char *exponent = r->at = skip_blanks(power + 1);
        t = join(r, power, t, '^', exponent, parse_factor(r));
    }
    r->depth--;
    return t;
}

/* People write 3/8 in for (3/8) in. If `over` is a number with a unit, moves its unit to the number `top`. */
static void unit_move(struct tree *top, struct tree *over)
{
    char *end;
    struct tree *number = top->compute == minus_value ? top->child : top;
    if (!is_plain_number(number) || over->compute != number_value || !isdigit((unsigned char)*over->at))
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
    struct tree *left = parse_factor(r), *last = left;
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
            unit_move(last, right);
        if (before && before->level == op->level)
            append(left, last, op->op, at, right);
        else
            left = join(r, left->at, left, op->op, at, right);
        last = right;
        before = op;
    }
    return left;
}

struct tree *expression_parse(struct reader *r)
{
    r->nested = 0;
    return parse_chain(r, LEVEL_OR);
}
