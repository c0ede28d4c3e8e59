/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A candidate for a designed row: its dominoes, its length, and its kinetic energy relative to the barrier.
 * The separation s is a gap divided by the height of the domino after the gap. Only multiples of 1 / GRID are
 * tried: s = k / GRID. If k increases by 1, the gaps of the standard domino become 0.05 mm wider.
 */
#ifndef DOM_PLANNER_H
#define DOM_PLANNER_H

#include "entry/study.h"
#include "numerics/real.h"

enum { GRID = 1000 };

/* A candidate row. Its separation is k / GRID, and it has steps + 1 dominoes. */
struct choice {
    int k;
    size_t steps;
};

/* The state of a search for a design. If an error occurs, `status` is set to a value other than DOM_OK. From
 * then on, nothing more is computed, and every test fails. */
struct planner {
    struct dom_train train;
    struct dom_compute compute; /* settings of the search */
    const struct dom_wish *wish;
    const struct dom_limits *limits; /* the sizes that the dominoes may have, or NULL if any are allowed */
    double hall;                     /* the length that a row may have */
    struct dom_domino *domino;       /* array of `room` dominoes */
    size_t room;
    enum dom_status status;
    double failed_s; /* last separation at which a train or row could not be computed; 0 if there is none */
    bool whole; /* true to run all dominoes; false to end a run at the first one that is not safe enough */
    /* number of the weakest domino in the last run, counted from 1: the domino with the smallest ratio of
     * kinetic energy to barrier; the first domino does not count, because its energy depends on the push */
    size_t weakest;
    struct choice pushed;           /* the row for which a push is searched */
    double least;                   /* ratio of kinetic energy to barrier of `weakest` */
    double seconds, engine_seconds; /* duration of the last run in the model and in the engine */
    bool engine_refused; /* true if a row was safe enough in the model but did not fall in the engine */
};

static inline double separation(int k)
{
    return (double)k / GRID;
}

/* Returns the growth that leads from the first height to the last in `steps` steps. */
static inline double planner_growth(const struct planner *p, size_t steps)
{
    return pow(p->wish->height / p->wish->first, 1 / (double)steps);
}

/* Returns the ratio of kinetic energy to barrier in an endless train. If there is no such ratio, for example
 * because the next domino is out of reach, returns 0. */
double planner_train_ratio(struct planner *p, double s, double r);

/* Writes the dominoes of a candidate row to p->domino. If memory is exhausted, or if the walls do not fit
 * into a domino, sets p->status and returns false. */
bool planner_write(struct planner *p, struct choice c);

/* Returns a row with the `count` dominoes that planner_write wrote last. */
struct dom_row planner_row(const struct planner *p, size_t count, double push,
                           const struct dom_engine *engine);

/* Writes a candidate row and runs it. Returns the smallest ratio of kinetic energy to barrier among the
 * dominoes after the first. If the row does not fall, returns 0. If `times` is false, the run ends at the
 * first domino whose ratio is below the required safety, and this ratio is returned. Since the dominoes after
 * it are not run, the row may stop even if the ratio is above 1. */
double planner_row_ratio(struct planner *p, struct choice c, double push, bool times);

/* Returns the length of a standing row, from the back of the first domino to the front of the last. */
double planner_feet(struct planner *p, struct choice c);

/* Returns the largest k, up to GRID, for which a row with the separation k / GRID fits into the hall. If
 * there is none, returns 0. The dimensions of the row are not rounded to a grid. */
int planner_widest(const struct planner *p, size_t steps, double hall);

#endif
