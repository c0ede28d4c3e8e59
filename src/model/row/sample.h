/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Rows with random sizes: one row, again and again, of which the verdict alone counts. */
#ifndef DOM_SAMPLE_H
#define DOM_SAMPLE_H

#include "geometry/request.h"

struct random_row; /* of a kernel */
struct kernel;

/* The row, and the kernel that runs it. */
struct dom_sample {
    const struct kernel *kernel;
    struct random_row *sample; /* NULL: none */
};

/* Checks a row, and takes the memory to run others like it. sample_end frees it, also after a failure.
 * Statuses as dom_row_run. */
enum dom_status sample_begin(const struct dom_row *row, const struct dom_compute *compute,
                             struct dom_sample *sample);

/*
 * Runs the row with other dominoes; gaps: their gaps alone differ from those of the run before, or of
 * sample_begin. Of the verdict it finds `end` and `domino`, no times and no energies. Statuses as
 * dom_row_run.
 */
enum dom_status sample_run(const struct dom_sample *sample, const struct dom_domino *domino, bool gaps,
                           struct dom_verdict *verdict);

void sample_end(struct dom_sample *sample);

#endif
