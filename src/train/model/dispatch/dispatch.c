/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dispatch/dispatch.h"
#include "effects/effects.h"

#ifdef DOMQ
const struct kernel *const kernels[] = {
    [DOM_FLOAT] = &domq__kernel_float, [DOM_DOUBLE] = &domq__kernel_bridge, [DOM_QUAD] = &domq__kernel_quad};
#define KERNEL_GSL   &domq__kernel_bridge
#define KERNEL_PAPER &domq__kernel_bridge
#else
const struct kernel *const kernels[] = {
    [DOM_FLOAT] = &dom__kernel_bridge, [DOM_DOUBLE] = &dom__kernel_double, [DOM_QUAD] = &dom__kernel_bridge};
#define KERNEL_GSL   &dom__kernel_gsl
#define KERNEL_PAPER &dom__kernel_paper
#endif

/* The statuses for values outside the ranges in DOM_TRAIN_PARAMETERS and DOM_COMPUTE_PARAMETERS. */
#define BAD_s     DOM_BAD_S
#define BAD_r     DOM_BAD_R
#define BAD_d     DOM_BAD_D
#define BAD_q     DOM_BAD_Q
#define BAD_width DOM_BAD_WIDTH
#define BAD_tol   DOM_BAD_TOL

enum dom_status precision_check(enum dom_precision precision)
{
    return precision > DOM_QUAD              ? DOM_BAD_PRECISION
           : dom_arithmetic(precision)->bits ? DOM_OK
                                             : DOM_NO_PRECISION;
}

/* Sets `status` to an error if the parameter is outside its range and no earlier check failed. */
#define CHECK(name, default_, lowest, highest, unit, meaning)                                                \
    if (status == DOM_OK && !(q->name >= (dom_real)(lowest) && q->name <= (dom_real)(highest)))              \
        status = BAD_##name;

static enum dom_status request_check(const struct request *q)
{
    enum dom_status status = DOM_OK;
    DOM_TRAIN_PARAMETERS(CHECK)
    if (status == DOM_OK)
        status = dynamics_check(q->effect);
    if (status == DOM_OK && q->fuel > DOM_FUEL_PAPER)
        status = DOM_BAD_FUEL;
    if (status == DOM_OK && q->method > DOM_METHOD_PAPER)
        status = DOM_BAD_METHOD;
    if (status == DOM_OK)
        status = precision_check(q->precision);
    DOM_COMPUTE_PARAMETERS(CHECK)
    if (status == DOM_OK && (double)q->tol < (double)dom_arithmetic(q->precision)->tol_floor)
        status = DOM_BAD_TOL;
    return status == DOM_OK && dynamics_first(q->effect) < DOM_DYNAMICS_COUNT && q->method != DOM_METHOD_OURS
               ? DOM_NO_METHOD
               : status;
}
#undef CHECK

/* DOM_DYNAMICS(TRAIN_VALUE) and DOM_DYNAMICS(ROW_VALUE) list the values of all effects. */
#define TRAIN_VALUE(effect, member, status) train->member,
#define ROW_VALUE(effect, member, status)   row->member,

struct question question_make(const struct dom_train *train, const struct dom_compute *given)
{
    struct dom_compute compute = compute_or_default(given);
#define COPY(name, default_, lowest, highest, unit, meaning)         .name = train->name,
#define COPY_COMPUTE(name, default_, lowest, highest, unit, meaning) .name = compute.name,
    struct question q = {
        .request = {DOM_TRAIN_PARAMETERS(COPY) DOM_COMPUTE_PARAMETERS(COPY_COMPUTE).fuel = train->fuel,
                    .effect = {DOM_DYNAMICS(TRAIN_VALUE)}, .precision = compute.precision,
                    .method = compute.method, .work = compute.work, .interrupt = compute.interrupt}};
#undef COPY
#undef COPY_COMPUTE
    q.status = request_check(&q.request);
    if (q.status == DOM_OK)
        q.kernel = compute.method == DOM_METHOD_GSL     ? KERNEL_GSL
                   : compute.method == DOM_METHOD_PAPER ? KERNEL_PAPER
                                                        : kernels[compute.precision];
    return q;
}

struct row_question row_question_make(const struct dom_row *row, const struct dom_compute *given)
{
    struct dom_compute compute = compute_or_default(given);
    struct row_question q = {.request = {.domino = row->domino,
                                         .count = row->count,
                                         .g = row->g,
                                         .push = row->push,
                                         .release = row->release,
                                         .effect = {DOM_DYNAMICS(ROW_VALUE)},
                                         .boxes_above = row->boxes_above,
                                         .floor = row->floor,
                                         .tol = compute.tol,
                                         .precision = compute.precision,
                                         .work = compute.work,
                                         .interrupt = compute.interrupt},
                             .status = precision_check(compute.precision)};
    if (q.status == DOM_OK)
        q.kernel = kernels[compute.precision];
    return q;
}

enum dom_status row_verdict(const struct dom_row *row, const struct dom_compute *given, bool times,
                            dom_fall_visit *visit, void *context, struct dom_verdict *verdict)
{
    struct dom_compute compute = compute_or_default(given);
    struct row_question q = row_question_make(row, &compute);
    for (size_t k = 0; q.status == DOM_OK && row->engine && k < row->count; k++)
        if (row->domino[k].lean != 0)
            return DOM_NO_LEAN;
    if (q.status == DOM_OK && row->engine && row->release > 0 && isfinite(row->release)) {
        dom_real touch;
        q.status = dom_row_touch(row, given, &touch);
        if (q.status == DOM_OK && row->release > touch) {
            *verdict = (struct dom_verdict){.end = DOM_ROW_SKEWED, .domino = 1, .seconds = DOM_NAN};
            return DOM_OK;
        }
    }
    if (q.status == DOM_OK && row->engine)
        return row->engine->run(row, &compute, times, visit, context, verdict);
    return ASK(q, row_run, times, visit, context, verdict);
}
