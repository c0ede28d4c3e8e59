/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Trials: a row is run many times, each time with one change, to find the edge between values at which all
 * dominoes fall and values at which they do not. */
#ifndef DOM_TRIAL_H
#define DOM_TRIAL_H

#include "dispatch/dispatch.h"
#ifdef DOMQ
#define REAL_QUAD
#endif
#include "numerics/real.h"
#include <stdlib.h>
#include <string.h>

/* A series of trials. After an error, when the status is not DOM_OK, no more rows are run, and every trial
 * counts as a row that does not fall. */
struct trial {
    struct dom_row row;
    struct dom_compute compute;
    struct dom_domino *domino; /* copy of the row's dominoes, which the trials change */
    enum dom_window_of of;     /* the property that is changed */
    size_t k;                  /* index of the domino that is changed, from 0 */
    dom_real place;            /* position of that domino before the change: see DOM_WINDOW_PLACE */
    const struct kernel *kernel;
    /* runs the row again from the first changed domino on, or NULL if an engine runs the row */
    struct course *course;
    dom_row_make *make; /* writes the dominoes of the row for a given growth */
    void *context;
    enum dom_status status;
    struct dom_verdict verdict; /* verdict on the row that was run last */
    enum dom_row_end ends;      /* how the last row that did not fall ended */
    /* margin / barrier of one domino in the last run: the weakest one if the row fell, and the last one if
     * the row stopped. NaN if the row ended in another way. */
    dom_real spare;
};

struct trial trial_of(const struct dom_row *row, const struct dom_compute *compute);

/* Runs the row with its present dominoes, or only as many of these as decide the outcome. Returns true if all
 * dominoes fall. */
bool trial_falls(struct trial *t);

/* Runs the unchanged row, and prepares trials that change one domino or the gaps beside it. Returns true if
 * all dominoes fall. Call trial_end afterwards to free the memory, even after a failure. */
bool trial_begin(struct trial *t);
void trial_end(struct trial *t);

typedef bool trial_test(dom_real x, void *trial);

/* Returns the point closest to the edge at which the test was found to be true. The edge is between `good`,
 * where the test is true, and `bad`, where it is false. The search stops when `good` and `bad` are at most
 * absolute + relative * good apart, or are adjacent numbers. */
dom_real edge_find(trial_test *test, struct trial *t, dom_real good, dom_real bad, dom_real absolute,
                   dom_real relative);

/* Returns one unit of the first significant digit of a number, or of the digit that is `places` places after
 * the first. */
dom_real digit_of(dom_real value, int places);

/* ---- One value of the row: the property t->of of domino t->k ---- */

/* trial_now returns the current value of the property t->of of domino t->k, and trial_change sets this
 * value. */
dom_real trial_now(const struct trial *t);
void trial_change(struct trial *t, dom_real value);

/* A trial_test: returns true if all dominoes fall when trial_change has set the value. Restores the row
 * afterwards. */
bool falls_with(dom_real value, void *context);

/* trial_steps returns the number of values that are tried on the way from `value` to `end`, and value_step
 * returns value number i. */
int trial_steps(const struct trial *t);
dom_real value_step(const struct trial *t, dom_real value, dom_real end, int i);

/* Returns one unit of the last digit to which an edge near `value` is rounded. */
dom_real value_digit(const struct trial *t, dom_real value);

/* Searches from a good value towards a bad one, and returns the last value at which all dominoes still
 * fall, rounded to a few digits, away from the bad value. */
dom_real value_edge(struct trial *t, dom_real good, dom_real bad);

/* Searches from `now` towards `end`, and returns the last value at which all dominoes still fall. All
 * dominoes must fall with `good`, the value of step i - 1. */
dom_real value_until(struct trial *t, dom_real now, dom_real end, dom_real good, int i);

/* Searches from the current value towards `end`. *to is the first value at which all dominoes fall, and
 * *until is the last value up to which they still fall. Returns false if there is no such value. */
bool value_towards(struct trial *t, dom_real end, dom_real *to, dom_real *until);

#endif
