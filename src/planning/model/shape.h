/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Converts the variables of the search for a better row into dominoes that are within the limits. */
#pragma once

#include "rows/model/boxes.h"

struct shape {
    const struct dom_row *row; /* the row before any change */
    const struct dom_limits *limits;
};

/*
 * Sets the variables x to the values that describe shape->row, and returns their number, at most 2 * count.
 * Each gap has one variable: ln(gap / height of the domino before the gap). If sizes may change, each domino
 * between the first and the last has one, too: the logarithm of the factor by which this domino and those
 * after it, except the last, become larger.
 */
size_t shape_begin(const struct shape *shape, double *x);

/* Writes the dominoes that the variables x describe. If a domino cannot reach across the gap after it, this
 * gap is narrowed. If the row is too long for the hall, all gaps are narrowed. If `final` is true, lengths
 * are rounded to the grid. If the hall is too short even without gaps, returns false. */
bool shape_dominoes(const struct shape *shape, const double *x, bool final, struct dom_domino *domino);

/* Rounds the sizes of the first `count` dominoes, and all gaps, to the grid. If there are boards, the
 * thicknesses are those of the closest boards. The first domino keeps its sizes. The last domino of the row
 * keeps its height. */
void shape_round(const struct shape *shape, size_t count, struct dom_domino *domino);

/* Returns DOM_OK, or a status that says which of the limits is outside its range. */
enum dom_status limits_check(const struct dom_limits *limits);

/* Returns true if a row is within the limits. `rounded` has room for its dominoes. */
bool shape_keeps(const struct shape *shape, const struct dom_domino *domino, struct dom_domino *rounded);
