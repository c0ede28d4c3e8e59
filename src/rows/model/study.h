/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs a row many times: with changes of a few dominoes (windows, mending), or with random errors. */
#pragma once

#include "numerics/api.h"
#include "rows/model/boxes.h"

struct study;

/*
 * Studies run a row many times. row_study_begin runs the row as planned. row_study then runs copies of it in
 * which the dominoes `first` to `last` have changed. If the `verdict` of row_study_begin is NULL, no row is
 * planned, and each row may differ in all dominoes, in its effects and in its push. Of their verdicts only
 * `end` and `domino` count. Call row_study_end even after an error.
 */
enum dom_status row_study_begin(const struct dom_row *row, const struct dom_compute *compute,
                                struct study **study, struct dom_verdict *verdict);
enum dom_status row_study(struct study *study, const struct dom_row *row, size_t first, size_t last,
                          struct dom_verdict *verdict);
void row_study_end(struct study *study);

/* Runs a row. At a domino that would stop, the run does not end: the domino gets the energy that it needs. */
enum dom_status row_run_on(const struct dom_row *row, const struct dom_compute *compute,
                           dom_fall_visit *visit, void *context, struct dom_verdict *verdict);
