/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "precision/any.h"
#include "domino_float.h"
#include <stdlib.h>
#include <string.h>

/* The caller's visitor, of which exactly one member is set, and its context. */
struct visitor {
#define MEMBER(type) domq_##type *type;
    DOM_VISITORS(MEMBER)
#undef MEMBER
    void *context;
};

#define NARROW(name) domf_##name
#define OWN(name)    float_##name
#include "shell/precision/any.inc"

#define NARROW(name) dom_##name
#define OWN(name)    double_##name
#include "shell/precision/any.inc"

static struct domq_compute quad_compute(const struct any_compute *compute)
{
    return (struct domq_compute){.tol = compute->tol, .work = compute->work, .interrupt = compute->interrupt};
}

#define ASKS_ANY
#include "members.h"

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
    return double_train_in(train);
}

struct dom_compute compute_in_double(const struct any_compute *compute)
{
    struct dom_compute in_double = double_compute_in(compute);
    if ((domq_real)in_double.tol > compute->tol && in_double.tol == dom_arithmetic()->tol_floor)
        in_double.tol = dom_arithmetic()->tol_default;
    return in_double;
}

struct dom_domino domino_in_double(const struct domq_domino *domino)
{
    struct dom_domino in_double;
    double_domino_in(&in_double, domino);
    return in_double;
}

bool double_row_make(const struct domq_row *row, const struct any_compute *compute, struct double_row *made)
{
    made->row = double_row_in(row);
    made->domino = (struct dom_domino *)made->row.domino;
    made->compute = compute_in_double(compute);
    return made->domino;
}
