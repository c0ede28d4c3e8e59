/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A trial changes one value of a row and runs the row to see whether all dominoes fall. A series of trials
 * finds an edge: on one side of the edge, all dominoes fall, and on the other side, some do not. */
#ifndef DOM_TRIAL_H
#define DOM_TRIAL_H

#include "entry/study.h"
#include "numerics/decimal.h"
#include "numerics/real.h"
#include "search/edge.h"
#include <stdlib.h>
#include <string.h>

/* A series of trials. If an error occurs, `status` is set to a value other than DOM_OK. From then on, no more
 * rows are run, and all trials return false. */
struct trial {
    struct dom_row row;
    struct dom_compute compute;
    struct dom_domino *domino; /* copy of the row's dominoes, which the trials change */
    enum dom_window_of of;     /* the property that is changed */
    size_t k;                  /* index of the domino that is changed, from 0 */
    /* distance from the back of the first domino to the back of domino k before the change */
    double place;
    /* the state for running slightly changed rows, or NULL if an engine runs them */
    struct study *study;
    dom_row_make *make; /* callback that writes the dominoes of the row for a given growth */
    void *context;
    enum dom_status status;
    struct dom_verdict verdict; /* verdict of the last run */
    enum dom_row_end ends;      /* how the fall ended in the last run in which some dominoes did not fall */
    /* Spare energy in the last run, as a fraction of the barrier (margin / barrier). If the row fell, this is
     * the spare energy of the weakest domino. If the row stopped for lack of energy, it is the spare energy
     * of the domino at which it stopped. If the fall ended in another way, it is NaN. */
    double spare;
};

struct trial trial_of(const struct dom_row *row, const struct dom_compute *compute);

/* Runs the row with its current dominoes. Returns true if all dominoes fall. */
bool trial_falls(struct trial *t);

/* Evaluates the last run. Returns true if all dominoes have fallen. */
bool trial_judged(struct trial *t);

/* Changes the row by one value and runs it. Returns true if all dominoes fall. */
typedef bool trial_test(struct trial *t, double x);

/* Searches for the edge between two values (edge_find). At the value `good` all dominoes fall, and at the
 * value `bad` some do not. */
double trial_edge(struct trial *t, trial_test *test, double good, double *bad, double digit, double tol);

#endif
