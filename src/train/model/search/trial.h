/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A trial changes one value of a row and runs the row to see whether all dominoes fall. A series of trials
 * finds an edge: a value on whose one side all dominoes fall, and on whose other side some do not. */
#ifndef DOM_TRIAL_H
#define DOM_TRIAL_H

#include "entry/study.h"
#include "numerics/decimal.h"
#include "numerics/real.h"
#include <stdlib.h>
#include <string.h>

/* ---- Edges ---- */

/* Tests a value. If a number is known that is positive where the test is true, negative where it is false,
 * and that changes smoothly near the edge, the test may write it to *spare. */
typedef bool edge_test(double x, double *spare, void *context);

/*
 * Searches for the edge between two values. At the value `good`, the test is true, and at the value `bad`, it
 * is false. The search moves these two values closer and closer together, until their distance is at most
 * `tol` times the larger of their sizes. If `digit` > 0, it tries only multiples of `digit`, and stops when
 * none lies between the two values. Returns the last value of `good`, and sets *bad to the last value of
 * `bad`.
 */
double edge_find(edge_test *test, void *context, double good, double *bad, double digit, double tol);

/* ---- Trials ---- */

/* A series of trials. If an error occurs, `status` is set to a value other than DOM_OK. From then on, no more
 * rows are run, and all trials return false. */
struct trial {
    struct dom_row row;
    struct dom_compute compute;
    struct dom_domino *domino; /* copy of the row's dominoes, which the trials change */
    int of;                    /* the property that is changed, an enum dom_window_of */
    size_t k;                  /* index of the domino that is changed, from 0 */
    /* distance from the back of the first domino to the back of domino k before the change */
    double place;
    /* the state for running slightly changed rows, or NULL if an engine runs them */
    struct study *study;
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
