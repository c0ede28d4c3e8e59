/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Converts the tilts of a cycle to times and times to tilts, and tabulates the cycle. */
#include "motion/motion.h"

/* The time as a function of the tilt: one Chebyshev series for each smooth piece. */
struct clock {
    int pieces;
    struct tick {
        struct num_series series;
        real begins; /* time at which the head reaches the tilt lo */
        /* True if the train stops at the end of this piece. The series is then a function of the variable x
         * of slowness_before. In other pieces, the series is a function of the tilt. */
        bool before;
        real lo, hi; /* tilts of the head */
    } tick[CHAIN_EDGES];
    real whole;
};

/*
 * If the train stops close to the top of the barrier, dt/du has a peak at the stop (slowness_before). Returns
 * the width of this peak, in the variable u. Let delta be the distance of the tilt from the stop. The
 * remaining energy is then H' delta - H'' delta^2 / 2, where H'' < 0. The width corresponds to the delta at
 * which the two terms are equally large.
 */
static real stop_width(const struct motion *m)
{
    struct tilt rest;
    struct sums at;
    const struct geometry *geometry = &m->cycle.segment.geometry;
    if (!geometry->dynamics->conservative || geometry_tilt(geometry, m->end, &rest) != DOM_OK ||
        chain_change(geometry, standing, rest, PASS_SECOND_DERIVATIVE, &at) != DOM_OK || !(at.H2 < 0))
        return REAL_NAN;
    return sqrt(2 * fabs(at.H1 / at.H2) / m->end);
}

static enum dom_status tick_make(struct motion *m, struct tick *tick, real *time)
{
    struct segment *st = &m->cycle.segment;
    const struct barrier *b = &st->barrier;
    enum num_status solver;
    if (tick->before) {
        m->smooth = tick->lo;
        m->root = 0;
        m->span = sqrt((m->end - tick->lo) / m->end);
        solver = num_peak_series(slowness_before, m, 0, 1, 0, stop_width(m) / m->span, m->tol, &tick->series);
        *time = m->span * num_series_at(&tick->series, 1);
    } else {
        real width = barrier_width(&st->geometry, standing, b, st->start.kinetic - b->height);
        solver = num_peak_series(slowness, st, tick->lo, tick->hi, b->theta_m, width, m->tol, &tick->series);
        *time = num_series_at(&tick->series, tick->hi);
    }
    return model_status(st->status, solver);
}

/* Computes the series of all pieces. Returns DOM_NOT_CONVERGED if the series of some piece would need too
 * many terms. */
static enum dom_status clock_make(struct motion *m, struct clock *clock)
{
    const struct barrier *b = &m->cycle.segment.barrier;
    *clock = (struct clock){.pieces = 0};
    for (int i = 1; i < b->edges && b->edge[i - 1] < m->end; i++) {
        struct tick *tick = &clock->tick[clock->pieces++];
        real time;
        *tick = (struct tick){.begins = clock->whole,
                              .lo = b->edge[i - 1],
                              .hi = fmin(b->edge[i], m->end),
                              .before = m->stops && b->edge[i] >= m->end};
        enum dom_status status = tick_make(m, tick, &time);
        if (status != DOM_OK)
            return status;
        clock->whole += time;
    }
    return DOM_OK;
}

static real clock_time(const struct motion *m, const struct clock *clock, real theta)
{
    const struct tick *tick = &clock->tick[clock->pieces - 1];
    while (tick > clock->tick && theta < tick->lo)
        tick--;
    if (theta <= tick->lo)
        return tick->begins;
    if (!tick->before)
        return tick->begins + num_series_at(&tick->series, theta);
    real span = sqrt((m->end - tick->lo) / m->end), x = sqrt(fmax((m->end - theta) / m->end, 0)) / span;
    return tick->begins + span * (num_series_at(&tick->series, 1) - num_series_at(&tick->series, x));
}

static enum dom_status clock_tilt(const struct motion *m, const struct clock *clock, real time, real *theta)
{
    const struct tick *tick = &clock->tick[clock->pieces - 1];
    while (tick > clock->tick && time < tick->begins)
        tick--;
    real span = sqrt((m->end - tick->lo) / m->end), x = 0;
    real into = tick->before ? (clock->whole - time) / span : time - tick->begins;
    enum num_status solver = num_series_find(&tick->series, into, &x);
    *theta = tick->before ? fmax(m->end - m->end * (x * span) * (x * span), tick->lo) : x;
    return model_status(DOM_OK, solver);
}

/* Finds the tilt at a given time by Newton's method. Bisects if a step would leave the bracket. The
 * caller sets *at to a first guess. */
static enum dom_status tilt_search(struct motion *m, real time, real *at)
{
    real lo = 0, hi = m->end;
    for (int i = 0; i < 200; i++) {
        real omegasq = 0, passed = 0;
        enum dom_status status = segment_speed(&m->cycle.segment, *at, &omegasq);
        if (status == DOM_OK)
            status = motion_time(m, 0, *at, &passed);
        if (status != DOM_OK)
            return status;
        real off = time - passed, next = *at + off * sqrt(fmax(omegasq, 0));
        *(off >= 0 ? &lo : &hi) = *at;
        if (!(next > lo && next < hi))
            next = (lo + hi) / 2;
        bool there = fabs(next - *at) <= fmax(m->tol, 4 * REAL_EPSILON) * m->end;
        *at = next;
        if (there)
            return DOM_OK;
    }
    return DOM_NOT_CONVERGED;
}

static enum dom_status motion_tilt(struct motion *m, const struct clock *clock, real time, real *at)
{
    *at = 0;
    return clock->pieces > 0 ? clock_tilt(m, clock, time, at) : tilt_search(m, time, at);
}

/* Computes the clock and the duration of the cycle. If the clock cannot be computed, it has no pieces, and
 * the duration is found by an integral. */
static enum dom_status clock_begin(struct motion *m, struct clock *clock, real *whole)
{
    enum dom_status status = clock_make(m, clock);
    *whole = clock->whole;
    if (status == DOM_OK || status == DOM_INTERRUPTED || status == DOM_TOO_LONG)
        return status;
    clock->pieces = 0;
    return motion_time(m, 0, m->end, whole);
}

KERNEL enum dom_status cycle_tilt(const struct request *train, dom_real time_, dom_real *theta)
{
    struct motion m;
    struct clock clock;
    real time = (real)time_, whole = 0, at = 0;
    enum dom_status status = motion_begin(train, &m);
    if (status == DOM_OK)
        status = clock_begin(&m, &clock, &whole);
    if (status == DOM_OK &&
        !(time >= 0 && time <= whole * (1 + fmax(m.tol, 4 * fmax(REAL_EPSILON, DOM_REAL_EPSILON)))))
        status = DOM_BAD_TIME;
    if (status == DOM_OK && time > 0 && time < whole)
        status = motion_tilt(&m, &clock, time, &at);
    else if (status == DOM_OK && time > 0)
        at = m.end;
    motion_end(&m);
    if (status == DOM_OK)
        *theta = at;
    return status;
}

/* ---- The cycle as a table ---- */

struct table {
    struct motion m;
    struct clock clock;
    dom_state_visit *visit;
    void *context;
    bool ended; /* true after the visitor has ended the walk */
};

static enum dom_status table_row(struct table *t, real theta, const struct instant *event)
{
    struct dom_state state;
    real time = t->clock.pieces > 0 ? clock_time(&t->m, &t->clock, theta) : REAL_NAN;
    enum dom_status status = motion_state(&t->m, theta, time, &state);
    if (status != DOM_OK)
        return status;
    struct dom_event timed = {.theta = theta, .time = state.time};
    if (event) {
        timed.kind = event->kind;
        timed.domino = event->domino;
    }
    t->ended = !t->visit(&state, event ? &timed : NULL, t->context);
    return DOM_OK;
}

KERNEL enum dom_status cycle_walk(const struct request *train, size_t states, enum dom_spacing by,
                                  dom_state_visit *visit, void *context)
{
    struct table t = {.visit = visit, .context = context};
    struct instant events[DOM_EVENTS_MAX];
    int count = 0, next = 0;
    real whole = 0;
    enum dom_status status = motion_begin(train, &t.m);
    if (status == DOM_OK)
        status = motion_events(&t.m, events, &count);
    if (status == DOM_OK)
        status = clock_begin(&t.m, &t.clock, &whole);
    for (size_t k = 0; k < states && status == DOM_OK && !t.ended; k++) {
        real part = states > 1 ? (real)k / (real)(states - 1) : 1, theta = part * t.m.end;
        if (by == DOM_BY_TIME && part > 0 && part < 1)
            status = motion_tilt(&t.m, &t.clock, part * whole, &theta);
        for (; next < count && status == DOM_OK && !t.ended && events[next].theta <= theta; next++)
            status = table_row(&t, fmin(events[next].theta, t.m.end), &events[next]);
        bool between = next < count && theta > events[next > 0 ? next - 1 : 0].theta;
        if (between && status == DOM_OK && !t.ended)
            status = table_row(&t, theta, NULL);
    }
    motion_end(&t.m);
    return status == DOM_OK && t.m.stops ? DOM_STOPS : status;
}
