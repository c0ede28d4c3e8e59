/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DOM_BEST_H
#define DOM_BEST_H

#include "limit.h"

/* The separation that allows the largest growth; DOM_NO_GROWTH where none allows r > 1. */
KERNEL enum dom_status best_find(struct margin_context *c, struct dom_best *best, struct dom_best *error);

#endif
