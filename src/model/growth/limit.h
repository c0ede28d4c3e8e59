/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DOM_LIMIT_H
#define DOM_LIMIT_H

#include "growth/probe.h"

struct limit {
    real r_max;
    enum dom_end ends;
};

/* r_max at the separation c->s; *why, where it does not exist and why is not NULL, says why not. */
KERNEL enum dom_status limit_find(struct margin_context *c, struct limit *limit, enum dom_status *why);

/* Bound of the error of r_max. */
KERNEL enum dom_status limit_error(struct margin_context *c, const struct limit *limit, real *error);

/* Limits the work of a search (DOM_TOO_LONG beyond), which is counted in `work`; limit_end adds it to the
 * caller's. */
KERNEL void limit_begin(struct margin_context *c, struct dom_work *work);
KERNEL void limit_end(const struct request *train, const struct dom_work *work);

#endif
