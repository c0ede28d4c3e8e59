/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Rows that are run again and again by a kernel of <domino_quad.h>, for the functions of <domino.h>. The
 * functions are those of struct kernel with names like row_again. The symbols are hidden: they are shared by
 * two object files of the library, but nothing outside the library uses them.
 */
#ifndef DOM_WIDE_H
#define DOM_WIDE_H

#include "numerics/api.h"

#define HIDDEN __attribute__((visibility("hidden")))

struct course;     /* row/course.c */
struct random_row; /* row/sample.c */

HIDDEN enum dom_status domq_course(const struct domq_row *row, const struct domq_compute *compute,
                                   struct course **course, struct domq_verdict *verdict);
HIDDEN enum dom_status domq_again(enum dom_precision precision, struct course *course,
                                  const struct domq_domino *domino, size_t first, size_t last,
                                  struct domq_verdict *verdict);
HIDDEN void domq_course_end(enum dom_precision precision, struct course *course);

HIDDEN enum dom_status domq_sample(const struct domq_row *row, const struct domq_compute *compute,
                                   struct random_row **sample);
HIDDEN enum dom_status domq_sampled(enum dom_precision precision, struct random_row *sample,
                                    const struct domq_row *row, bool gaps, struct domq_verdict *verdict);
HIDDEN void domq_sample_end(enum dom_precision precision, struct random_row *sample);

#endif
