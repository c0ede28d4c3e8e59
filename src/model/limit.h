/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DOM_LIMIT_H
#define DOM_LIMIT_H

#include "probe.h"

struct limit {
    real r_max;
    enum dom_end ends;
};

/* r_max at the separation c->s; *why, where it does not exist and why is not NULL, says why not. */
KERNEL enum dom_status limit_find(struct margin_context *c, struct limit *limit, enum dom_status *why);

/* Bound of the error of r_max. */
KERNEL enum dom_status limit_error(struct margin_context *c, const struct limit *limit, real *error);

#endif
