/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dispatch/wide.h"
#include "dispatch/dispatch.h"

enum dom_status domq__course(const struct domq_row *row, const struct domq_compute *compute,
                             struct course **course, struct domq_verdict *verdict)
{
    struct row_question q = row_question_make(row, compute);
    return ASK(q, row_course, course, verdict);
}

enum dom_status domq__again(enum dom_precision precision, struct course *course,
                            const struct domq_domino *domino, size_t first, size_t last,
                            struct domq_verdict *verdict)
{
    return kernels[precision]->row_again(course, domino, first, last, verdict);
}

void domq__course_end(enum dom_precision precision, struct course *course)
{
    (void)kernels[precision]->row_course_end(course);
}

enum dom_status domq__sample(const struct domq_row *row, const struct domq_compute *compute,
                             struct random_row **sample)
{
    struct row_question q = row_question_make(row, compute);
    return ASK(q, row_sample, sample);
}

enum dom_status domq__sampled(enum dom_precision precision, struct random_row *sample,
                              const struct domq_row *row, bool gaps, struct domq_verdict *verdict)
{
    return kernels[precision]->row_sampled(sample, row, gaps, verdict);
}

void domq__sample_end(enum dom_precision precision, struct random_row *sample)
{
    (void)kernels[precision]->row_sample_end(sample);
}
