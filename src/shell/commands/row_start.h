/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Finds whether a row of a train's dominoes starts from its first domino, which stands at rest. A train that
 * already moves may have a larger growth than a row that has to be started. */
#ifndef SHELL_ROW_START_H
#define SHELL_ROW_START_H

#include "commands/rows/falling.h"

/* A row whose first domino just tips over, or gets the push of the session. */
struct start {
    size_t count; /* the dominoes that were run, START_DOMINOES at most */
    bool falls;   /* all of them fall */
    enum dom_row_end end;
    size_t stops_at;    /* the domino at which the row ends, from 1 */
    domq_real push;     /* rad/s, the weakest push with which all of them fall; NaN if none is enough */
    const char *engine; /* why the rigid-body engine runs the row, or NULL if the model runs it */
};

/* Runs a row of the train's dominoes. The row has `dominoes` dominoes, or only as many as decide whether a
 * row starts. If they do not all fall, also finds the weakest push with which they do. On failure, sets
 * *problem and returns false. */
bool start_find(const struct query *query, const struct domq_train *train, domq_real dominoes,
                struct start *start, struct problem *problem);

struct start_growths {
    domq_real
        r_max; /* the largest growth at which a row of a train's dominoes starts; NaN if there is none */
    bool has_engine; /* r_max is NaN because the rigid-body engine would take too long to find it */
};

/* Finds the largest growth, up to `highest`, at which a row of the train's dominoes starts. On failure, sets
 * *problem and returns false. */
bool start_growths_find(const struct query *query, const struct domq_train *train, domq_real highest,
                        struct start_growths *growths, struct problem *problem);

/* Returns "with a first domino that just tips over", or "with a push of 3 rad/s". */
struct words start_words(const struct query *query);

/* Writes why a row does not fall, for example "with a push of 3 rad/s it ends at domino 2: its energy is not
 * enough to tip it over; a push of 6.8 rad/s is enough". */
enum { START_TEXT = 400 };
const char *start_problem(const struct query *query, const struct start *start, char text[START_TEXT]);

#endif
