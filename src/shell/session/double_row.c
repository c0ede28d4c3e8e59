/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "session/double_row.h"
#include "language/quad.h"
#include <stdlib.h>

#define DOMINO_MEMBERS(X) X(height) X(thickness) X(gap) X(mass) X(radius) X(lean) X(width)

struct dom_domino domino_in_double(const struct domq_domino *domino)
{
#define VALUE(member) .member = (double)domino->member,
    return (struct dom_domino){DOMINO_MEMBERS(VALUE)};
#undef VALUE
}

struct domq_domino domino_from_double(const struct dom_domino *domino)
{
#define VALUE(member) .member = quad_decimal(domino->member),
    return (struct domq_domino){DOMINO_MEMBERS(VALUE)};
#undef VALUE
}

struct dom_train train_in_double(const struct domq_train *train)
{
#define PARAMETER(name, ...)          .name = (double)train->name,
#define VALUE(effect, member, status) .member = (double)train->member,
    return (struct dom_train){DOM_TRAIN_PARAMETERS(PARAMETER) DOM_DYNAMICS(VALUE).fuel = train->fuel};
#undef PARAMETER
#undef VALUE
}

struct dom_compute compute_in_double(const struct domq_compute *compute)
{
    const struct dom_arithmetic *in_double = dom_arithmetic(DOM_DOUBLE);
    const double tol = (double)compute->tol;
    return (struct dom_compute){.tol = tol >= in_double->tol_floor ? tol : in_double->tol_default,
                                .precision = DOM_DOUBLE,
                                .method = compute->method,
                                .work = compute->work,
                                .interrupt = compute->interrupt};
}

bool double_row_make(const struct domq_row *row, const struct domq_compute *compute, struct double_row *made)
{
    struct dom_domino *domino = malloc(row->count * sizeof *domino);
    for (size_t k = 0; domino && k < row->count; k++)
        domino[k] = domino_in_double(&row->domino[k]);
#define VALUE(effect, member, status) .member = (double)row->member,
    *made = (struct double_row){.row = {.domino = domino,
                                        .count = row->count,
                                        .g = (double)row->g,
                                        .push = (double)row->push,
                                        .release = (double)row->release,
                                        DOM_DYNAMICS(VALUE).feet = (double)row->feet,
                                        .floor = row->floor,
                                        .boxes_above = (double)row->boxes_above},
                                .compute = compute_in_double(compute),
                                .domino = domino};
#undef VALUE
    return domino;
}
