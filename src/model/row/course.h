/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A row that is run again and again, each time with other sizes of a few neighbouring dominoes. */
#ifndef DOM_COURSE_H
#define DOM_COURSE_H

#include "geometry/request.h"

struct course; /* of a kernel */
struct kernel;

/* The row, and the kernel that runs it. */
struct dom_course {
    const struct kernel *kernel;
    struct course *course; /* NULL: none */
};

/* Runs a row and keeps what later runs need; without times, and whatever row->floor is. course_end frees
 * that, also after a failure. Statuses as dom_row_run. */
enum dom_status course_begin(const struct dom_row *row, const struct dom_compute *compute,
                             struct dom_course *course, struct dom_verdict *verdict);

/*
 * Runs the row with other dominoes, of which only domino[first] ... domino[last] differ from those of
 * course_begin, from 0. In one course `first` never decreases. Sets verdict->end; the end of a row that
 * does not fall before the change may be that of the unchanged row. Also sets verdict->spare: the smallest
 * margin / barrier seen in this run, negative where the row stops in it. Statuses as dom_row_run.
 */
enum dom_status course_again(const struct dom_course *course, const struct dom_domino *domino, size_t first,
                             size_t last, struct dom_verdict *verdict);

void course_end(struct dom_course *course);

#endif
