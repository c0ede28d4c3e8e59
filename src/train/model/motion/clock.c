/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Converts the tilts of a cycle to times and times to tilts, and tabulates the cycle. */
#include "motion/motion.h"

/* The latest known state of the head. */
struct clock {
    real time, theta; /* time since the launch in tau, and tilt */
};

/* Moves the clock to another tilt. */
static enum dom_status clock_to(struct motion *m, struct clock *clock, real theta)
{
    const bool ahead = theta >= clock->theta;
    real step = 0;
    enum dom_status status =
        motion_time(m, ahead ? clock->theta : theta, ahead ? theta : clock->theta, &step);
    clock->time += ahead ? step : -step;
    clock->theta = theta;
    return status;
}

/* Moves the clock to a given time, by Newton's method from its latest state. Bisects if a step would leave
 * the bracket. */
static enum dom_status clock_find(struct motion *m, struct clock *clock, real time)
{
    real lo = 0, hi = m->end;
    for (int i = 0; i < 200; i++) {
        real omegasq = 0;
        enum dom_status status = segment_speed(&m->cycle.segment, clock->theta, &omegasq);
        if (status != DOM_OK)
            return status;
        const real off = time - clock->time, theta = clock->theta;
        real next = theta + off * sqrt(fmax(omegasq, 0));
        *(off >= 0 ? &lo : &hi) = theta;
        if (!(next > lo && next < hi))
            next = (lo + hi) / 2;
        if (fabs(next - theta) <= fmax(m->tol, 4 * REAL_EPSILON) * m->end) {
            *clock = (struct clock){time, next};
            return DOM_OK;
        }
        status = clock_to(m, clock, next);
        if (status != DOM_OK)
            return status;
    }
    return DOM_NOT_CONVERGED;
}

KERNEL enum dom_status cycle_tilt(const struct request *train, dom_real time_, dom_real *theta)
{
    struct motion m;
    struct clock clock = {0, 0};
    real time = (real)time_, whole = 0;
    enum dom_status status = motion_begin(train, &m);
    if (status == DOM_OK)
        status = motion_time(&m, 0, m.end, &whole);
    if (status == DOM_OK && !(time >= 0 && time <= whole * (1 + fmax(m.tol, 4 * REAL_EPSILON))))
        status = DOM_BAD_TIME;
    if (status == DOM_OK && time > 0 && time < whole)
        status = clock_find(&m, &clock, time);
    else if (status == DOM_OK && time > 0)
        clock.theta = m.end;
    motion_end(&m);
    if (status == DOM_OK)
        *theta = clock.theta;
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
    enum dom_status status = clock_to(&t->m, &t->clock, fmin(theta, t->m.end));
    if (status == DOM_OK)
        status = motion_state(&t->m, theta, t->clock.time, &state);
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
        status = motion_time(&t.m, 0, t.m.end, &whole);
    for (size_t k = 0; k < states && status == DOM_OK && !t.ended; k++) {
        real part = states > 1 ? (real)k / (real)(states - 1) : 1, theta = part * t.m.end;
        if (by == DOM_BY_TIME && part > 0 && part < 1) {
            struct clock seek = t.clock; /* an event may come before */
            status = clock_find(&t.m, &seek, part * whole);
            theta = seek.theta;
        }
        for (; next < count && status == DOM_OK && !t.ended && events[next].theta <= theta; next++)
            status = table_row(&t, fmin(events[next].theta, t.m.end), &events[next]);
        bool between = next < count && theta > events[next > 0 ? next - 1 : 0].theta;
        if (between && status == DOM_OK && !t.ended)
            status = table_row(&t, theta, NULL);
    }
    motion_end(&t.m);
    return status == DOM_OK && t.m.stops ? DOM_STOPS : status;
}
