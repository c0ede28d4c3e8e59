/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "planning/trial.h"

struct trial trial_of(const struct dom_row *row, const struct dom_compute *compute)
{
    struct trial t = {.row = *row, .compute = compute_or_default(compute), .status = DOM_OK};
    t.row.floor = false;
    return t;
}

static bool trial_judged(struct trial *t)
{
    if (t->verdict.end != DOM_ROW_FALLS)
        t->ends = t->verdict.end;
    return t->status == DOM_OK && t->verdict.end == DOM_ROW_FALLS;
}

bool trial_falls(struct trial *t)
{
    t->verdict.end = DOM_ROW_STOPS;
    if (t->status == DOM_OK)
        t->status = row_verdict(&t->row, &t->compute, false, NULL, NULL, &t->verdict);
    return trial_judged(t);
}

/* Runs the unchanged row, and keeps the state that later runs of nearly the same row start from. */
static enum dom_status trial_course(struct trial *t)
{
    struct row_question q = row_question_make(&t->row, &t->compute);
    t->kernel = q.kernel;
    return ASK(q, row_course, &t->course, &t->verdict);
}

bool trial_begin(struct trial *t)
{
    t->verdict.end = DOM_ROW_STOPS;
    if (t->row.engine)
        (void)trial_falls(t); /* an engine runs the whole row each time */
    else
        t->status = trial_course(t);
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

void trial_end(struct trial *t)
{
    if (t->course)
        (void)t->kernel->row_course_end(t->course);
    free(t->domino);
}

/* Plain bisection is used, neither num_root nor a solver of GSL: a test returns no numbers to interpolate,
 * the result must be a point that was tested, and GSL computes only in double. */
dom_real edge_find(trial_test *test, struct trial *t, dom_real good, dom_real bad, dom_real absolute,
                   dom_real relative)
{
    while (fabs(good - bad) > absolute + relative * good) {
        dom_real middle = (good + bad) / 2;
        if (middle == good || middle == bad)
            break;
        *(test(middle, t) ? &good : &bad) = middle;
    }
    return good;
}

dom_real digit_of(dom_real value, int places)
{
    return pow(10, floor(log10(value)) - (dom_real)places);
}

/* ---- One value of the row ---- */

/* Values are rounded to this relative precision, so that a person can type them. */
#define VALUE_DIGITS ((dom_real)1 / 1000000)
/* The relative precision for rows that an engine runs, whose results are accurate to one percent. */
#define VALUE_DIGITS_OF_ENGINE ((dom_real)1 / 100)

/* The number of values that are tried in each direction. An engine takes thousands of times as long for each
 * value. */
enum { STEPS = 40, STEPS_OF_ENGINE = 10 };

int trial_steps(const struct trial *t)
{
    return t->row.engine ? STEPS_OF_ENGINE : STEPS;
}

dom_real trial_now(const struct trial *t)
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
    case DOM_WINDOW_THICKNESS:
        return t->domino[t->k].thickness;
    case DOM_WINDOW_GAP:
        break;
    }
    return t->domino[t->k].gap;
}

void trial_change(struct trial *t, dom_real value)
{
    struct dom_domino *d = &t->domino[t->k];
    dom_real by = value - t->place;
    switch (t->of) {
    case DOM_WINDOW_GAP:
        d->gap = value;
        break;
    case DOM_WINDOW_PLACE:
        d->gap = fmax(d->gap + by, 0);
        /* A domino at the end of the reach must not get out of reach by the rounding of the sum. */
        if (t->k > 0 && fabs(d->gap - d[-1].height) < 4 * DOM_REAL_EPSILON * value)
            d->gap = d[-1].height;
        if (t->k + 1 < t->row.count)
            d[1].gap = fmax(d[1].gap - by, 0);
        break;
    case DOM_WINDOW_HEIGHT:
        d->mass *= value / d->height; /* the density does not change */
        d->height = value;
        break;
    case DOM_WINDOW_FRICTION:
        t->row.mu = value;
        break;
    case DOM_WINDOW_PLUMB:
        d->lean = value;
        break;
    case DOM_WINDOW_THICKNESS:
        d->mass *= value / d->thickness; /* the density does not change */
        d->thickness = value;
        break;
    }
}

bool falls_with(dom_real value, void *context)
{
    struct trial *t = context;
    const size_t next = t->k + 1 < t->row.count;
    const struct dom_domino self = t->domino[t->k], after = t->domino[t->k + next];
    dom_real mu = t->row.mu;
    bool falls;
    trial_change(t, value);
    if (t->of == DOM_WINDOW_FRICTION || t->row.engine) {
        falls = trial_falls(t);
        if (t->row.engine && t->status == DOM_NOT_CONVERGED)
            t->status = DOM_OK; /* a row that an engine cannot decide counts as one that does not fall */
    } else {
        t->verdict.end = DOM_ROW_STOPS;
        if (t->status == DOM_OK)
            t->status = t->kernel->row_again(t->course, t->domino, t->k,
                                             t->k + (next && t->of == DOM_WINDOW_PLACE), &t->verdict);
        falls = trial_judged(t);
    }
    t->row.mu = mu;
    t->domino[t->k + next] = after;
    t->domino[t->k] = self;
    return falls;
}

/*
 * Does the same as edge_find with the test falls_with, in fewer trials. Where the row stops on the far side
 * of the edge, the spare energy of a trial (verdict.spare) changes its sign at the edge. Every other trial is
 * therefore placed where the straight line through the spare energies at both ends is zero. The point is then
 * moved by half of `absolute` towards the end that is farther away, so that this end comes close to the edge
 * as well.
 */
static dom_real value_find(struct trial *t, dom_real good, dom_real bad, dom_real absolute)
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

dom_real value_edge(struct trial *t, dom_real good, dom_real bad)
{
    dom_real digits = t->row.engine ? VALUE_DIGITS_OF_ENGINE : VALUE_DIGITS;
    dom_real digit = digit_of(fmax(fabs(good), fabs(bad)), 0) * digits;
    good = value_find(t, good, bad, digit / (t->row.engine ? 2 : 8));
    dom_real rounded = (good > bad ? ceil(good / digit) : floor(good / digit)) * digit;
    return falls_with(rounded, t) ? rounded : good;
}

/* The first steps are short, so that a small change is found. */
dom_real value_step(const struct trial *t, dom_real value, dom_real end, int i)
{
    dom_real part = (dom_real)i / (dom_real)trial_steps(t);
    return value + (end - value) * part * part * part;
}

dom_real value_until(struct trial *t, dom_real now, dom_real end, dom_real good, int i)
{
    for (; i <= trial_steps(t); i++) {
        dom_real next = value_step(t, now, end, i);
        if (!falls_with(next, t))
            return value_edge(t, good, next);
        good = next;
    }
    return end;
}

bool value_towards(struct trial *t, dom_real end, dom_real *to, dom_real *until)
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
