/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What searches and studies of rows ask of the model, in double. entry.c answers. */
#pragma once

#include "geometry/request.h"
#include "numerics/real.h"

/* Find the request for a row or a train, and check it. Return an error if the precision does not exist, or if
 * the caller asks for something that came with a later version. */
KERNEL_SHARED enum dom_status row_request_of(const struct dom_row *row, const struct dom_compute *compute,
                                             struct row_request *request);
KERNEL_SHARED enum dom_status train_request_of(const struct dom_train *train,
                                               const struct dom_compute *compute, struct request *request);
