/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Translates the structures of the public API into requests and chooses the kernel that answers. Callers are
 * the public entry points (model.c), and searches that ask many questions. */
#ifndef DOM_DISPATCH_H
#define DOM_DISPATCH_H

#include "precision/kernel.h"

/* A question about a train, and the kernel that answers it. `kernel` is set only if the status is DOM_OK. */
struct question {
    struct request request;
    const struct kernel *kernel;
    enum dom_status status;
};

/* A question about a row, and the kernel that answers it. `kernel` is set only if the status is DOM_OK. */
struct row_question {
    struct row_request request;
    const struct kernel *kernel;
    enum dom_status status;
};

/* The kernels of this library's own method, indexed by enum dom_precision. */
extern const struct kernel *const kernels[];

/* Returns DOM_OK, DOM_BAD_PRECISION, or DOM_NO_PRECISION if the machine lacks the precision. */
enum dom_status precision_check(enum dom_precision precision);

static inline struct dom_compute compute_or_default(const struct dom_compute *compute)
{
    return compute ? *compute : dom_compute_default();
}

#ifndef DOMQ
/* Returns the settings of a search or a study, which computes in double whatever the precision is. */
static inline struct dom_compute compute_in_double(const struct dom_compute *given)
{
    struct dom_compute compute = compute_or_default(given);
    const struct dom_arithmetic *in_double = dom_arithmetic(DOM_DOUBLE);
    if (compute.precision == DOM_QUAD && compute.tol < in_double->tol_floor)
        compute.tol = in_double->tol_default;
    compute.precision = DOM_DOUBLE;
    return compute;
}
#endif

/* Makes a question about a train. Checks the range of each value; the kernel checks the rest, such as the
 * reach. */
struct question question_make(const struct dom_train *train, const struct dom_compute *compute);

/* Makes a question about a row. Checks only the precision; the kernel checks the dominoes. */
struct row_question row_question_make(const struct dom_row *row, const struct dom_compute *compute);

/*
 * Asks a question: calls a function of the question's kernel. The value of the macro is the status that the
 * function returns. If the status of the question itself is an error, the function is not called, and the
 * value is this error. If the kernel lacks the function, the value is DOM_NO_METHOD.
 */
#define ASK(question, member, ...)                                                                           \
    ((question).status != DOM_OK         ? (question).status                                                 \
     : (question).kernel->member == NULL ? DOM_NO_METHOD                                                     \
                                         : (question).kernel->member(&(question).request, __VA_ARGS__))

/* Runs a row, in its engine if it has one. The arguments are those of dom_row_run. */
enum dom_status row_verdict(const struct dom_row *row, const struct dom_compute *compute, bool times,
                            dom_fall_visit *visit, void *context, struct dom_verdict *verdict);

#endif
