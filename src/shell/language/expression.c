/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "language/expression.h"
#include "language/quad.h"
#include "language/text.h"
#include <ctype.h>
#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- Tables ---- */

/* KEEPS: the value is of the one kind that the arguments are of; HALVES: it has half their dimensions. */
enum function_kind { OF_NUMBER, OF_ANGLE, TO_ANGLE, KEEPS, HALVES };

struct function {
    const char *name;
    enum function_kind kind;
    domq_real (*one)(domq_real);
    domq_real (*two)(domq_real, domq_real);
};

static const struct function functions[] = {
    {"sin", OF_ANGLE, quad(sin), NULL},      {"cos", OF_ANGLE, quad(cos), NULL},
    {"tan", OF_ANGLE, quad(tan), NULL},      {"asin", TO_ANGLE, quad(asin), NULL},
    {"acos", TO_ANGLE, quad(acos), NULL},    {"atan", TO_ANGLE, quad(atan), NULL},
    {"atan2", TO_ANGLE, NULL, quad(atan2)},  {"exp", OF_NUMBER, quad(exp), NULL},
    {"ln", OF_NUMBER, quad(log), NULL},      {"log", OF_NUMBER, quad(log), NULL},
    {"log10", OF_NUMBER, quad(log10), NULL}, {"abs", KEEPS, quad(fabs), NULL},
    {"floor", OF_NUMBER, quad(floor), NULL}, {"ceil", OF_NUMBER, quad(ceil), NULL},
    {"round", OF_NUMBER, quad(round), NULL}, {"hypot", KEEPS, NULL, quad(hypot)},
    {"min", KEEPS, NULL, quad(fmin)},        {"max", KEEPS, NULL, quad(fmax)},
    {"sqrt", HALVES, quad(sqrt), NULL},      {NULL, OF_NUMBER, NULL, NULL},
};

const char *expression_names(const void *context, int k)
{
    (void)context;
    for (const struct function *f = functions; f->name; f++)
        if (k-- == 0)
            return f->name;
    return k == 0 ? "pi" : NULL; /* the one constant */
}

/* ---- Messages ---- */

void expression_message(struct expression *e, bool of_value, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(e->message, sizeof e->message, format, arguments);
    va_end(arguments);
    e->of_value = of_value;
}

/* ---- Recursive descent ---- */

enum { DEPTH_MAX = 100 };

static bool sum(struct expression *e, struct quantity *q);

/* Replaces a value by 1 where nothing is evaluated, so that no value can be wrong. */
static void settle(const struct expression *e, struct quantity *q)
{
    if (e->dry)
        *q = (struct quantity){.value = 1};
}

/* Returns true for a finite number in a unit whose exponents do not overflow: what each step may give. */
static bool finite_result(struct expression *e, const char *at, struct quantity *q)
{
    settle(e, q);
    enum { EXPONENT_MOST = 999 };
    bool unit = abs(q->length) <= EXPONENT_MOST && abs(q->time) <= EXPONENT_MOST &&
                abs(q->angle) <= EXPONENT_MOST && abs(q->mass) <= EXPONENT_MOST;
    if (isfinite(q->value) && unit)
        return true;
    e->end = at;
    if (!unit)
        return expression_fail(e, "the unit has an exponent above %d", EXPONENT_MOST);
    return expression_no_value(e, "the value is not a finite number");
}

static bool number(struct expression *e, struct quantity *q)
{
    const char *begin = e->end;
    if (begin[0] == '0' && (begin[1] == 'x' || begin[1] == 'X'))
        return expression_fail(e, "is not a decimal number");
    char *stop;
    errno = 0;
    *q = (struct quantity){.value = quad_read(begin, &stop)};
    if (errno == ERANGE)
        return expression_fail(e, quad(fabs)(q->value) > 1 ? "is too large for a number"
                                                           : "is too small for a number");
    e->end = stop;
    return true;
}

/* Reads a unit after a value, with or without a blank. */
static bool postfix_unit(struct expression *e, struct quantity *q)
{
    const char *c = skip_blanks(e->end);
    if (c > e->end && e->no_unit && name_length(c) == 1 && strchr(e->no_unit, *c))
        return true;
    if (c > e->end && e->no_unit && name_length(c) == 4 && strncmp(c, "feet", 4) == 0) /* the effect */
        return true;
    if (name_start(*c)) {
        struct quantity with = *q;
        const char *stop = unit_scan(c, &with);
        if (stop) {
            *q = with;
            e->end = stop;
        } else if (c == e->end) {
            return expression_fail(e, "'%.*s' is not a unit", (int)name_length(c), c);
        }
    }
    return true;
}

static bool apply(struct expression *e, const struct function *f, const char *at, const struct quantity *a,
                  int count, struct quantity *q)
{
    char kind[48];
    int wanted = f->one ? 1 : 2;
    e->end = at;
    if (count != wanted)
        return expression_fail(e, "%s takes %d value%s", f->name, wanted, wanted == 1 ? "" : "s");
    bool number = quantity_plain(a[0]) && (f->kind == OF_ANGLE || a[0].angle == 0);
    if (f->kind == HALVES && (a[0].length % 2 || a[0].time % 2 || a[0].mass % 2))
        return expression_fail(e, "%s of this is not defined", f->name);
    if (f->kind == HALVES && a[0].value < 0)
        return expression_no_value(e, "%s of this is not defined", f->name);
    if (f->one && f->kind < KEEPS && !number)
        return expression_fail(e, "%s of %s is not defined", f->name,
                               expression_kind(a[0], kind, sizeof kind));
    if (f->two && (a[0].length != a[1].length || a[0].time != a[1].time || a[0].mass != a[1].mass))
        return expression_fail(e, "%s needs two values of the same kind, such as two lengths", f->name);
    *q = f->kind == KEEPS ? a[0]
         : f->kind == HALVES
             ? (struct quantity){0, a[0].length / 2, a[0].time / 2, a[0].angle / 2, a[0].mass / 2}
             : (struct quantity){.angle = f->kind == TO_ANGLE};
    domq_real one = f->kind == OF_ANGLE && a[0].angle == 0 ? a[0].value * e->angle : a[0].value;
    if (f->two)
        q->value = f->two(a[0].value, a[1].value);
    else if (f->one)
        q->value = f->one(one);
    return finite_result(e, at, q);
}

/* Reads "(a, b)" after a name; "()" has no values. */
static bool arguments(struct expression *e, struct quantity *a, int *count)
{
    *count = 0;
    e->end = skip_blanks(e->end + 1);
    while (*e->end != ')') {
        if (*count == EXPRESSION_ARGUMENTS)
            return expression_fail(e, "too many values");
        if (!sum(e, &a[(*count)++]))
            return false;
        e->end = skip_blanks(e->end);
        if (*e->end == ')')
            break;
        if (*e->end != ',')
            return expression_fail(e, "',' or ')' is missing");
        e->end = skip_blanks(e->end + 1);
        if (*e->end == ')')
            return expression_fail(e, "a value is missing after ','");
    }
    e->end++;
    return true;
}

static bool named(struct expression *e, struct quantity *q)
{
    char name[32], key[32];
    const char *at = e->end;
    size_t length = name_length(at);
    struct quantity a[EXPRESSION_ARGUMENTS];
    int count = 0;
    if (length >= sizeof name)
        return expression_fail(e, "this name is too long");
    name_copy(at, length, name, sizeof name);
    e->end += length;
    bool called = *e->end == '(';
    if (called && !arguments(e, a, &count))
        return false;
    const char *end = e->end;
    if (called) {
        for (const struct function *f = functions; f->name; f++)
            if (strcmp(f->name, name) == 0)
                return apply(e, f, at, a, count, q) && ((e->end = end), true);
    } else if (strcmp(name, "pi") == 0) {
        *q = (struct quantity){.value = QUAD_PI};
        return true;
    }
    bool dotted = end[0] == '.' && name_start(end[1]);
    if (dotted) {
        size_t n = name_length(end + 1);
        name_copy(end + 1, n, key, sizeof key);
        end += 1 + n;
    }
    e->end = at;
    bool known = e->dry || e->lookup(e, name, dotted ? key : NULL, a, count, q);
    if (!known || !finite_result(e, at, q))
        return false;
    e->end = end;
    return true;
}

static bool primary(struct expression *e, struct quantity *q)
{
    char c = *e->end;
    if (isdigit((unsigned char)c) || (c == '.' && isdigit((unsigned char)e->end[1])))
        return number(e, q) && postfix_unit(e, q);
    if (name_start(c))
        return named(e, q);
    if (c == '*' && e->end > e->text && e->end[-1] == '*')
        return expression_fail(e, "a power is written with '^', as in '2^10'");
    if (c != '(')
        return expression_fail(e, c ? "a value is missing" : "a value is missing at the end");
    const char *open = e->end++;
    e->end = skip_blanks(e->end);
    if (!sum(e, q))
        return false;
    e->end = skip_blanks(e->end);
    if (*e->end != ')') {
        e->end = open;
        return expression_fail(e, "this '(' is never closed");
    }
    e->end++;
    return postfix_unit(e, q);
}

static bool factor(struct expression *e, struct quantity *q)
{
    if (++e->depth > DEPTH_MAX)
        return expression_fail(e, "the expression is nested too deeply");
    bool negative = *e->end == '-', good;
    if (negative || *e->end == '+') {
        e->end = skip_blanks(e->end + 1);
        good = factor(e, q);
        if (good && negative)
            q->value = -q->value;
    } else {
        good = primary(e, q);
        settle(e, q);
        const char *op = skip_blanks(e->end);
        if (good && *op == '^') {
            struct quantity power = {.value = 0};
            e->end = skip_blanks(op + 1);
            const char *at = e->end;
            good = factor(e, &power);
            bool whole = good && power.value == quad(floor)(power.value) && quad(fabs)(power.value) < 100;
            if (good && (!quantity_bare(power) || (!whole && !quantity_bare(*q)))) {
                e->end = at;
                good = expression_fail(e, "the value before '^' cannot have this exponent");
            } else if (good) {
                int n = whole ? (int)power.value : 0;
                *q = (struct quantity){quad(pow)(q->value, power.value), n * q->length, n * q->time,
                                       n * q->angle, n * q->mass};
                good = finite_result(e, op, q);
            }
        }
    }
    settle(e, q);
    e->depth--;
    return good;
}

static bool product(struct expression *e, struct quantity *q)
{
    bool good = factor(e, q);
    for (const char *op = skip_blanks(e->end); good && (*op == '*' || *op == '/'); op = skip_blanks(e->end)) {
        struct quantity by;
        e->end = skip_blanks(op + 1);
        good = factor(e, &by);
        if (good && *op == '/' && by.value == 0) {
            e->end = op;
            return expression_no_value(e, "division by zero");
        }
        if (good) {
            quantity_multiply(q, by, *op == '/' ? -1 : 1);
            good = finite_result(e, op, q);
        }
    }
    return good;
}

static bool sum(struct expression *e, struct quantity *q)
{
    bool good = product(e, q);
    for (;;) {
        const char *op = skip_blanks(e->end);
        if (!good || (*op != '+' && *op != '-'))
            return good;
        /* "1 -2" are two values: an argument, and one that begins with its sign. */
        if (op != e->end && skip_blanks(op + 1) == op + 1)
            return true;
        struct quantity by;
        e->end = skip_blanks(op + 1);
        good = product(e, &by);
        if (!good)
            return false;
        /* thetac - 1: the bare one is in the session's unit of angles. */
        if (quantity_bare(*q) && quantity_plain(by) && by.angle == 1)
            *q = (struct quantity){.value = q->value * e->angle, .angle = 1};
        else if (quantity_bare(by) && quantity_plain(*q) && q->angle == 1)
            by = (struct quantity){.value = by.value * e->angle, .angle = 1};
        if (!quantity_alike(*q, by)) {
            char a[48], b[48];
            e->end = op;
            return expression_fail(e, "%s and %s do not add up", expression_kind(*q, a, sizeof a),
                                   expression_kind(by, b, sizeof b));
        }
        q->value += *op == '-' ? -by.value : by.value;
        good = finite_result(e, op, q);
    }
}

bool expression_evaluate(struct expression *e, struct quantity *result)
{
    e->end = e->text;
    e->message[0] = '\0';
    e->of_value = false;
    return sum(e, result);
}
