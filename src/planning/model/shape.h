/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Limits on the dominoes of a row (improve.c). */
#pragma once

#include "rows/model/boxes.h"

struct shape {
    const struct dom_row *row; /* the row before any change */
    const struct dom_limits *limits;
};

/* Returns DOM_OK, or a status that says which of the limits is outside its range. */
enum dom_status limits_check(const struct dom_limits *limits);

/* Rounds the sizes of the first `count` dominoes, and all gaps, to the grid. If there are boards, the
 * thicknesses are those of the closest boards. The first domino keeps its sizes. The last domino of the row
 * keeps its height. */
void shape_round(const struct shape *shape, size_t count, struct dom_domino *domino);
