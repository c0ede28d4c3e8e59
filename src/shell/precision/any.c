/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "precision/any.h"
#include "domino_float.h"
#include <stdlib.h>
#include <string.h>

/* The caller's callback and its context. There is a member for each type of callback, and exactly one of
 * these members is set. */
struct visitor {
    domq_visit *link;
    domq_state_visit *state;
    domq_force_visit *force;
    domq_fall_visit *fall;
    domq_moment_visit *moment;
    void *context;
    size_t count;            /* for `moment`: number of dominoes in the row */
    domq_real *tilt, *omega; /* for `moment`: two arrays of `count` numbers */
};

#define NARROW(name) domf_##name
#define OWN(name)    float_##name
#include "shell/precision/any.inc"
#undef NARROW
#undef OWN

#define NARROW(name) dom_##name
#define OWN(name)    double_##name
#include "shell/precision/any.inc"

static struct domq_compute quad_compute(const struct any_compute *compute)
{
    return (struct domq_compute){compute->tol, compute->method, compute->work, compute->interrupt};
}

/* Returns the precision in which a question is asked. */
static enum precision precision_of(const struct any_compute *compute)
{
    return compute->method == DOM_METHOD_OURS ? compute->precision : IN_DOUBLE;
}

/* Asks in float or double, or goes on with the settings for quad. */
#define ANY(find, precision, ...)                                                                            \
    switch (precision) {                                                                                     \
    case IN_FLOAT:                                                                                           \
        return float_##find(__VA_ARGS__);                                                                    \
    case IN_DOUBLE:                                                                                          \
        return double_##find(__VA_ARGS__);                                                                   \
    case IN_QUAD:                                                                                            \
        break;                                                                                               \
    }                                                                                                        \
    const struct domq_compute quad = quad_compute(compute);

#define ANY_FIND(find, structure)                                                                            \
    enum dom_status any_##find(const struct domq_train *train, const struct any_compute *compute,            \
                               struct domq_##structure *found)                                               \
    {                                                                                                        \
        ANY(find, precision_of(compute), train, compute, found)                                              \
        return domq_##find(train, &quad, found);                                                             \
    }
#define ANY_FIND_AT(find, structure)                                                                         \
    enum dom_status any_##find(const struct domq_train *train, const struct any_compute *compute,            \
                               domq_real at, struct domq_##structure *found)                                 \
    {                                                                                                        \
        ANY(find, precision_of(compute), train, compute, at, found)                                          \
        return domq_##find(train, &quad, at, found);                                                         \
    }
#define ANY_NUMBER(find)                                                                                     \
    enum dom_status any_##find(const struct domq_train *train, const struct any_compute *compute,            \
                               domq_real *found)                                                             \
    {                                                                                                        \
        ANY(find, precision_of(compute), train, compute, found)                                              \
        return domq_##find(train, &quad, found);                                                             \
    }
#define ANY_NUMBER_AT(find)                                                                                  \
    enum dom_status any_##find(const struct domq_train *train, const struct any_compute *compute,            \
                               domq_real at, domq_real *found)                                               \
    {                                                                                                        \
        ANY(find, precision_of(compute), train, compute, at, found)                                          \
        return domq_##find(train, &quad, at, found);                                                         \
    }
DOM_FINDS(ANY_FIND)
DOM_FINDS_AT(ANY_FIND_AT)
DOM_NUMBERS(ANY_NUMBER)
DOM_NUMBERS_AT(ANY_NUMBER_AT)

enum dom_status any_train_check(const struct domq_train *train, const struct any_compute *compute)
{
    ANY(train_check, precision_of(compute), train, compute)
    return domq_train_check(train, &quad);
}

enum dom_status any_cycle_events(const struct domq_train *train, const struct any_compute *compute,
                                 struct domq_event *events, int *count)
{
    ANY(cycle_events, precision_of(compute), train, compute, events, count)
    return domq_cycle_events(train, &quad, events, count);
}

enum dom_status any_chain_walk(const struct domq_train *train, const struct any_compute *compute,
                               domq_real theta, domq_visit *visit, void *context)
{
    ANY(chain_walk, precision_of(compute), train, compute, theta, visit, context)
    return domq_chain_walk(train, &quad, theta, visit, context);
}

enum dom_status any_cycle_forces(const struct domq_train *train, const struct any_compute *compute,
                                 domq_real theta, domq_force_visit *visit, void *context)
{
    ANY(cycle_forces, precision_of(compute), train, compute, theta, visit, context)
    return domq_cycle_forces(train, &quad, theta, visit, context);
}

enum dom_status any_cycle_walk(const struct domq_train *train, const struct any_compute *compute,
                               size_t count, enum dom_spacing by, domq_state_visit *visit, void *context)
{
    ANY(cycle_walk, precision_of(compute), train, compute, count, by, visit, context)
    return domq_cycle_walk(train, &quad, count, by, visit, context);
}

enum dom_status any_count_find(domq_real first, domq_real height, domq_real r,
                               const struct any_compute *compute, struct domq_count *count)
{
    switch (compute->precision) {
    case IN_FLOAT:
        return float_count_find(first, height, r, count);
    case IN_DOUBLE:
        return double_count_find(first, height, r, count);
    case IN_QUAD:
        break;
    }
    return domq_count_find(first, height, r, count);
}

enum dom_status any_row_run(const struct domq_row *row, const struct any_compute *compute, bool times,
                            domq_fall_visit *visit, void *context, struct domq_verdict *verdict)
{
    ANY(row_run, row->engine ? IN_DOUBLE : compute->precision, row, compute, times, visit, context, verdict)
    return domq_row_run(row, &quad, times, visit, context, verdict);
}

enum dom_status any_row_touch(const struct domq_row *row, const struct any_compute *compute, domq_real *tilt)
{
    ANY(row_touch, row->engine ? IN_DOUBLE : compute->precision, row, compute, tilt)
    return domq_row_touch(row, &quad, tilt);
}

enum dom_status any_row_watch(const struct domq_row *row, const struct any_compute *compute,
                              const domq_real *times, size_t count, domq_moment_visit *visit, void *context,
                              struct domq_verdict *verdict)
{
    ANY(row_watch, row->engine ? IN_DOUBLE : compute->precision, row, compute, times, count, visit, context,
        verdict)
    return domq_row_watch(row, &quad, times, count, visit, context, verdict);
}

/* Returns the power of ten that is nearest to a number between 1e-40 and 1, to the last digit of the widest
 * arithmetic. */
static domq_real power_of_ten(double x)
{
    domq_real power = 1;
    for (long n = lround(-log10(x)); n > 0; n--)
        power *= 10;
    return 1 / power;
}

struct domq_arithmetic any_arithmetic(enum precision precision)
{
    const struct domf_arithmetic *of_float = domf_arithmetic();
    const struct dom_arithmetic *of_double = dom_arithmetic();
    return precision == IN_QUAD     ? *domq_arithmetic()
           : precision == IN_DOUBLE ? (struct domq_arithmetic){of_double->name,
                                                               of_double->type,
                                                               of_double->bits,
                                                               of_double->epsilon,
                                                               power_of_ten(of_double->tol_default),
                                                               power_of_ten(of_double->tol_floor),
                                                               of_double->digits}
                                    : (struct domq_arithmetic){of_float->name,
                                                               of_float->type,
                                                               of_float->bits,
                                                               of_float->epsilon,
                                                               power_of_ten((double)of_float->tol_default),
                                                               power_of_ten((double)of_float->tol_floor),
                                                               of_float->digits};
}

struct any_compute any_compute_default(void)
{
    return (struct any_compute){.tol = any_arithmetic(IN_DOUBLE).tol_default, .precision = IN_DOUBLE};
}

struct dom_train train_in_double(const struct domq_train *train)
{
    return double_train(train);
}

struct dom_compute compute_in_double(const struct any_compute *compute)
{
    struct dom_compute in_double = double_compute(compute);
    if ((domq_real)in_double.tol > compute->tol && in_double.tol == dom_arithmetic()->tol_floor)
        in_double.tol = dom_arithmetic()->tol_default;
    return in_double;
}

struct dom_domino domino_in_double(const struct domq_domino *domino)
{
    struct dom_domino in_double;
    double_domino(&in_double, domino);
    return in_double;
}

bool double_row_make(const struct domq_row *row, const struct any_compute *compute, struct double_row *made)
{
    made->row = double_row(row, &made->domino);
    made->compute = compute_in_double(compute);
    return made->domino;
}
