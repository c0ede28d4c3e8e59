/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Finds windows. All dominoes of a row fall only if its gaps, sizes and so on are neither too small nor too
 * large. The window of a gap is the range of gaps at which all dominoes fall, if nothing else in the row
 * changes. The position, the height, the thickness and the lean of a domino have windows too, and so does the
 * friction. If a row does not fall, its windows say which change of one value mends it. */
#include "rows/model/boxes.h"
#include "rows/model/study.h"
#include "search/search.h"
#include <float.h>
#include <stdlib.h>
#include <string.h>

/* A series of trials, each of which changes one value of a row and runs the row. If an error occurs, `status`
 * is set to a value other than DOM_OK. From then on, no more rows are run, and all trials return false. */
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
};

/* ---- The value that is changed ---- */

/* Heights are tried from HEIGHT_PART to HEIGHT_MULTIPLE times the current height, and likewise thicknesses.
 * Friction is tried up to FRICTION_MOST or four times the current friction, whichever is larger, but not
 * beyond DOM_MU_HIGHEST. */
#define HEIGHT_PART     0.01
#define HEIGHT_MULTIPLE 4
#define FRICTION_MOST   2

/* Heights, thicknesses and leans have limits, beyond which the domino falls over by itself, or has no room
 * for its walls or its rounded edges. The values that are tried stay this fraction away from the limits,
 * which is more than rounding errors. */
#define STANDS_SHORT 1e-6

struct range {
    double lowest, highest;
};

/*
 * Returns the range of heights that are tried.
 * - If a tilted domino is too tall, it falls over by itself. It stands if height < foot / tan(tilt), where
 *   foot = thickness - 2 radii.
 * - A domino with rounded edges must be taller than 2 radii.
 * - A solid domino must stay solid, and a box must stay a box.
 */
static struct range heights_of(const struct dom_row *row, const struct dom_domino *d, double tilt)
{
    double self = row->rho != 0 ? 2 * d->radius : 0, share = self > 0 ? 0 : 2 * row->rho;
    double stands = (d->thickness - self) / (tan(tilt) + share) * (1 - STANDS_SHORT);
    double lowest = fmax(HEIGHT_PART * d->height, self * (1 + STANDS_SHORT));
    double highest = fmin(HEIGHT_MULTIPLE * d->height, stands);
    lowest = height_of_kind(row, d->height, lowest);
    highest = height_of_kind(row, d->height, highest);
    return (struct range){fmin(lowest, d->height), fmax(highest, d->height)};
}

/* Returns the range of values that are tried. */
static struct range range_of(const struct trial *t)
{
    const struct dom_row *row = &t->row;
    const struct dom_domino *d = &t->domino[t->k];
    const double tilt = fmax(fabs(row->alpha), fabs(row->alpha + d->lean));
    if (t->of == DOM_WINDOW_GAP) /* a domino can reach across a gap that is as wide as its own height */
        return (struct range){0, d[-1].height};
    if (t->of == DOM_WINDOW_PLACE) {
        /* up to where it touches the next domino, or the previous one barely reaches it */
        const double reach = d[-1].height - d->gap, room = t->k + 1 == row->count ? reach : d[1].gap;
        return (struct range){t->place - d->gap, t->place + fmin(reach, room)};
    }
    if (t->of == DOM_WINDOW_HEIGHT)
        return heights_of(row, d, tilt);
    if (t->of == DOM_WINDOW_FRICTION)
        return (struct range){0, fmin(fmax(FRICTION_MOST, 4 * row->mu), DOM_MU_HIGHEST)};
    if (t->of == DOM_WINDOW_LEAN) {
        double lean[2];
        dom_lean_limits(d, row->alpha, row->rho, lean);
        const double inside = (lean[1] - lean[0]) / 2 * STANDS_SHORT;
        return (struct range){fmin(lean[0] + inside, d->lean), fmax(lean[1] - inside, d->lean)};
    }
    /* thick enough to stand, and to have room for two walls or for two rounded edges */
    const double rho = row->rho != 0 && d->radius > 0 ? d->radius / d->height : row->rho,
                 stands = (tan(tilt) + 2 * rho) * d->height,
                 least = fmax(fmax(HEIGHT_PART * d->thickness, stands), 2 * walls_of(row, d->height));
    return (struct range){fmin(least * (1 + STANDS_SHORT), d->thickness), HEIGHT_MULTIPLE * d->thickness};
}

/* Returns where the value that is changed is stored. */
static double *value_at(struct trial *t, struct dom_domino *d)
{
    double *const at[] = {[DOM_WINDOW_GAP] = &d->gap,       [DOM_WINDOW_PLACE] = &t->place,
                          [DOM_WINDOW_HEIGHT] = &d->height, [DOM_WINDOW_FRICTION] = &t->row.mu,
                          [DOM_WINDOW_LEAN] = &d->lean,     [DOM_WINDOW_THICKNESS] = &d->thickness};
    return at[t->of];
}

static double value_now(struct trial *t)
{
    return *value_at(t, &t->domino[t->k]);
}

/* Changes the value. If it is the height or the thickness of a domino, the density of the wood, the thickness
 * of the walls and the width stay the same, so the mass changes too. */
static void value_set(struct trial *t, struct dom_domino *d, double value)
{
    const struct dom_domino before = *d;
    double *const at = value_at(t, d), by = value - *at, times = value / *at;
    if (t->of != DOM_WINDOW_PLACE)
        *at = value;
    if (t->of == DOM_WINDOW_HEIGHT || t->of == DOM_WINDOW_THICKNESS) {
        d->width = width_of(&before);
        d->mass *= wood_factor(&t->row, &before, d, times);
    }
    if (t->of == DOM_WINDOW_PLACE) {
        d->gap = fmax(d->gap + by, 0);
        /* rounding must not put the gap out of reach of the previous domino */
        if (fabs(d->gap - d[-1].height) < 4 * DBL_EPSILON * value)
            d->gap = d[-1].height;
        if (t->k + 1 < t->row.count)
            d[1].gap = fmax(d[1].gap - by, 0);
    }
}

/* An edge_test. Sets the value, runs the row, and then restores the row. */
static bool falls_with(double value, double *spare, void *context)
{
    struct trial *t = context;
    const size_t next = t->k + 1 < t->row.count;
    struct dom_domino *d = &t->domino[t->k], self = *d, after = d[next];
    const double mu = t->row.mu;
    struct dom_verdict v = {.end = DOM_ROW_STOPS};
    value_set(t, d, value);
    if (t->of == DOM_WINDOW_FRICTION || t->row.engine) {
        (void)row_has_spare(&t->row, &t->compute, &v, &t->status);
        if (t->row.engine && t->status == DOM_NOT_CONVERGED) {
            /* if the engine cannot decide whether the row falls, the row counts as not falling */
            t->status = DOM_OK;
            v.end = DOM_ROW_STOPS;
        }
    } else if (t->status == DOM_OK) {
        const size_t last = t->k + (next && t->of == DOM_WINDOW_PLACE);
        t->status = row_study(t->study, &t->row, t->k, last, &v);
    }
    t->row.mu = mu;
    d[next] = after;
    *d = self;
    *spare = v.end == DOM_ROW_FALLS || v.end == DOM_ROW_STOPS ? v.spare : DOM_NAN;
    return t->status == DOM_OK && v.end == DOM_ROW_FALLS;
}

/* ---- A walk to an edge ---- */

/* Values are rounded to VALUE_DIGITS after the first digit, which makes them short enough to type, and STEPS
 * values are tried in each direction. An engine takes about a thousand times as long for each value, and its
 * results are accurate to only one percent. */
enum { VALUE_DIGITS = 6, VALUE_DIGITS_OF_ENGINE = 2, STEPS = 40, STEPS_OF_ENGINE = 10 };

static double value_digit(const struct trial *t, double value)
{
    return digit_of(fabs(value), t->row.engine ? VALUE_DIGITS_OF_ENGINE : VALUE_DIGITS);
}

/* Rounds a value to its digits, but not beyond `one` or `other`. */
static double value_rounded(const struct trial *t, double value, double one, double other)
{
    const double digit = value_digit(t, value), rounded = multiple_of(round(value / digit), digit);
    return value == 0 ? 0 : fmin(fmax(rounded, fmin(one, other)), fmax(one, other));
}

/*
 * Walks from a value towards `end` until the verdict changes. `falls` tells whether all dominoes fall at
 * `from`. The first step is a single digit, and the others are close together near `from`, and farther apart
 * towards `end`. Returns the value at the change, with which all dominoes fall. If there is no change,
 * returns `end` if all dominoes fall there, and NaN otherwise.
 */
static double edge_towards(struct trial *t, double from, double end, bool falls)
{
    const int steps = t->row.engine ? STEPS_OF_ENGINE : STEPS;
    const double range = end - from, digit = value_digit(t, from != 0 ? from : end);
    double last = from, spare;
    for (int i = 0; i <= steps && last != end && t->status == DOM_OK; i++) {
        const double part = fmax(digit / fabs(range), pow((double)i / steps, 3)),
                     near = part < 1 ? from + range * part : end,
                     x = t->row.engine && part < 1 ? value_rounded(t, near, from, end) : near;
        if (x != last && falls_with(x, &spare, t) != falls) {
            double bad = falls ? x : last;
            const double size = fmax(fabs(x), fabs(last));
            return edge_find(falls_with, t, falls ? last : x, &bad, value_digit(t, size), 0);
        }
        last = x;
    }
    return falls ? end : DOM_NAN;
}

/* ---- Windows ---- */

/* Returns true if domino k and its two neighbours equal domino k - 1 and its two neighbours. Then the window
 * of domino k nearly equals the window of domino k - 1. */
static bool is_repeated(const struct dom_row *row, size_t k)
{
    bool equal = k > 2 && k + 1 < row->count;
    for (size_t i = k - 1; equal && i <= k + 1; i++) {
        const struct dom_domino *a = &row->domino[i - 1], *b = a + 1;
        equal = a->height == b->height && a->thickness == b->thickness && a->gap == b->gap &&
                a->mass == b->mass && a->radius == b->radius && a->lean == b->lean && a->width == b->width;
    }
    return equal;
}

/* Returns an end of the window around the value `now`, at which all dominoes fall. The search begins near
 * `guess`. */
static double end_find(struct trial *t, double now, double guess, double end)
{
    double spare;
    const double from = guess == now ? now : value_rounded(t, guess, now, end);
    return from == now || falls_with(from, &spare, t) ? edge_towards(t, from, end, true)
                                                      : edge_towards(t, from, now, false);
}

/* For a row that falls, finds the window around the current value. `last` is the window of the previous
 * domino if this domino equals it, or NULL. */
static void window_around(struct trial *t, const struct dom_window *last, struct dom_window *w)
{
    const struct range range = range_of(t);
    const double by = last ? w->now - last->now : 0;
    /* Rounding to a few digits must not move an edge past the current value. */
    w->low = fmin(end_find(t, w->now, last ? last->low + by : w->now, range.lowest), w->now);
    w->high = fmax(end_find(t, w->now, last ? last->high + by : w->now, range.highest), w->now);
}

/* For a row that does not fall, finds the window nearest to the current value, if there is one. If the value
 * is above the range, for example a gap that is out of reach, the highest value of the range is tried
 * first. */
static void window_beside(struct trial *t, struct dom_window *w)
{
    const struct range range = range_of(t);
    double spare, near = range.highest, end = range.lowest;
    if (!(w->now > near && falls_with(near, &spare, t))) {
        const double above = edge_towards(t, w->now, range.highest, false),
                     below = edge_towards(t, w->now, range.lowest, false);
        const bool up = fabs(above - w->now) < fabs(w->now - below) || isnan(below);
        near = up ? above : below;
        end = up ? range.highest : range.lowest;
    }
    if (isnan(near))
        return;
    const double far = edge_towards(t, near, end, true);
    w->low = fmin(near, far);
    w->high = fmax(near, far);
}

/* If a row does not fall, only this many dominoes before the one that is not hit have windows. Dominoes that
 * are even closer to the start hardly matter. */
enum { BACK = 30 };

/* Returns true if a change of the value of domino k, counted from 0, may mend a row whose fall ends like
 * this. If a gap is too wide to reach across, no other gap does. */
static bool matters(enum dom_window_of of, size_t k, const struct dom_verdict *v)
{
    return of == DOM_WINDOW_FRICTION || k == v->domino ||
           (k < v->domino && k + BACK >= v->domino && !(of == DOM_WINDOW_GAP && v->end == DOM_ROW_MISSES));
}

enum dom_status dom_row_windows(const struct dom_row *row, const struct dom_compute *compute,
                                enum dom_window_of of, dom_progress *progress, void *context,
                                struct dom_window *windows)
{
    const bool one = of == DOM_WINDOW_FRICTION;
    struct dom_verdict planned = {.end = DOM_ROW_STOPS};
    struct trial t = {.row = *row, .compute = compute_or_default(compute), .of = (int)of, .status = DOM_OK};
    if (row->engine) /* an engine cannot start in the middle of a row */
        (void)row_has_spare(row, &t.compute, &planned, &t.status);
    else /* stores states from which runs of changed rows can start */
        t.status = row_study_begin(row, &t.compute, &t.study, &planned);
    if (t.status == DOM_OK && !(t.domino = malloc(row->count * sizeof *t.domino)))
        t.status = DOM_NO_MEMORY;
    if (t.status == DOM_OK)
        memcpy(t.domino, row->domino, row->count * sizeof *t.domino);
    t.row.domino = t.domino;
    const bool falls = planned.end == DOM_ROW_FALLS;
    const size_t first = of == DOM_WINDOW_GAP || of == DOM_WINDOW_PLACE, end = one ? 1 : row->count;
    for (t.k = first; t.k < end && t.status == DOM_OK; t.k++) {
        if (t.k > 0)
            t.place += t.domino[t.k - 1].thickness + t.domino[t.k].gap;
        struct dom_window w = {
            .domino = one ? 0 : t.k + 1, .now = value_now(&t), .low = DOM_NAN, .high = DOM_NAN};
        if (falls)
            window_around(&t, t.k > first && is_repeated(row, t.k) ? &windows[t.k - first - 1] : NULL, &w);
        else if (matters(of, t.k, &planned))
            window_beside(&t, &w);
        windows[t.k - first] = w;
        if (progress)
            progress(t.k - first + 1, end - first, context);
    }
    row_study_end(t.study);
    free(t.domino);
    return t.status;
}
