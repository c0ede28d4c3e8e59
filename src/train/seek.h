/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Searches along one variable, for functions that are known only by their values. A place without a value
 * has the value NaN. */
#pragma once

struct spot {
    double x, value;
};

typedef double seek_value(double x, void *context);

/* Climbs to a maximum between `low` and `high` by golden sections, from a spot between them or at one of
 * them. Stops when the interval is at most `grain` wide, when the value is above `enough`, or on level
 * ground. Returns the highest spot. */
struct spot seek_top(seek_value *at, void *context, double low, struct spot from, double high, double grain,
                     double enough);

/* Finds where a function changes its sign: the value at *good is at least 0, that at *bad is below 0 or NaN.
 * Moves both towards each other until they are at most `grain` apart, or until no double lies between them.
 */
void seek_edge(seek_value *at, void *context, struct spot *good, struct spot *bad, double grain);
