/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "planning/trial.h"
#include "planning/boxes.h"

struct trial trial_of(const struct dom_row *row, const struct dom_compute *compute)
{
    struct trial t = {.row = *row, .compute = compute_or_default(compute), .status = DOM_OK};
    t.row.floor = false;
    return t;
}

static bool trial_judged(struct trial *t)
{
    const bool falls = t->status == DOM_OK && t->verdict.end == DOM_ROW_FALLS;
    if (t->verdict.end != DOM_ROW_FALLS)
        t->ends = t->verdict.end;
    t->spare = falls || t->verdict.end == DOM_ROW_STOPS ? t->verdict.spare : DOM_NAN;
    return falls;
}

enum { RECENT = 4 };
struct recent {
    dom_real share[RECENT]; /* margin / kinetic energy of the last RECENT dominoes, beginning with the last */
    dom_real spare;         /* margin / barrier of the last domino */
};

static bool recent_add(const struct dom_fall *fall, void *context)
{
    struct recent *recent = context;
    memmove(&recent->share[1], recent->share, (RECENT - 1) * sizeof *recent->share);
    recent->share[0] = fall->margin / fall->kinetic;
    recent->spare = fall->margin / fall->barrier;
    return true;
}

static void trial_run(struct trial *t, size_t count, struct recent *recent)
{
    struct dom_row row = t->row;
    row.count = count;
    t->status = row_verdict(&row, &t->compute, false, recent_add, recent, &t->verdict);
    if (t->status == DOM_OK && t->verdict.end == DOM_ROW_STOPS)
        t->verdict.spare = recent->spare;
}

/* Returns true if the row is part of a train. In a train, all dominoes have the same proportions. Sizes and
 * masses grow by a constant factor from domino to domino. If the dominoes have walls, returns false, since
 * walls of equal thickness would change the proportions. Also returns false if an engine runs the row. */
static bool is_train(const struct dom_row *row)
{
    const double same = 1e-12;
    const struct dom_domino *d = row->domino;
    if (row->engine || row->walls != 0 || row->count < 2)
        return false;
    const double r = (double)(d[1].height / d[0].height), heavier = (double)(d[1].mass / d[0].mass);
    for (size_t k = 0; k < row->count; k++) {
        const double next = k == 0 ? 0 : r * (double)d[k - 1].height, height = (double)d[k].height;
        if ((k > 0 && !(fabs(height - next) <= same * next)) || d[k].lean != 0 || d[k].radius != 0 ||
            !(fabs((double)d[k].thickness / height - (double)d[0].thickness / (double)d[0].height) <= same) ||
            (k > 0 && !(fabs((double)d[k].gap / height - (double)d[1].gap / (double)d[1].height) <= same &&
                        fabs((double)d[k].mass / (double)d[k - 1].mass / heavier - 1) <= same)))
            return false;
    }
    return true;
}

/*
 * Runs only the first START dominoes of a train, to save time. Returns true if their fall already shows
 * whether the whole row falls. If the fall ends before the last of these dominoes, the row does not fall.
 *
 * The margin of a domino is the energy that it has to spare, here as a fraction of its kinetic energy. In a
 * train, this fraction changes less and less from domino to domino. To be on the safe side, this test assumes
 * that the fraction decreases at every further domino, and each time by the size of its last change. If more
 * than half of the fraction would still be left at the end of the row, the test concludes that the whole row
 * falls.
 */
static bool start_decides(struct trial *t)
{
    enum { START = 7 };
    struct recent recent = {.spare = DOM_NAN};
    if (t->row.count <= START || !is_train(&t->row))
        return false;
    trial_run(t, START, &recent);
    if (t->status != DOM_OK || t->verdict.end != DOM_ROW_FALLS)
        return t->status != DOM_OK || t->verdict.domino < START;
    /* share[0] is left out of `change`, because the last domino of this run hits no other domino. */
    const dom_real *share = recent.share, change = fabs(share[1] - share[2]);
    return change <= fabs(share[2] - share[3]) &&
           (dom_real)(t->row.count - START) * change < fmin(share[0], share[1]) / 2;
}

bool trial_falls(struct trial *t)
{
    struct recent recent = {.spare = DOM_NAN};
    t->verdict.end = DOM_ROW_STOPS;
    if (t->status == DOM_OK && !start_decides(t))
        trial_run(t, t->row.count, &recent);
    return trial_judged(t);
}

/* Runs the unchanged row and stores states from which runs of changed rows can start. */
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
        (void)trial_falls(t); /* an engine cannot start in the middle of a row */
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

/*
 * Neither num_root nor a solver of GSL can be used here, because some tests yield no number, and because the
 * result must be a point that was tested. Besides, GSL has only double precision.
 *
 * In general, this is a bisection. If the spare energies at both ends are known, and one is positive and the
 * other negative, every second step uses the secant method instead.
 */
dom_real edge_find(trial_test *test, struct trial *t, dom_real good, dom_real bad, dom_real absolute,
                   dom_real relative)
{
    dom_real of_good = DOM_NAN, of_bad = DOM_NAN, near;
    for (bool halve = true; fabs(good - bad) > (near = absolute + relative * good); halve = !halve) {
        dom_real middle = (good + bad) / 2, x = middle;
        if (middle == good || middle == bad)
            break;
        if (!halve && of_good > 0 && of_bad < 0) {
            x = good + (bad - good) * (of_good / (of_good - of_bad));
            /* Shift x a little towards the farther end. Without this shift, only the nearer end would
             * approach the edge. */
            x += (fabs(x - good) < fabs(bad - x)) == (bad > good) ? near / 2 : -near / 2;
        }
        if (!(x > fmin(good, bad) && x < fmax(good, bad)))
            x = middle;
        bool falls = test(x, t);
        *(falls ? &good : &bad) = x;
        *(falls ? &of_good : &of_bad) = t->spare;
    }
    return good;
}

dom_real digit_of(dom_real value, int places)
{
    return pow(10, floor(log10(value)) - (dom_real)places);
}

/* ---- One value of the row ---- */

/* Values are rounded to this relative precision, which makes them short enough to type. */
#define VALUE_DIGITS ((dom_real)1 / 1000000)
/* the relative precision with an engine, whose results are accurate to only one percent */
#define VALUE_DIGITS_OF_ENGINE ((dom_real)1 / 100)

/* the number of values that are tried in each direction; with an engine, fewer values are tried, because an
 * engine takes about a thousand times as long for each value */
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
    case DOM_WINDOW_LEAN:
        return t->domino[t->k].lean;
    case DOM_WINDOW_THICKNESS:
        return t->domino[t->k].thickness;
    case DOM_WINDOW_GAP:
        break;
    }
    return t->domino[t->k].gap;
}

/* Changes the height or the thickness of a domino: *size becomes `value`. The density of the wood, the
 * thickness of the walls and the width stay the same. So the mass changes too. */
static void size_set(const struct dom_row *row, struct dom_domino *d, dom_real *size, dom_real value)
{
    const struct dom_domino before = *d;
    const dom_real times = value / *size;
    d->width = width_of(d);
    *size = value;
    d->mass *= wood_factor(row, &before, d, times);
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
        /* rounding must not put the gap out of reach of the previous domino */
        if (t->k > 0 && fabs(d->gap - d[-1].height) < 4 * DOM_REAL_EPSILON * value)
            d->gap = d[-1].height;
        if (t->k + 1 < t->row.count)
            d[1].gap = fmax(d[1].gap - by, 0);
        break;
    case DOM_WINDOW_HEIGHT:
        size_set(&t->row, d, &d->height, value);
        break;
    case DOM_WINDOW_FRICTION:
        t->row.mu = value;
        break;
    case DOM_WINDOW_LEAN:
        d->lean = value;
        break;
    case DOM_WINDOW_THICKNESS:
        size_set(&t->row, d, &d->thickness, value);
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
            /* if the engine cannot decide whether the row falls, the row counts as not falling */
            t->status = DOM_OK;
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

dom_real value_digit(const struct trial *t, dom_real value)
{
    return digit_of(fabs(value), 0) * (t->row.engine ? VALUE_DIGITS_OF_ENGINE : VALUE_DIGITS);
}

/* Like value_edge, but for an engine. An engine is slow, and its results are accurate to only one percent. So
 * the values that are tried have few digits, and the search ends when the edge is known to half a percent. */
static dom_real value_edge_engine(struct trial *t, dom_real good, dom_real bad)
{
    const dom_real digit = value_digit(t, fmax(fabs(good), fabs(bad))),
                   near = fmax(digit, fmax(fabs(good), fabs(bad)) * VALUE_DIGITS_OF_ENGINE / 2);
    bool ends = false;
    while (!ends) {
        const dom_real x = round((good + bad) / 2 / digit) * digit;
        ends = !(fabs(good - bad) > near && x > fmin(good, bad) && x < fmax(good, bad));
        if (!ends)
            *(falls_with(x, t) ? &good : &bad) = x;
    }
    return good;
}

dom_real value_edge(struct trial *t, dom_real good, dom_real bad)
{
    if (t->row.engine)
        return value_edge_engine(t, good, bad);
    const dom_real digit = value_digit(t, fmax(fabs(good), fabs(bad)));
    good = edge_find(falls_with, t, good, bad, digit / 8, 0);
    const dom_real rounded = (good > bad ? ceil(good / digit) : floor(good / digit)) * digit;
    return falls_with(rounded, t) ? rounded : good;
}

/* The values that are tried are close together near `value`, and farther apart towards `end`. With an engine,
 * they are rounded to a few digits. */
dom_real value_step(const struct trial *t, dom_real value, dom_real end, int i)
{
    const dom_real part = (dom_real)i / (dom_real)trial_steps(t);
    const dom_real x = value + (end - value) * part * part * part;
    if (!t->row.engine || x == end)
        return x;
    const dom_real rounded = round(x / value_digit(t, x)) * value_digit(t, x);
    return fmin(fmax(rounded, fmin(value, end)), fmax(value, end));
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
