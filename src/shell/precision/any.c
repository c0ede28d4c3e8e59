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
    return (struct domq_compute){.tol = compute->tol,
                                 .method = compute->method,
                                 .work = compute->work,
                                 .interrupt = compute->interrupt};
}

/* Returns the precision in which a question is asked. */
static enum precision precision_of(const struct any_compute *compute)
{
    return compute->method == DOM_METHOD_OURS ? compute->precision : IN_DOUBLE;
}

/* Asks about `subject`, a train or a row, in a precision. The value of the macro is the status. */
#define ANY(find, precision, subject, compute, ...)                                                          \
    ((precision) == IN_FLOAT ? float_##find(subject, compute, __VA_ARGS__)                                   \
     : (precision) == IN_DOUBLE                                                                              \
         ? double_##find(subject, compute, __VA_ARGS__)                                                      \
         : domq_##find(subject, (const struct domq_compute[]){quad_compute(compute)}, __VA_ARGS__))

#define ANY_FIND(find, structure)                                                                            \
    enum dom_status any_##find(const struct domq_train *train, const struct any_compute *compute,            \
                               struct domq_##structure *found)                                               \
    {                                                                                                        \
        return ANY(find, precision_of(compute), train, compute, found);                                      \
    }
#define ANY_FIND_AT(find, structure)                                                                         \
    enum dom_status any_##find(const struct domq_train *train, const struct any_compute *compute,            \
                               domq_real at, struct domq_##structure *found)                                 \
    {                                                                                                        \
        return ANY(find, precision_of(compute), train, compute, at, found);                                  \
    }
#define ANY_NUMBER(find)                                                                                     \
    enum dom_status any_##find(const struct domq_train *train, const struct any_compute *compute,            \
                               domq_real *found)                                                             \
    {                                                                                                        \
        return ANY(find, precision_of(compute), train, compute, found);                                      \
    }
#define ANY_NUMBER_AT(find)                                                                                  \
    enum dom_status any_##find(const struct domq_train *train, const struct any_compute *compute,            \
                               domq_real at, domq_real *found)                                               \
    {                                                                                                        \
        return ANY(find, precision_of(compute), train, compute, at, found);                                  \
    }
DOM_FINDS(ANY_FIND)
DOM_FINDS_AT(ANY_FIND_AT)
DOM_NUMBERS(ANY_NUMBER)
DOM_NUMBERS_AT(ANY_NUMBER_AT)

enum dom_status any_train_check(const struct domq_train *train, const struct any_compute *compute)
{
    const struct domq_compute quad = quad_compute(compute);
    const enum precision precision = precision_of(compute);
    return precision == IN_FLOAT    ? float_train_check(train, compute)
           : precision == IN_DOUBLE ? double_train_check(train, compute)
                                    : domq_train_check(train, &quad);
}

enum dom_status any_cycle_events(const struct domq_train *train, const struct any_compute *compute,
                                 struct domq_event *events, int *count)
{
    return ANY(cycle_events, precision_of(compute), train, compute, events, count);
}

enum dom_status any_chain_walk(const struct domq_train *train, const struct any_compute *compute,
                               domq_real theta, domq_visit *visit, void *context)
{
    return ANY(chain_walk, precision_of(compute), train, compute, theta, visit, context);
}

enum dom_status any_cycle_forces(const struct domq_train *train, const struct any_compute *compute,
                                 domq_real theta, domq_force_visit *visit, void *context)
{
    return ANY(cycle_forces, precision_of(compute), train, compute, theta, visit, context);
}

enum dom_status any_cycle_walk(const struct domq_train *train, const struct any_compute *compute,
                               size_t count, enum dom_spacing by, domq_state_visit *visit, void *context)
{
    return ANY(cycle_walk, precision_of(compute), train, compute, count, by, visit, context);
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
    return ANY(row_run, row->engine ? IN_DOUBLE : compute->precision, row, compute, times, visit, context,
               verdict);
}

enum dom_status any_row_touch(const struct domq_row *row, const struct any_compute *compute, domq_real *tilt)
{
    return ANY(row_touch, row->engine ? IN_DOUBLE : compute->precision, row, compute, tilt);
}

enum dom_status any_row_watch(const struct domq_row *row, const struct any_compute *compute,
                              const domq_real *times, size_t count, domq_moment_visit *visit, void *context,
                              struct domq_verdict *verdict)
{
    return ANY(row_watch, row->engine ? IN_DOUBLE : compute->precision, row, compute, times, count, visit,
               context, verdict);
}

/* The tolerances of the library are powers of ten, here with all digits of quad. */
#define TENTH(power) (1 / (domq_real)(power))

struct domq_arithmetic any_arithmetic(enum precision precision)
{
    const struct domf_arithmetic *f = domf_arithmetic();
    const struct dom_arithmetic *d = dom_arithmetic();
    switch (precision) {
    case IN_FLOAT:
        return (struct domq_arithmetic){f->name,    f->type,    f->bits,  f->epsilon,
                                        TENTH(1e5), TENTH(1e6), f->digits};
    case IN_DOUBLE:
        return (struct domq_arithmetic){d->name,     d->type,     d->bits,  d->epsilon,
                                        TENTH(1e12), TENTH(1e15), d->digits};
    case IN_QUAD:
        break;
    }
    return *domq_arithmetic();
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
