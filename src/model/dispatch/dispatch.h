/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * From the structures of the public API to the kernel that answers: a question is checked and rounded to a
 * precision here. The public entry points (model.c) and the searches that ask many questions (planning/) both
 * call these functions.
 */
#ifndef DOM_DISPATCH_H
#define DOM_DISPATCH_H

#include "precision/kernel.h"

/* A question about a train, and the kernel that answers it. Unless the status is DOM_OK, no kernel does. */
struct question {
    struct request request;
    const struct kernel *kernel;
    enum dom_status status;
};

/* The same for a row. */
struct row_question {
    struct row_request request;
    const struct kernel *kernel;
    enum dom_status status;
};

/* The kernel of each precision. */
extern const struct kernel *const kernels[];

/* Returns DOM_OK if the machine has the precision. */
enum dom_status precision_check(enum dom_precision precision);

/* Returns the defaults if compute is NULL. */
static inline struct dom_compute compute_or_default(const struct dom_compute *compute)
{
    return compute ? *compute : dom_compute_default();
}

/* Checks a train and how to compute. */
struct question question_make(const struct dom_train *train, const struct dom_compute *compute);

/* Prepares a question about a row. Its kernel checks the dominoes. */
struct row_question row_question_make(const struct dom_row *row, const struct dom_compute *compute);

/* Calls a function of the kernel with the request and further arguments. Evaluates to its status. */
#define ASK(question, member, ...)                                                                           \
    ((question).status != DOM_OK         ? (question).status                                                 \
     : (question).kernel->member == NULL ? DOM_NO_METHOD                                                     \
                                         : (question).kernel->member(&(question).request, __VA_ARGS__))

/* Runs a row, by its engine if it has one: see dom_row_run. */
enum dom_status row_verdict(const struct dom_row *row, const struct dom_compute *compute, bool times,
                            dom_fall_visit *visit, void *context, struct dom_verdict *verdict);

#endif
