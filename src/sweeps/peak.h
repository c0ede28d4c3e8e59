/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Finds the largest value of a function of one variable on an interval. The function may have several maxima,
 * places without a value, and plateaus, on which it is constant. */
#ifndef SHELL_PEAK_H
#define SHELL_PEAK_H

#include <signal.h>
#include <stdbool.h>
#include <stddef.h>

/* The interval from..to, and the function on it. */
struct slope {
    double from, to;
    bool whole; /* only whole numbers are places */
    /* returns the value at a place, or NaN if there is none */
    double (*at)(double x, void *context);
    void *context;
    double noise; /* the relative error of the values */
    double least; /* a place is found to this fraction of the interval */
    const volatile sig_atomic_t *interrupt;
};

enum { PEAK_POINTS = 241 };

/* Where the largest value is. */
enum peak_end {
    PEAK_INSIDE,
    PEAK_AT_FROM, /* at an end of the interval */
    PEAK_AT_TO,
    PEAK_BEFORE_HOLE, /* at the end of a region with values; there are none at slightly larger places */
    PEAK_AFTER_HOLE
};

struct peak {
    double x, value; /* NaN if the function has no value at all */
    double within;   /* the error of x is at most this; 0 for an end of the interval */
    double off;      /* the error of the value is at most this */
    /* The function has the same value from `low` to `high`. Without a plateau, both are x. */
    double low, high;
    enum peak_end end;
};

/* Returns how many points of the interval peak_find needs first: at most `most`, evenly spaced, and for whole
 * numbers not more than there are. peak_point returns point k. */
size_t peak_points(const struct slope *slope, size_t most);
double peak_point(const struct slope *slope, size_t count, size_t k);

/*
 * Finds the largest value. `value` has the values at all `count` points. The search looks around each point
 * whose neighbours are not larger: it takes four points on either side, finds the edge of a region without
 * values by bisection, and follows a maximum with GSL's minimiser by Brent. It can miss a maximum that is
 * narrower than the distance between two points. After an interrupt, the result is of no use.
 *
 * If `is_rough` is true, only x and value are found.
 */
struct peak peak_find(const struct slope *slope, const double *value, size_t count, bool is_rough);

#endif
