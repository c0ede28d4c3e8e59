/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Finds windows. All dominoes of a row fall only if its gaps, sizes and so on are neither too small nor too
 * large. The window of a gap is the range of gaps at which all dominoes fall, if nothing else in the row
 * changes. The position, the height, the thickness and the lean of a domino have windows too, and so does the
 * friction. */
#include "planning/boxes.h"
#include "planning/trial.h"

/* Heights are tried from HEIGHT_PART to HEIGHT_MULTIPLE times the current height, and likewise thicknesses.
 * Friction is tried up to FRICTION_MOST or four times the current friction, whichever is larger, but not
 * beyond DOM_MU_HIGHEST. */
#define HEIGHT_PART     ((dom_real)0.01)
#define HEIGHT_MULTIPLE 4
#define FRICTION_MOST   2

/* Heights, thicknesses and leans have limits, beyond which the domino falls over by itself, or has no room
 * for its walls or its rounded edges. The values that are tried stay this fraction away from the limits. The
 * fraction exceeds the rounding error of a float. */
#define STANDS_SHORT ((dom_real)1e-6)

/* The range of values that are tried. */
struct range {
    dom_real lowest, highest;
    /* how the fall ends at a value above `highest`, or DOM_ROW_FALLS if this is unknown */
    enum dom_row_end above;
};

/*
 * Returns the range of heights that are tried.
 * - If a tilted domino is too tall, it falls over by itself. It stands if height < foot / tan |tilt|, where
 *   foot = thickness - 2 radii.
 * - A domino with rounded edges must be taller than 2 radii.
 * - A solid domino must stay solid, and a box must stay a box.
 */
static struct range heights_of(const struct trial *t, const struct dom_domino *d)
{
    dom_real tilt = fmax(fabs(t->row.alpha), fabs(t->row.alpha + d->lean));
    dom_real self = t->row.rho != 0 ? 2 * d->radius : 0, share = self > 0 ? 0 : 2 * t->row.rho;
    dom_real stands = (d->thickness - self) / (tan(tilt) + share) * (1 - STANDS_SHORT);
    dom_real lowest = fmax(HEIGHT_PART * d->height, self * (1 + STANDS_SHORT));
    dom_real highest = fmin(HEIGHT_MULTIPLE * d->height, stands);
    lowest = height_of_kind(&t->row, d->height, lowest);
    highest = height_of_kind(&t->row, d->height, highest);
    return (struct range){fmin(lowest, d->height), fmax(highest, d->height), DOM_ROW_FALLS};
}

/*
 * Returns the range of thicknesses that are tried. The domino must be thick enough to stand, and to have room
 * for two walls or for two rounded edges.
 */
static struct range thicknesses_of(const struct trial *t, const struct dom_domino *d)
{
    const dom_real tilt = fmax(fabs(t->row.alpha), fabs(t->row.alpha + d->lean)),
                   rho = t->row.rho != 0 && d->radius > 0 ? d->radius / d->height : t->row.rho,
                   stands = (tan(tilt) + 2 * rho) * d->height,
                   least = fmax(fmax(HEIGHT_PART * d->thickness, stands), 2 * walls_of(&t->row, d->height));
    return (struct range){fmin(least * (1 + STANDS_SHORT), d->thickness), HEIGHT_MULTIPLE * d->thickness,
                          DOM_ROW_FALLS};
}

static struct range range_of(const struct trial *t)
{
    const struct dom_domino *d = &t->domino[t->k];
    switch (t->of) {
    case DOM_WINDOW_PLACE: {
        /* The domino can move forwards until it touches the next domino, or until the previous domino barely
         * reaches it. */
        bool last = t->k + 1 == t->row.count;
        dom_real reach = d[-1].height - d->gap, room = last ? reach : d[1].gap;
        return (struct range){t->place - d->gap, t->place + fmin(reach, room),
                              reach <= room ? DOM_ROW_MISSES : DOM_ROW_FALLS};
    }
    case DOM_WINDOW_HEIGHT:
        return heights_of(t, d);
    case DOM_WINDOW_THICKNESS:
        return thicknesses_of(t, d);
    case DOM_WINDOW_FRICTION:
        return (struct range){0, fmin(fmax(FRICTION_MOST, 4 * t->row.mu), DOM_MU_HIGHEST), DOM_ROW_FALLS};
    case DOM_WINDOW_LEAN: {
        dom_real lean[2], inside;
        dom_lean_limits(d, t->row.alpha, t->row.rho, lean);
        inside = (lean[1] - lean[0]) / 2 * STANDS_SHORT;
        return (struct range){fmin(lean[0] + inside, d->lean), fmax(lean[1] - inside, d->lean),
                              DOM_ROW_FALLS};
    }
    case DOM_WINDOW_GAP:
        break;
    }
    return (struct range){0, d[-1].height, DOM_ROW_MISSES};
}

/*
 * Changes the value step by step towards `end`. Returns the last value at which all dominoes still fall. If
 * some do not fall at a value farther on, sets *beyond to the way the fall ends there. If all dominoes fall
 * again even farther on, sets *others to true.
 */
static dom_real window_edge(struct trial *t, dom_real end, enum dom_row_end *beyond, bool *others)
{
    dom_real now = trial_now(t), edge = end, good = now;
    bool open = true;
    for (int i = 1; i <= trial_steps(t) && end != now && !*others && t->status == DOM_OK; i++) {
        dom_real x = value_step(t, now, end, i);
        bool falls = x == good || falls_with(x, t);
        if (open && !falls) {
            edge = value_edge(t, good, x);
            /* t->ends comes from the closest trial at which the row did not fall. */
            *beyond = t->ends;
            open = false;
        }
        *others = falls && !open;
        good = falls ? x : good;
    }
    /* Rounding to a few digits must not move the edge past the current value. */
    return end < now ? fmin(edge, now) : fmax(edge, now);
}

/* Finds the window around the current value. All dominoes must fall at the current value. */
static void window_around(struct trial *t, struct dom_window *w)
{
    const struct range range = range_of(t);
    bool below = false, above = false;
    w->above = range.above;
    w->low = window_edge(t, range.lowest, &w->below, &below);
    w->high = window_edge(t, range.highest, &w->above, &above);
    w->others = below || above;
}

/* ---- Equal dominoes ---- */

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

/*
 * Like window_edge, but for an edge that is expected close to the value `guess`. The first trial is at
 * `guess`. From there, the search steps towards the edge. Its first step is one unit in the last digit, and
 * each later step is eight times as long as the step before. The steps end when the edge lies between two
 * trials.
 */
static dom_real edge_near(struct trial *t, dom_real guess, dom_real end, enum dom_row_end *beyond)
{
    const dom_real now = trial_now(t), digit = value_digit(t, guess != 0 ? guess : end != 0 ? end : now);
    const dom_real first = fmin(fmax(round(guess / digit) * digit, fmin(now, end)), fmax(now, end));
    dom_real good = first, bad = first, step = end < now ? -digit : digit;
    if (falls_with(first, t))
        for (; good == bad && good != end; step *= 8) {
            bad = fabs(end - good) < fabs(step) ? end : good + step;
            good = falls_with(bad, t) ? bad : good;
        }
    else
        for (; good == bad && good != now; step *= 8) {
            good = fabs(good - now) < fabs(step) ? now : bad - step;
            bad = falls_with(good, t) ? bad : good;
        }
    if (good == bad) /* all dominoes fall even at the end of the range */
        return good;
    *beyond = t->ends;
    if (fabs(good - bad) > digit + digit / 2)
        good = value_edge(t, good, bad);
    return end < now ? fmin(good, now) : fmax(good, now);
}

/* Finds the window of a domino that equals the previous domino. To save time, the search starts close to the
 * edges of the previous domino's window, *last. */
static void window_repeat(struct trial *t, const struct dom_window *last, struct dom_window *w)
{
    const struct range range = range_of(t);
    const dom_real by = w->now - last->now;
    w->above = range.above;
    w->low = edge_near(t, last->low + by, range.lowest, &w->below);
    w->high = edge_near(t, last->high + by, range.highest, &w->above);
    w->others = last->others;
}

/* ---- Rows that do not fall ---- */

/* Finds the window for a current value that is above the range, for example a gap that is out of reach. All
 * dominoes must fall at the highest value of the range. The window ends at this value. The function searches
 * for its lower end. */
static void window_below(struct trial *t, const struct range *range, struct dom_window *w)
{
    const size_t next = t->k + 1 < t->row.count;
    const struct dom_domino self = t->domino[t->k], after = t->domino[t->k + next];
    const dom_real place = t->place;
    enum dom_row_end below;
    trial_change(t, range->highest);
    t->place = t->of == DOM_WINDOW_PLACE ? range->highest : place;
    w->low = window_edge(t, range->lowest, &below, &w->others);
    w->high = range->highest;
    t->place = place;
    t->domino[t->k + next] = after;
    t->domino[t->k] = self;
}

/* For a row that does not fall, finds the window nearest to the current value, if there is one. */
static void window_beside(struct trial *t, struct dom_window *w)
{
    const struct range range = range_of(t);
    dom_real now = trial_now(t), to[2], until[2];
    if (now > range.highest && falls_with(range.highest, t)) {
        window_below(t, &range, w);
        return;
    }
    bool in = value_towards(t, range.lowest, &to[0], &until[0]);
    bool out = value_towards(t, range.highest, &to[1], &until[1]);
    if (!in && !out)
        return;
    int which = !in || (out && to[1] - now < now - to[0]);
    w->low = fmin(to[which], until[which]);
    w->high = fmax(to[which], until[which]);
    w->others = in && out;
}

/* Returns true if a change of domino k can affect a fall that ends at domino `ends`. Both count from 0. */
static bool matters(enum dom_window_of of, size_t k, size_t ends)
{
    return of == DOM_WINDOW_FRICTION || k <= ends + 1;
}

enum dom_status dom_row_windows(const struct dom_row *row, const struct dom_compute *compute,
                                enum dom_window_of of, dom_progress *progress, void *context,
                                struct dom_window *windows)
{
    struct trial t = trial_of(row, compute);
    t.of = of;
    bool falls = trial_begin(&t), one = of == DOM_WINDOW_FRICTION;
    const size_t first = of == DOM_WINDOW_GAP || of == DOM_WINDOW_PLACE, end = one ? 1 : row->count;
    const size_t ends = t.verdict.domino - 1;
    for (t.k = first; t.k < end && t.status == DOM_OK; t.k++) {
        if (t.k > 0)
            t.place += t.domino[t.k - 1].thickness + t.domino[t.k].gap;
        struct dom_window w = {.domino = one ? 0 : t.k + 1,
                               .now = trial_now(&t),
                               .low = DOM_NAN,
                               .high = DOM_NAN,
                               .below = DOM_ROW_FALLS,
                               .above = DOM_ROW_FALLS};
        if (falls && t.k > first && is_repeated(row, t.k))
            window_repeat(&t, &windows[t.k - first - 1], &w);
        else if (falls)
            window_around(&t, &w);
        else if (matters(of, t.k, ends))
            window_beside(&t, &w);
        windows[t.k - first] = w;
        if (progress)
            progress(t.k - first + 1, end - first, context);
    }
    trial_end(&t);
    return t.status;
}
