/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Another way to compute, for comparison with <domino.h>: the recipe at the end of the paper's section 'A
 * general domino train'. It raises theta and r in steps of sqrt(tol) / 2, which gives errors of about tol.
 *
 * Each function answers as the function of <domino.h> does whose last word is the same. The status is
 * DOM_NO_METHOD for trains with effects that change their motion, and DOM_NOT_CONVERGED if the method fails.
 * The sums of the paper do not converge for r = 1: the status is then DOM_TOO_LONG.
 */
#ifndef DOMINO_METHODS_H
#define DOMINO_METHODS_H

#include "domino.h"

#ifdef __cplusplus
extern "C" {
#endif

enum dom_status dom_paper_launch(const struct dom_train *train, const struct dom_compute *compute,
                                 struct dom_launch *launch);
enum dom_status dom_paper_barrier(const struct dom_train *train, const struct dom_compute *compute,
                                  struct dom_barrier *barrier);
enum dom_status dom_paper_rmax(const struct dom_train *train, const struct dom_compute *compute,
                               struct dom_limit *limit);

#ifdef __cplusplus
}
#endif

#endif
