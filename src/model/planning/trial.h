/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A trial changes one value of a row and runs the row to see whether all dominoes fall. A series of trials
 * finds an edge: on one side of the edge, all dominoes fall, and on the other side, some do not. */
#ifndef DOM_TRIAL_H
#define DOM_TRIAL_H

#include "dispatch/dispatch.h"
#ifdef DOMQ
#define REAL_QUAD
#endif
#include "numerics/real.h"
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
    dom_real place;
    const struct kernel *kernel;
    /* the kernel's state for running slightly changed rows, or NULL if an engine runs them */
    struct course *course;
    dom_row_make *make; /* callback that writes the dominoes of the row for a given growth */
    void *context;
    enum dom_status status;
    struct dom_verdict verdict; /* verdict of the last run */
    enum dom_row_end ends;      /* how the fall ended in the last run in which some dominoes did not fall */
    /* Spare energy in the last run, as a fraction of the barrier (margin / barrier). If the row fell, this is
     * the spare energy of the weakest domino. If the row stopped for lack of energy, it is the spare energy
     * of the domino at which it stopped. If the fall ended in another way, it is NaN. */
    dom_real spare;
};

struct trial trial_of(const struct dom_row *row, const struct dom_compute *compute);

/* Runs the row with its current dominoes. Returns true if all dominoes fall. To save time, the run ends early
 * if the first dominoes already decide the result. */
bool trial_falls(struct trial *t);

/* Runs the unchanged row. Returns true if all dominoes fall. Also prepares trials that change one domino or
 * the gaps beside it. The caller must call trial_end afterwards, even after a failure. */
bool trial_begin(struct trial *t);
void trial_end(struct trial *t);

typedef bool trial_test(dom_real x, void *trial);

/* Searches for the edge between two values. At the value `good`, the test is true, and at the value `bad`, it
 * is false. The search moves these two values closer and closer together. It stops when no number lies
 * between them, or when |good - bad| <= absolute + relative * good. Returns the last value of `good`. */
dom_real edge_find(trial_test *test, struct trial *t, dom_real good, dom_real bad, dom_real absolute,
                   dom_real relative);

/* Returns the place value of one digit of `value`. If places = 0, this is the first significant digit. If
 * places = 1, it is the next digit, and so on. For example, digit_of(250, 1) is 10. */
dom_real digit_of(dom_real value, int places);

/* ---- The property that is changed (t->of) ---- */

/* trial_now returns the current value of the property t->of, such as the gap before domino t->k. trial_change
 * sets the property to another value. */
dom_real trial_now(const struct trial *t);
void trial_change(struct trial *t, dom_real value);

/* A trial_test. Sets the property to `value`, runs the row, and then restores the row. Returns true if all
 * dominoes fall. */
bool falls_with(dom_real value, void *context);

/* A search from `value` towards `end` tries trial_steps values, the last of which is `end`. value_step
 * returns value number i, counted from 1. */
int trial_steps(const struct trial *t);
dom_real value_step(const struct trial *t, dom_real value, dom_real end, int i);

/* Values are rounded to a few digits, so that they are easy to type. Returns the place value of the last
 * digit that is kept when a number near `value` is rounded. */
dom_real value_digit(const struct trial *t, dom_real value);

/* Searches for the edge between two values. All dominoes must fall at the value `good`, but not at the value
 * `bad`. Returns the value nearest to `bad` at which all dominoes still fall. The result is rounded to a few
 * digits, towards `good`, unless some domino does not fall at the rounded value. */
dom_real value_edge(struct trial *t, dom_real good, dom_real bad);

/* Continues a search that moves in steps from the value `now` to the value `end`. The next step is step i.
 * The step before it has reached the value `good`, at which all dominoes must fall. Returns the last value up
 * to which all dominoes fall. */
dom_real value_until(struct trial *t, dom_real now, dom_real end, dom_real good, int i);

/* Searches from the current value towards `end` for a range of values at which all dominoes fall. If there is
 * one, stores the value at which the range begins in *to, and the value at which it ends in *until. Returns
 * false if no such range is found. */
bool value_towards(struct trial *t, dom_real end, dom_real *to, dom_real *until);

#endif
