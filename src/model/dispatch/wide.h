/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Rows that are run again and again by a kernel of <domino_quad.h>, for the functions of <domino.h>. Each
 * function calls a function of struct kernel: domq__again calls row_again, for instance. The names are
 * written with their prefix, since they must be the same in both parts of the library.
 */
#ifndef DOM_WIDE_H
#define DOM_WIDE_H

#include "numerics/api.h"

struct course;     /* row/course.c */
struct random_row; /* row/sample.c */

enum dom_status domq__course(const struct domq_row *row, const struct domq_compute *compute,
                             struct course **course, struct domq_verdict *verdict);
enum dom_status domq__again(enum dom_precision precision, struct course *course,
                            const struct domq_domino *domino, size_t first, size_t last,
                            struct domq_verdict *verdict);
void domq__course_end(enum dom_precision precision, struct course *course);

enum dom_status domq__sample(const struct domq_row *row, const struct domq_compute *compute,
                             struct random_row **sample);
enum dom_status domq__sampled(enum dom_precision precision, struct random_row *sample,
                              const struct domq_row *row, bool gaps, struct domq_verdict *verdict);
void domq__sample_end(enum dom_precision precision, struct random_row *sample);

#endif
