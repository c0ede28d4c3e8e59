/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What searches and studies of rows ask of the model, in double. entry.c answers. */
#ifndef DOM_ENTRY_STUDY_H
#define DOM_ENTRY_STUDY_H

#include "geometry/request.h"
#include "numerics/real.h"

/* Runs a row. At a domino that would stop, the run does not end: the domino gets the energy that it needs. */
enum dom_status row_run_on(const struct dom_row *row, const struct dom_compute *compute,
                           dom_fall_visit *visit, void *context, struct dom_verdict *verdict);

/* Finds the request for a row. Returns an error if the precision does not exist, or if the caller asks for
 * something that came with a later version. */
KERNEL_SHARED enum dom_status row_request_of(const struct dom_row *row, const struct dom_compute *compute,
                                             struct row_request *request);

#endif
