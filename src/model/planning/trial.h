/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Trials: one row is run many times with one change, in search of the edge between rows that fall and rows
 * that do not.
 */
#ifndef DOM_TRIAL_H
#define DOM_TRIAL_H

#include "dispatch/dispatch.h"
#ifdef DOMQ
#define REAL_QUAD
#endif
#include "numerics/real.h"
#include <stdlib.h>
#include <string.h>

/* Once the status is not DOM_OK, no row is run any more, and no trial counts as a row that falls. */
struct trial {
    struct dom_row row;
    struct dom_compute compute;
    struct dom_domino *domino; /* the dominoes of the row, which the search changes */
    enum dom_window_of of;     /* what is changed */
    size_t k;                  /* index of the domino that is changed, from 0 */
    dom_real place;            /* of that domino before the change: see DOM_WINDOW_PLACE */
    const struct kernel *kernel;
    struct course *course; /* runs the row again from where the change begins; NULL if an engine runs it */
    dom_row_make *make;    /* writes the row of a growth */
    void *context;
    enum dom_status status;
    struct dom_verdict verdict; /* of the last row */
    enum dom_row_end ends;      /* how the last row that did not fall ended */
};

struct trial trial_of(const struct dom_row *row, const struct dom_compute *compute);

/* Runs the row as it is now. Returns true if all dominoes fall. */
bool trial_falls(struct trial *t);

/* Runs the unchanged row, and prepares trials that change one domino or the gaps beside it. Returns true if
 * all dominoes fall. trial_end frees the memory, also after a failure. */
bool trial_begin(struct trial *t);
void trial_end(struct trial *t);

typedef bool trial_test(dom_real x, void *trial);

/* Returns the last x found with which the test is true, between `good`, where it is true, and `bad`, where it
 * is false. Stops when both are at most absolute + relative * x apart, or when no number is between them. */
dom_real edge_find(trial_test *test, struct trial *t, dom_real good, dom_real bad, dom_real absolute,
                   dom_real relative);

/* Returns one unit of the first digit of a number, or of the digit that many places after the first. */
dom_real digit_of(dom_real value, int places);

/* ---- One value of the row: what t->of says of domino t->k ---- */

/* Returns the value in the row as it is, or changes it. */
dom_real trial_now(const struct trial *t);
void trial_change(struct trial *t, dom_real value);

/* Returns true if all dominoes fall with the value, and restores the row. This is a trial_test. */
bool falls_with(dom_real value, void *context);

/* Returns the number of values that are tried on the way from one value to another, and value number i. */
int trial_steps(const struct trial *t);
dom_real value_step(const struct trial *t, dom_real value, dom_real end, int i);

/* Returns the last value with which all fall, between a good value and a bad one, rounded to few digits away
 * from the bad one. */
dom_real value_edge(struct trial *t, dom_real good, dom_real bad);

/* Returns the last value on the way from `now` to `end` with which all fall. All fall with `good`, which is
 * step i - 1 of that way. */
dom_real value_until(struct trial *t, dom_real now, dom_real end, dom_real good, int i);

/* Finds the nearest value on the way to `end` with which all fall, and the farthest value up to which they
 * still fall. Returns false if there is none. */
bool value_towards(struct trial *t, dom_real end, dom_real *to, dom_real *until);

#endif
