/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A trial runs a row with one changed value. A series of trials finds the edge between the values at which
 * all dominoes fall and the values at which some do not. */
#ifndef DOM_TRIAL_H
#define DOM_TRIAL_H

#include "dispatch/dispatch.h"
#ifdef DOMQ
#define REAL_QUAD
#endif
#include "numerics/real.h"
#include <stdlib.h>
#include <string.h>

/* A series of trials. After an error, `status` is not DOM_OK, no more rows are run, and trials return
 * false. */
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
    /* Spare energy (margin / barrier) in the last run: of the weakest domino if the row fell, or of the
     * domino at which it stopped. NaN if the fall ended in another way. */
    dom_real spare;
};

struct trial trial_of(const struct dom_row *row, const struct dom_compute *compute);

/* Runs the row with its current dominoes. Returns true if all dominoes fall. Runs only the first
 * dominoes if these already decide the result. */
bool trial_falls(struct trial *t);

/* Runs the unchanged row, and prepares trials that change one domino or the gaps beside it. Returns true if
 * all dominoes fall. Call trial_end afterwards, even after a failure. */
bool trial_begin(struct trial *t);
void trial_end(struct trial *t);

typedef bool trial_test(dom_real x, void *trial);

/* Searches for the edge between `good`, where the test is true, and `bad`, where it is false. Stops when
 * |good - bad| <= absolute + relative * good, or when no number lies between them. Returns the last
 * `good`. */
dom_real edge_find(trial_test *test, struct trial *t, dom_real good, dom_real bad, dom_real absolute,
                   dom_real relative);

/* Returns the place value of one digit of `value`: the first significant digit if places = 0, the next digit
 * if places = 1, and so on. */
dom_real digit_of(dom_real value, int places);

/* ---- The value that is changed (t->of), in most cases a property of domino t->k ---- */

/* trial_now returns this value, and trial_change sets it. */
dom_real trial_now(const struct trial *t);
void trial_change(struct trial *t, dom_real value);

/* A trial_test: runs the row with this value, then restores the row. Returns true if all dominoes fall. */
bool falls_with(dom_real value, void *context);

/* A search tries trial_steps values between `value` and `end`. value_step returns value number i. */
int trial_steps(const struct trial *t);
dom_real value_step(const struct trial *t, dom_real value, dom_real end, int i);

/* Returns the place value of the last digit that is kept when a number near `value` is rounded. */
dom_real value_digit(const struct trial *t, dom_real value);

/* All dominoes must fall at `good`, but not at `bad`. Returns the value nearest to `bad` at which they fall,
 * rounded to a few digits towards `good`. */
dom_real value_edge(struct trial *t, dom_real good, dom_real bad);

/* Continues the search from `now` to `end` with step i. All dominoes must fall at `good`, the value of step i
 * - 1. Returns the last value up to which they fall. */
dom_real value_until(struct trial *t, dom_real now, dom_real end, dom_real good, int i);

/* Searches from the current value towards `end` for a range in which all dominoes fall. Stores the
 * beginning of the range in *to, and its end in *until. Returns false if no such range is found. */
bool value_towards(struct trial *t, dom_real end, dom_real *to, dom_real *until);

#endif
