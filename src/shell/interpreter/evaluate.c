/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Evaluates expressions. The value of a comparison is 1 if it is true, and 0 if it is false. As a condition,
 * every number except 0 is true. */
#include "interpreter/question.h"
#include "language/quad.h"
#include <stdlib.h>
#include <string.h>

/* Returns true if a result and the exponents of its unit are in range. Otherwise reports an error. */
static bool is_valid(struct evaluation *e, const char *at, const struct quantity *q)
{
    enum { EXPONENT_MOST = 999 };
    bool unit = abs(q->length) <= EXPONENT_MOST && abs(q->time) <= EXPONENT_MOST &&
                abs(q->angle) <= EXPONENT_MOST && abs(q->mass) <= EXPONENT_MOST;
    if (isfinite(q->value) && unit)
        return true;
    if (!unit)
        return expression_wrong(e->problem, at, "the unit has an exponent above %d", EXPONENT_MOST);
    return expression_no_value(e->problem, at, "the value is not a finite number");
}

bool expression_evaluate(struct evaluation *e, const struct tree *t, struct quantity *q)
{
    if (!t->compute)
        return expression_wrong(e->problem, t->at, "'%s' has no value in a csv file", t->name);
    return t->compute(e, t, q) && (t->compute == number_value || is_valid(e, t->at, q));
}

bool arguments_evaluate(struct evaluation *e, const struct tree *t,
                        struct quantity argument[EXPRESSION_ARGUMENTS])
{
    const struct tree *child = t->child;
    for (int i = 0; i < t->count; i++, child = child->next)
        if (!expression_evaluate(e, child, &argument[i]))
            return false;
    return true;
}

bool number_value(struct evaluation *e, const struct tree *t, struct quantity *q)
{
    (void)e;
    *q = t->value;
    return true;
}

/* The units of a function's arguments and result. */
enum function_kind {
    OF_NUMBER,
    OF_ANGLE,
    TO_ANGLE,
    KEEPS,  /* the result has the unit of the arguments */
    HALVES, /* the result has the square root of the argument's unit */
};

/* A function of one or two values, or 'if', which has three. */
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
    {"sqrt", HALVES, quad(sqrt), NULL},      {"if", KEEPS, NULL, NULL},
};

enum { FUNCTIONS = sizeof functions / sizeof *functions };

const char *expression_names(const void *context, int k)
{
    (void)context;
    return k < FUNCTIONS ? functions[k].name : k == FUNCTIONS ? "pi" : NULL;
}

const struct function *function_find(const char *name, int *arguments)
{
    const struct function *f = functions;
    while (f < functions + FUNCTIONS && strcmp(f->name, name) != 0)
        f++;
    if (f == functions + FUNCTIONS)
        return NULL;
    *arguments = f->one ? 1 : f->two ? 2 : 3;
    return f;
}

bool function_value(struct evaluation *e, const struct tree *t, struct quantity *q)
{
    struct quantity a[EXPRESSION_ARGUMENTS] = {{.value = 0}};
    const struct function *f = t->refers;
    if (!arguments_evaluate(e, t, a))
        return false;
    bool number = quantity_is_dimensionless(a[0]) && (f->kind == OF_ANGLE || a[0].angle == 0);
    if (f->kind == HALVES && (a[0].length % 2 || a[0].time % 2 || a[0].mass % 2))
        return expression_wrong(e->problem, t->at, "%s of a value with this unit is not defined", f->name);
    if (f->kind == HALVES && a[0].value < 0)
        return expression_no_value(e->problem, t->at, "%s of a negative value is not defined", f->name);
    if (f->one && f->kind < KEEPS && !number)
        return expression_wrong(e->problem, t->at, "%s of %s is not defined", f->name, expression_kind(a[0]));
    if (f->two && (a[0].length != a[1].length || a[0].time != a[1].time || a[0].mass != a[1].mass))
        return expression_wrong(e->problem, t->at,
                                "%s needs two values of the same kind, such as two lengths", f->name);
    *q = f->kind == KEEPS ? a[0]
         : f->kind == HALVES
             ? (struct quantity){0, a[0].length / 2, a[0].time / 2, a[0].angle / 2, a[0].mass / 2}
             : (struct quantity){.angle = f->kind == TO_ANGLE};
    const domq_real one = f->kind == OF_ANGLE && a[0].angle == 0 ? a[0].value * e->angle : a[0].value;
    if (f->two)
        q->value = f->two(a[0].value, a[1].value);
    else if (f->one)
        q->value = f->one(one);
    return true;
}

/* Prepares two values for a sum or a comparison. If one of them is an angle and the other is a number without
 * a unit, as in "thetac - 1", the number becomes an angle in the session's unit. Returns true if both values
 * then have the same unit. */
static bool make_alike(const struct evaluation *e, struct quantity *a, struct quantity *b)
{
    if (quantity_is_number(*a) && quantity_is_dimensionless(*b) && b->angle == 1)
        *a = (struct quantity){.value = a->value * e->angle, .angle = 1};
    else if (quantity_is_number(*b) && quantity_is_dimensionless(*a) && a->angle == 1)
        *b = (struct quantity){.value = b->value * e->angle, .angle = 1};
    return quantity_alike(*a, *b);
}

/* Applies an operator of the chain t. Before the call, *q is the value of all operands before the operator.
 * The function combines *q with the operand `value` after the operator. */
static bool apply(struct evaluation *e, const struct tree *t, const struct tree *value, struct quantity *q)
{
    struct quantity by;
    const char op = value->op;
    const bool adds = op == '+' || op == '-';
    if (!expression_evaluate(e, value, &by))
        return false;
    if (op == '/' && by.value == 0)
        return expression_no_value(e->problem, value->op_at, "division by zero");
    if (op == '^') {
        const bool whole = by.value == quad(floor)(by.value) && quad(fabs)(by.value) < 100;
        const int n = whole ? (int)by.value : 0;
        if (!quantity_is_number(by) || (!whole && !quantity_is_number(*q)))
            return expression_wrong(e->problem, value->op_at,
                                    "an exponent must have no unit, and must be a whole number if the value "
                                    "before '^' has a unit");
        *q = (struct quantity){quad(pow)(q->value, by.value), n * q->length, n * q->time, n * q->angle,
                               n * q->mass};
    } else if (op == '*' || op == '/')
        quantity_multiply(q, by, op == '/' ? -1 : 1);
    else if (!make_alike(e, q, &by))
        return expression_wrong(e->problem, value->op_at,
                                adds ? "%s and %s cannot be added" : "%s and %s cannot be compared",
                                expression_kind(*q), expression_kind(by));
    else if (adds)
        q->value += op == '-' ? -by.value : by.value;
    else {
        const domq_real a = q->value, b = by.value;
        *q = (struct quantity){.value = op == '<'   ? a < b
                                        : op == 'l' ? a <= b
                                        : op == '>' ? a > b
                                        : op == 'g' ? a >= b
                                        : op == '=' ? a == b
                                                    : a != b};
    }
    return is_valid(e, op == '^' ? t->at : value->op_at, q);
}

/* Evaluates a condition. As a quantity, it is 1 or 0. */
static bool condition_value(struct evaluation *e, const struct tree *t, struct quantity *q)
{
    if (!expression_evaluate(e, t, q))
        return false;
    if (!quantity_is_number(*q))
        return expression_wrong(e->problem, t->at, "%s is not a condition; write, for example, 'r > 1.5'",
                                expression_kind(*q));
    q->value = q->value != 0;
    return true;
}

bool chain_value(struct evaluation *e, const struct tree *t, struct quantity *q)
{
    const struct tree *child = t->child;
    const char op = child->next->op;
    const bool has_conditions = op == '&' || op == '|';
    bool good = has_conditions ? condition_value(e, child, q) : expression_evaluate(e, child, q);
    /* Conditions are evaluated from left to right, and only until one of them decides the result. */
    while (good && (child = child->next) != NULL && !(has_conditions && q->value == (op == '|')))
        good = has_conditions ? condition_value(e, child, q) : apply(e, t, child, q);
    return good;
}

bool minus_value(struct evaluation *e, const struct tree *t, struct quantity *q)
{
    const bool good = expression_evaluate(e, t->child, q);
    q->value = -q->value;
    return good;
}

bool not_value(struct evaluation *e, const struct tree *t, struct quantity *q)
{
    const bool good = condition_value(e, t->child, q);
    q->value = 1 - q->value;
    return good;
}

bool if_value(struct evaluation *e, const struct tree *t, struct quantity *q)
{
    const struct tree *yes = t->child->next;
    return condition_value(e, t->child, q) && expression_evaluate(e, q->value != 0 ? yes : yes->next, q);
}
