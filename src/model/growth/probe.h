/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The same search where no bound is known, with friction: samples, refined where what they show of the bend
 * of the margin leaves room for a sign change between two of them.
 */
#ifndef DOM_PROBE_H
#define DOM_PROBE_H

#include "growth/scan.h"

/*
 * First growth after from->r at which the margin changes its sign, between before and after; found is false
 * if it keeps it up to the reach.  This is no proof: a dip that shows neither in its neighbours nor in the
 * middle between them is missed.
 */
KERNEL enum dom_status probe_change(struct margin_context *c, const struct edge *from, struct edge *before,
                                    struct edge *after, bool *found);

#endif
