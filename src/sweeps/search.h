/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The searches of 'solve', 'maximize' and 'minimize': an answer at evenly spaced values of a parameter, and
 * between them. */
#ifndef SWEEPS_SEARCH_H
#define SWEEPS_SEARCH_H

#include "sweeps/sweeps.h"
#include "train/seek.h"

enum { SEARCHED_MOST = 2, POINTS = 241, POINTS_OF_TWO = 41 /* along each of two parameters */ };

struct search;

/* The search along one parameter. */
struct line {
    struct search *search;
    int axis;
    double from, to, grain; /* the range, and how accurately a place is found */
    bool whole;             /* only whole numbers are places */
    size_t count;
    struct spot point[POINTS]; /* evenly spaced */
    double level;              /* for line_above */
};

struct search {
    const struct sweep *sweep;
    struct probe probe;
    double sign; /* minima are sought as maxima of the answer times -1 */
    struct line line[SEARCHED_MOST];
    double place[SEARCHED_MOST];
    domq_real answer; /* the last answer, with its own sign */
    /* The largest value at a place of the first of two parameters, along the second one. */
    double (*along)(struct line *second);
    struct problem fault;  /* the last error in the question itself; its kind is PROBLEM_NONE before */
    bool is_wrong[POINTS]; /* the question itself turned out to be wrong at this point */
    size_t missing;        /* the number of points along the first parameter without an answer */
    char reason[PROBLEM_TEXT / 2]; /* why the first of the missing answers is missing */
};

void search_begin(struct search *search, const struct sweep *sweep, struct probe probe, double sign);

/* Computes the answers at the points of the first parameter, in parallel. */
bool search_points(struct search *search, struct problem *problem);

/* Returns search->sign times the answer at search->place, minus the value that is sought, or NaN. */
double search_ask(struct search *search);

/* Functions of a place along a line, whose context is the line: the value, and its distance to line->level.
 */
double line_at(double x, void *line);
double line_above(double x, void *line);

/* Places the points of a line. */
void line_place(struct line *line);

/* Reports that the answer is the same everywhere, or that there is none, as a problem. Returns false. */
bool search_constant(const struct search *search, domq_real answer, struct problem *problem);
bool search_empty(const struct search *search, struct problem *problem);

/* Writes the ranges of the parameters, such as "s = 0.02 .. 1 and push = 0 .. 30 rad/s". Returns `text`. */
enum { RANGES_TEXT = 192 };
const char *search_ranges(const struct search *search, char text[RANGES_TEXT]);

#endif
