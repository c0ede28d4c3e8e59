/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Finds windows. All dominoes of a row fall only if its gaps, sizes and so on are neither too small nor too
 * large. The window of a gap is the range of gaps at which all dominoes fall, if nothing else in the row
 * changes. The position, the height, the thickness and the lean of a domino have windows too, and so does the
 * friction. If a row does not fall, its windows say which change of one value mends it. */
#include "dynamics/dynamics.h"
#include "row/row.h"
#include "rows/model/boxes.h"
#include "search/search.h"
#include <float.h>
#include <stdlib.h>
#include <string.h>

/*
 * ---- Runs of a changed row ----
 *
 * A study runs a planned row many times, with changes. If a few neighbouring dominoes of a planned row are
 * changed, the run begins at the stored state of the first head that the change can affect. It ends as soon
 * as omegasq equals that of the planned row again, because from then on both rows move alike.
 *
 * The effects of a change decrease from head to head. The omegasq of a later head differs by the fraction
 * `off`, which a head multiplies by lambda. The changed dominoes still lean on the head, and change its
 * motion by an amount of the same order, which decays as these dominoes come down. So the run ends when `off`
 * is small at two heads in a row: small compared with `clear`, the change of omegasq that could change the
 * verdict on the planned row.
 *
 * If the planned row stops, the heads after the stop have no marks until a changed row falls to the end. That
 * run then makes their marks, and takes the place of the planned row for them.
 */

/* The planned row at the moment when a head is hit: its state, and how clear the verdict is from there on. */
struct mark {
    real omegasq, inertia_ratio; /* values of the members of struct run */
    size_t moving;
    /* the derivative of ln omegasq of the next head with respect to ln omegasq of this head */
    real lambda;
    /* A change of omegasq by less than this fraction can change neither the sign of the margin nor that of a
     * contact force, here and at later heads. */
    real clear;
};

struct study {
    struct row row;    /* between two runs, the geometry that is filled in is that of the planned row */
    struct mark *mark; /* of the planned row, whose first `known` heads have marks */
    size_t known;
    struct dom_verdict verdict;
    /* ---- The current run ---- */
    size_t last; /* index of the last domino that differs from the planned row */
    real off;    /* by which fraction omegasq of the last head differs from the planned one */
};

/* omegasq counts as equal if it differs by less than this fraction of `clear`. */
#define STUDY_EQUAL ((real)1 / 16)

/* With friction, `clear` is at most this, because it does not tell how close the row is to locking. */
#define STUDY_LOCKING ((real)1e-3)

/* Goes back from mark[to - 1] to mark[from], so that `clear` accounts for all later heads, too. */
static void marks_join(struct mark *mark, size_t from, size_t to)
{
    for (size_t k = to; k-- > from;)
        if (k + 1 < to)
            mark[k].clear = fmin(mark[k].clear, mark[k + 1].clear / fmax(mark[k].lambda, 1));
}

/* Called after each head. Returns true if a changed row moves as planned again. After a head without a mark,
 * makes its mark, with the part of `clear` that concerns this head alone. */
static bool study_ends(struct run *run, size_t k, const struct run *before, const struct descent *d,
                       const struct dom_fall *fall)
{
    struct study *s = run->options->context;
    struct mark *self = &s->mark[k];
    const real last = s->off;
    if (run->verdict.end == DOM_ROW_STOPS)
        run->verdict.spare = fall->margin / fall->barrier;
    if (k >= s->known) {
        *self = (struct mark){.omegasq = before->omegasq,
                              .inertia_ratio = before->inertia_ratio,
                              .moving = before->moving,
                              .clear = 1};
        if (k == 0 && before->omegasq == 0) /* the first domino starts at rest, and has no margin */
            return false;
        self->lambda = d->st.gain * before->omegasq / d->st.start.omegasq;
        self->clear = fmin(fabs((real)fall->margin / (real)fall->kinetic), fabs(d->least_force));
        if (!before->row->geometry[0].conservative)
            self->clear = d->locks ? 0 : fmin(self->clear, STUDY_LOCKING);
        return false;
    }
    if (run->verdict.end != DOM_ROW_FALLS || k + 1 >= s->known)
        return false;
    s->off = fabs(run->omegasq / self[1].omegasq - 1);
    const bool settles = k > s->last && fmax(last, s->off) <= STUDY_EQUAL * self[1].clear;
    if (settles && k + 1 < s->verdict.domino)
        run->verdict.end = s->verdict.end;
    return settles;
}

/* Runs the row from head k on. */
static enum dom_status study_falls(struct study *s, size_t k, struct dom_verdict *verdict)
{
    const struct run_options options = {.forces = s->known <
                                                  s->row.given.count, /* a mark needs the smallest force */
                                        .ends = study_ends,
                                        .context = s};
    struct run run = row_launch(&s->row, &options);
    s->off = (real)INFINITY;
    if (k > 0) {
        run.omegasq = s->mark[k].omegasq;
        run.inertia_ratio = s->mark[k].inertia_ratio;
        run.moving = s->mark[k].moving;
    }
    const enum dom_status status = row_falls(&run, k, NULL, NULL);
    *verdict = run.verdict;
    return status;
}

/* Runs the row as planned, and keeps states from which runs of changed rows can start. s->row and s->mark
 * must be freed even after an error. */
static enum dom_status study_begin(struct study *s, const struct dom_row *row,
                                   const struct dom_compute *compute)
{
    enum dom_status status = row_begin(row, compute, &s->row, &s->verdict.domino);
    if (status == DOM_OK && !(s->mark = malloc(row->count * sizeof *s->mark)))
        status = DOM_NO_MEMORY;
    if (status == DOM_OK)
        status = study_falls(s, 0, &s->verdict);
    if (status == DOM_OK) {
        s->known = s->verdict.domino;
        marks_join(s->mark, 0, s->known);
    }
    return status;
}

/* Runs a copy of the planned row in which the dominoes `first` to `last` have changed. */
static enum dom_status study_change(struct study *s, const struct dom_row *row, size_t first, size_t last,
                                    struct dom_verdict *verdict)
{
    const size_t from = first > 0 ? first - 1 : 0, count = row->count;
    enum dom_status status = DOM_OK;
    s->row.given = *row;
    *verdict = s->verdict;
    for (size_t k = first; k <= last && status == DOM_OK; k++)
        status = row_domino_check(&s->row.given, k);
    /* the fall ends before it reaches a head that the change can affect */
    if (status != DOM_OK || (s->verdict.end != DOM_ROW_FALLS && from >= s->verdict.domino))
        return status;
    s->last = last + 1;
    s->row.made = s->row.made < from ? s->row.made : from;
    if (from == 0) { /* the launch needs the first domino */
        status = row_geometry(&s->row, 0);
        s->row.made = 1;
    }
    if (status == DOM_OK)
        status = study_falls(s, from, verdict);
    s->row.made = s->row.made < from ? s->row.made : from;
    if (status == DOM_OK && verdict->end == DOM_ROW_FALLS && verdict->domino == count && s->known < count) {
        marks_join(s->mark, s->known, count);
        s->known = count;
    }
    return status;
}

/* ---- Trials ---- */

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
    struct study study; /* for running slightly changed rows, unless an engine runs them */
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
    if (t->of == DOM_WINDOW_HEIGHT) {
        /* A tilted domino stands if height < foot / tan(tilt), where foot = thickness - 2 radii. With rounded
         * edges it must be taller than 2 radii. A solid domino must stay solid, and a box must stay a box. */
        const double self = row->rho != 0 ? 2 * d->radius : 0, share = self > 0 ? 0 : 2 * row->rho,
                     stands = (d->thickness - self) / (tan(tilt) + share) * (1 - STANDS_SHORT),
                     lowest = fmax(HEIGHT_PART * d->height, self * (1 + STANDS_SHORT)),
                     highest = fmin(HEIGHT_MULTIPLE * d->height, stands);
        return (struct range){fmin(height_of_kind(row, d->height, lowest), d->height),
                              fmax(height_of_kind(row, d->height, highest), d->height)};
    }
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
    } else if (t->status == DOM_OK) {
        const size_t last = t->k + (next && t->of == DOM_WINDOW_PLACE);
        t->status = study_change(&t->study, &t->row, t->k, last, &v);
    }
    /* A row with a domino that cannot stand, or that the engine cannot decide, counts as not falling. */
    if (t->status == DOM_NO_STAND || (t->row.engine && t->status == DOM_NOT_CONVERGED)) {
        t->status = DOM_OK;
        v.end = DOM_ROW_STOPS;
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
 * `from`. The steps are close together near `from`, and farther apart towards `end`. If `from` is not the
 * current value, it is probably near an edge, so a walk in the model begins with steps of 1, 8, 64, 512 and
 * 4096 digits.
 * Returns the value at the change, with which all dominoes fall. If there is no change, returns `end` if all
 * dominoes fall there, and NaN otherwise.
 */
static double edge_towards(struct trial *t, double from, double end, bool falls)
{
    const int steps = t->row.engine ? STEPS_OF_ENGINE : STEPS;
    const double range = end - from, digit = value_digit(t, from != 0 ? from : end);
    double last = from, part = 0, spare;
    for (int i = t->row.engine || from == *value_at(t, &t->domino[t->k]) ? 1 : -4;
         i <= steps && last != end && t->status == DOM_OK; i++) {
        part = fmax(part, i > 0 ? pow((double)i / steps, 3) : digit / fabs(range) * pow(8, i + 4));
        const double near = part < 1 ? from + range * part : end,
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
    struct trial t = {.row = *row, .compute = compute_or_default(compute), .of = (int)of, .status = DOM_OK};
    struct dom_verdict *const planned = &t.study.verdict;
    if (row->engine) /* an engine cannot start in the middle of a row */
        (void)row_has_spare(row, &t.compute, planned, &t.status);
    else
        t.status = study_begin(&t.study, row, &t.compute);
    if (t.status == DOM_OK && !(t.domino = malloc(row->count * sizeof *t.domino)))
        t.status = DOM_NO_MEMORY;
    if (t.status == DOM_OK)
        memcpy(t.domino, row->domino, row->count * sizeof *t.domino);
    t.row.domino = t.domino;
    const bool falls = planned->end == DOM_ROW_FALLS;
    const size_t first = of == DOM_WINDOW_GAP || of == DOM_WINDOW_PLACE, end = one ? 1 : row->count;
    for (t.k = first; t.k < end && t.status == DOM_OK; t.k++) {
        if (t.k > 0)
            t.place += t.domino[t.k - 1].thickness + t.domino[t.k].gap;
        struct dom_window w = {.domino = one ? 0 : t.k + 1,
                               .now = *value_at(&t, &t.domino[t.k]),
                               .low = DOM_NAN,
                               .high = DOM_NAN};
        /* If a domino and its neighbours equal those before, the windows are nearly equal, too. */
        const bool repeats = t.k > 2 && t.k + 1 < row->count && row_repeats(row, t.k - 1) &&
                             row_repeats(row, t.k) && row_repeats(row, t.k + 1);
        if (falls)
            window_around(&t, repeats ? &windows[t.k - first - 1] : NULL, &w);
        else if (matters(of, t.k, planned))
            window_beside(&t, &w);
        windows[t.k - first] = w;
        if (progress)
            progress(t.k - first + 1, end - first, context);
    }
    row_free(&t.study.row);
    free(t.study.mark);
    free(t.domino);
    return t.status;
}
