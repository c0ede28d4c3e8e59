/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Finds out whether a row that is at rest starts to fall. A train that is already moving can have a larger
 * growth than a row that starts from rest. */
#ifndef SHELL_ROW_START_H
#define SHELL_ROW_START_H

#include "train/falling.h"

/* The result of running a row. If 'set push' is on, the fall starts with this push. If it is off, the
 * first domino just tips over. */
struct start {
    size_t count; /* number of dominoes in the row that was run */
    bool falls;   /* true if all dominoes of the row fall */
    enum dom_row_end end;
    size_t stops_at;    /* number of the domino at which the fall ends, counted from 1 */
    domq_real push;     /* the weakest push in rad/s that makes the row fall, or NaN */
    const char *engine; /* why the rigid-body engine runs the row, or NULL if the model runs it */
};

/* Runs a row of `dominoes` dominoes of the train, or the first part of a very long row. If the row does not
 * fall in the model, also finds start->push. Does not search for a push with the rigid-body engine. */
bool start_find(const struct query *query, const struct domq_train *train, domq_real dominoes,
                struct start *start, struct problem *problem);

/* Returns a copy of the scene with a row of `count` dominoes. The copy shares the memory of the original. */
struct scene start_scene(const struct query *query, const struct domq_train *train, size_t count);

/* Runs a row as start_find does. Returns its smallest margin / barrier, which is positive if all dominoes
 * fall. If the row stops, the result is not positive, and smaller by 1 for each domino that is left. Returns
 * -INFINITY if the fall ends in another way. If memory runs out, or if the user interrupts the run, sets
 * *status. */
double start_row_spare(const struct query *query, const struct domq_train *train, domq_real dominoes,
                       enum dom_status *status);

/* Returns margin / barrier of a moving train, which is positive if it keeps falling. Returns -INFINITY if a
 * domino misses the next one or if falling releases no energy. */
double start_train_spare(const struct query *query, const struct domq_train *train);

struct start_growths {
    domq_real r_max;       /* the largest growth at which a row starts, or NaN if no growth is small enough */
    domq_real uncertainty; /* r_max is wrong by at most this number */
    bool is_too_slow;      /* true if r_max is NaN because the engine would take too long */
};

/* Finds the largest growth, up to `highest`, at which a row of the train's dominoes starts. */
bool start_growths_find(const struct query *query, const struct domq_train *train, domq_real highest,
                        struct start_growths *growths, struct problem *problem);

/* Returns "if its first domino just tips over", or "with a push of 3 rad/s". */
struct words start_words(const struct query *query);

/* Writes to `text` the reason why a row does not fall, for example "with a push of 3 rad/s, the fall ends at
 * domino 2: it has too little energy to tip over". Returns `text`. */
enum { START_TEXT = 400 };
const char *start_problem(const struct query *query, const struct start *start, char text[START_TEXT]);

#endif
