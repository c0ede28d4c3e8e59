/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * One row, many times, with one change: the searches for the boundary between rows that fall and rows that do
 * not.
 */
#ifndef DOM_TRIAL_H
#define DOM_TRIAL_H

#ifdef DOMQ
#define REAL_QUAD
#endif
#include "numerics/real.h"
#include "row/course.h"
#include <stdlib.h>
#include <string.h>

/* The row with one change. After a status other than DOM_OK no row is run, and none counts as falling. */
struct trial {
    struct dom_row row;
    struct dom_compute compute;
    struct dom_domino *domino; /* dominoes of the row, which the search changes */
    enum dom_window_of of;
    size_t k;                 /* index of the domino that is changed, from 0 */
    dom_real place;           /* of that domino now; see DOM_WINDOW_PLACE */
    struct dom_course course; /* runs the row again from where the change begins; or none */
    dom_row_make *make;       /* writes the row of a growth */
    void *context;
    enum dom_status status;
    struct dom_verdict verdict; /* of the last row */
    enum dom_row_end ends;      /* of the last row that did not fall */
};

static inline struct trial trial_of(const struct dom_row *row, const struct dom_compute *compute)
{
    struct trial t = {.row = *row, .compute = compute ? *compute : dom_compute_default(), .status = DOM_OK};
    t.row.floor = false;
    return t;
}

static inline bool trial_judged(struct trial *t)
{
    if (t->verdict.end != DOM_ROW_FALLS)
        t->ends = t->verdict.end;
    return t->status == DOM_OK && t->verdict.end == DOM_ROW_FALLS;
}

static inline bool trial_falls(struct trial *t)
{
    t->verdict.end = DOM_ROW_STOPS;
    if (t->status == DOM_OK)
        t->status = dom_row_run(&t->row, &t->compute, false, NULL, NULL, &t->verdict);
    return trial_judged(t);
}

/* Runs the unchanged row, and prepares trials in which one domino changes, or the gaps beside it. Returns
 * true if all fall. trial_end frees the memory. */
static inline bool trial_begin(struct trial *t)
{
    t->verdict.end = DOM_ROW_STOPS;
    if (t->row.engine)
        (void)trial_falls(t); /* an engine runs the whole row each time */
    else
        t->status = course_begin(&t->row, &t->compute, &t->course, &t->verdict);
    if (t->status == DOM_OK) {
        t->domino = malloc(t->row.count * sizeof *t->domino);
        if (t->domino)
            memcpy(t->domino, t->row.domino, t->row.count * sizeof *t->domino);
        else
            t->status = DOM_NO_MEMORY;
        t->row.domino = t->domino;
    }
    return trial_judged(t);
}

static inline void trial_end(struct trial *t)
{
    course_end(&t->course);
    free(t->domino);
}

typedef bool trial_test(dom_real x, void *trial);

/*
 * Returns the last x found with which the test is true, on the way from `good`, where it is true, to `bad`,
 * where it is not. Halves the distance until it is at most absolute + relative * x, or no number is between.
 * This is bisection, and neither num_root nor a solver of GSL: a test has no values to interpolate, the
 * answer must be a point that was tested, and GSL computes in double alone.
 */
static inline dom_real edge_find(trial_test *test, struct trial *t, dom_real good, dom_real bad,
                                 dom_real absolute, dom_real relative)
{
    while (fabs(good - bad) > absolute + relative * good) {
        dom_real middle = (good + bad) / 2;
        if (middle == good || middle == bad)
            break;
        *(test(middle, t) ? &good : &bad) = middle;
    }
    return good;
}

/* Returns one unit of the first digit of a number, or of the digit that many places after the first. */
static inline dom_real digit_of(dom_real value, int places)
{
    return pow(10, floor(log10(value)) - (dom_real)places);
}

/* ---- One value of the row ---- */

/* Values are rounded to this relative size, so that a person can type them. */
#define VALUE_DIGITS ((dom_real)1 / 1000000)
/* The same for rows that an engine runs, whose answers are good to a percent. */
#define VALUE_DIGITS_OF_ENGINE ((dom_real)1 / 100)

/* The number of values that are tried on each way; an engine takes thousands of times as long for each. */
enum { STEPS = 40, STEPS_OF_ENGINE = 10 };

static inline int trial_steps(const struct trial *t)
{
    return t->row.engine ? STEPS_OF_ENGINE : STEPS;
}

/* Returns the value that the trial changes, as it is now. */
static inline dom_real trial_now(const struct trial *t)
{
    switch (t->of) {
    case DOM_WINDOW_PLACE:
        return t->place;
    case DOM_WINDOW_HEIGHT:
        return t->domino[t->k].height;
    case DOM_WINDOW_FRICTION:
        return t->row.mu;
    case DOM_WINDOW_PLUMB:
        return t->domino[t->k].lean;
    case DOM_WINDOW_GAP:
        break;
    }
    return t->domino[t->k].gap;
}

/* Moves the domino to a place, or changes the gap before it; or its height, or the friction. */
static inline void trial_change(struct trial *t, dom_real value)
{
    struct dom_domino *d = &t->domino[t->k];
    dom_real by = value - t->place;
    switch (t->of) {
    case DOM_WINDOW_GAP:
        d->gap = value;
        break;
    case DOM_WINDOW_PLACE:
        d->gap = fmax(d->gap + by, 0);
        /* A place at the end of the reach is not out of it by the rounding of the sum. */
        if (t->k > 0 && fabs(d->gap - d[-1].height) < 4 * DOM_REAL_EPSILON * value)
            d->gap = d[-1].height;
        if (t->k + 1 < t->row.count)
            d[1].gap = fmax(d[1].gap - by, 0);
        break;
    case DOM_WINDOW_HEIGHT:
        d->mass *= value / d->height; /* its density stays */
        d->height = value;
        break;
    case DOM_WINDOW_FRICTION:
        t->row.mu = value;
        break;
    case DOM_WINDOW_PLUMB:
        d->lean = value;
        break;
    }
}

/* Returns true if all fall with the value; a trial_test. The row is as before then. */
static inline bool falls_with(dom_real value, void *context)
{
    struct trial *t = context;
    const size_t next = t->k + 1 < t->row.count;
    const struct dom_domino own = t->domino[t->k], after = t->domino[t->k + next];
    dom_real mu = t->row.mu;
    bool falls;
    trial_change(t, value);
    if (t->of == DOM_WINDOW_FRICTION || t->row.engine) {
        falls = trial_falls(t);
        if (t->row.engine && t->status == DOM_NOT_CONVERGED)
            t->status = DOM_OK; /* a row that an engine cannot decide does not count as falling */
    } else {
        t->verdict.end = DOM_ROW_STOPS;
        if (t->status == DOM_OK)
            t->status = course_again(&t->course, t->domino, t->k, t->k + (next && t->of == DOM_WINDOW_PLACE),
                                     &t->verdict);
        falls = trial_judged(t);
    }
    t->row.mu = mu;
    t->domino[t->k + next] = after;
    t->domino[t->k] = own;
    return falls;
}

/*
 * Returns what edge_find returns for falls_with, in fewer trials. Where the row stops beyond the edge, the
 * energy to spare (course_again) goes through 0 there: every other trial is where the line through both
 * ends does, moved by half of `absolute` to the end that is farther off, so that this end comes close, too.
 */
static inline dom_real value_find(struct trial *t, dom_real good, dom_real bad, dom_real absolute)
{
    dom_real of_good = DOM_NAN, of_bad = DOM_NAN;
    for (bool halve = true; fabs(good - bad) > absolute; halve = !halve) {
        dom_real middle = (good + bad) / 2, x = middle;
        if (middle == good || middle == bad)
            break;
        if (!halve && of_good > 0 && of_bad < 0) {
            x = good + (bad - good) * (of_good / (of_good - of_bad));
            x += (fabs(x - good) < fabs(bad - x)) == (bad > good) ? absolute / 2 : -absolute / 2;
        }
        if (!(x > fmin(good, bad) && x < fmax(good, bad)))
            x = middle;
        bool falls = falls_with(x, t);
        *(falls ? &good : &bad) = x;
        *(falls ? &of_good : &of_bad) = falls || t->ends == DOM_ROW_STOPS ? t->verdict.spare : DOM_NAN;
    }
    return good;
}

/* Finds the last value with which all fall, between a good one and a bad one, and rounds it to few digits,
 * away from the bad one. */
static inline dom_real value_edge(struct trial *t, dom_real good, dom_real bad)
{
    dom_real digits = t->row.engine ? VALUE_DIGITS_OF_ENGINE : VALUE_DIGITS;
    dom_real digit = digit_of(fmax(fabs(good), fabs(bad)), 0) * digits;
    good = value_find(t, good, bad, digit / (t->row.engine ? 2 : 8));
    dom_real rounded = (good > bad ? ceil(good / digit) : floor(good / digit)) * digit;
    return falls_with(rounded, t) ? rounded : good;
}

/* Returns step i on the way from a value to `end`: the first steps are short, so that a small change is
 * found. */
static inline dom_real value_step(const struct trial *t, dom_real value, dom_real end, int i)
{
    dom_real part = (dom_real)i / (dom_real)trial_steps(t);
    return value + (end - value) * part * part * part;
}

/* Returns the last value on the way from `now` to `end` with which all fall, from step i on; all fall with
 * `good`, the step before. */
static inline dom_real value_until(struct trial *t, dom_real now, dom_real end, dom_real good, int i)
{
    for (; i <= trial_steps(t); i++) {
        dom_real next = value_step(t, now, end, i);
        if (!falls_with(next, t))
            return value_edge(t, good, next);
        good = next;
    }
    return end;
}

/* Finds the nearest value on the way to `end` with which all fall, and the farthest from there. Returns false
 * if there is none. */
static inline bool value_towards(struct trial *t, dom_real end, dom_real *to, dom_real *until)
{
    dom_real now = trial_now(t), bad = now, good = now;
    int i = 1;
    while (i <= trial_steps(t) && !falls_with(good = value_step(t, now, end, i), t)) {
        bad = good;
        i++;
    }
    if (i > trial_steps(t))
        return false;
    *to = value_edge(t, good, bad);
    *until = value_until(t, now, end, good, i + 1);
    return t->status == DOM_OK;
}

#endif
