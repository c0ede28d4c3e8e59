/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs a row many times with changes of a few dominoes, for windows and mending. */
#pragma once

#include "numerics/api.h"
#include "rows/model/boxes.h"

struct study;

/* row_study_begin runs the row as planned. row_study then runs copies of it in which the dominoes `first` to
 * `last` have changed. Call row_study_end even after an error. */
enum dom_status row_study_begin(const struct dom_row *row, const struct dom_compute *compute,
                                struct study **study, struct dom_verdict *verdict);
enum dom_status row_study(struct study *study, const struct dom_row *row, size_t first, size_t last,
                          struct dom_verdict *verdict);
void row_study_end(struct study *study);
