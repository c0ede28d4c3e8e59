/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The events of a cycle, its states, and the cycle as a table. */
#include "motion/motion.h"
#include <stdlib.h>

KERNEL enum dom_status motion_begin(const struct request *train, bool timed, struct motion *m)
{
    *m = (struct motion){.stops = false};
    enum dom_status status = cycle_begin(train, &m->cycle);
    m->cycle.segment.room = &m->room;
    if (status != DOM_OK)
        return status;
    m->stops = cycle_stops(&m->cycle);
    if (!(segment_noise(&m->cycle.segment) < (real)0.125))
        /* times grow like ln(1/margin), so they need an accurate margin */
        return DOM_NO_MARGIN;
    status = cycle_end(&m->cycle, &m->end);
    return status == DOM_OK && timed
               ? clock_begin(&m->clock, &m->cycle.segment, m->end, m->stops, (real)train->tol)
               : status;
}

KERNEL void motion_end(struct motion *m)
{
    cycle_free(&m->cycle);
    clock_free(&m->clock);
    free(m->room.list);
}

/* ---- Events ---- */

/* An event without its time. Unlike in struct dom_event, theta has the full precision of the kernel. */
struct instant {
    enum dom_event_kind kind;
    real theta;
    size_t domino;
};

/* Lists the events of the motion in the order in which they happen. There are at most DOM_EVENTS_MAX. */
static enum dom_status motion_events(const struct motion *m, struct instant *events, int *count)
{
    bool leaves;
    struct tilt leave;
    size_t domino = 0;
    enum dom_status status = chain_leave(&m->cycle.segment.geometry, &leaves, &leave, &domino);
    if (status != DOM_OK)
        return status;
    real top = m->cycle.segment.barrier.theta_m, fall = leaves ? tilt_angle(leave) : 0;
    int n = 0;
    events[n++] = (struct instant){.kind = DOM_EVENT_LAUNCH};
    if (top > 0 && top < m->end)
        events[n++] = (struct instant){.kind = DOM_EVENT_TOP, .theta = top};
    if (leaves && fall < m->end) {
        int at = n++;
        bool first = at > 1 && fall < top;
        if (first)
            events[at] = events[at - 1];
        events[first ? at - 1 : at] =
            (struct instant){.kind = DOM_EVENT_DETACH, .theta = fall, .domino = domino};
    }
    events[n++] = (struct instant){.kind = m->stops ? DOM_EVENT_STOP : DOM_EVENT_HIT, .theta = m->end};
    *count = n;
    return DOM_OK;
}

KERNEL enum dom_status cycle_events(const struct request *train, struct dom_event *events, int *count)
{
    struct motion m;
    struct instant at[DOM_EVENTS_MAX];
    int n = 0;
    enum dom_status status = motion_begin(train, true, &m);
    if (status == DOM_OK)
        status = motion_events(&m, at, &n);
    for (int i = 0; i < n && status == DOM_OK; i++)
        events[i] = (struct dom_event){.kind = at[i].kind,
                                       .theta = at[i].theta,
                                       .time = clock_time(&m.clock, at[i].theta),
                                       .domino = at[i].domino};
    motion_end(&m);
    *count = status == DOM_OK ? n : 0;
    return status == DOM_OK && m.stops ? DOM_STOPS : status;
}

/* ---- The state at a tilt ---- */

/* If theta is the tilt at which a follower detaches, the follower counts as detached, even if rounding has
 * made theta slightly smaller. In that case, corrects *left, the energy change of the detached follower. */
static enum dom_status fallen_energy(const struct geometry *geometry, real theta, real *left)
{
    const real near = 4096 * REAL_EPSILON;
    bool leaves;
    struct tilt leave;
    struct sums at;
    enum dom_status status = chain_leave(geometry, &leaves, &leave, NULL);
    real fall = leaves ? tilt_angle(leave) : 0;
    if (status != DOM_OK || !leaves || *left != 0 || fabs(theta - fall) > near * fall)
        return status;
    status = chain_energy_at(geometry, fmin(fall * (1 + near), tilt_angle(geometry->c)), &at);
    if (status == DOM_OK)
        *left = at.left;
    return status;
}

static enum dom_status motion_state(struct motion *m, real theta, struct dom_state *state)
{
    const struct launch *launch = &m->cycle.launch;
    const struct geometry *geometry = &m->cycle.segment.geometry;
    const bool conservative = geometry->dynamics->conservative;
    struct tilt head;
    struct sums at;
    real omegasq = 0, acceleration = 0;
    enum dom_status status = geometry_tilt(geometry, theta, &head);
    if (status == DOM_OK)
        status = cycle_speed(&m->cycle, m->end, theta, &omegasq);
    theta = fmin(theta, m->end);
    if (status == DOM_OK)
        status = chain_change(geometry, standing, head, PASS_PLAIN, &at);
    if (status == DOM_OK)
        status = fallen_energy(geometry, theta, &at.left);
    if (status == DOM_OK)
        status = geometry->dynamics->acceleration(geometry, head, omegasq, &acceleration, NULL);
    if (status != DOM_OK)
        return status;
    /* Just before the hit, the train that hits the head looks like this train at theta_c, scaled by 1 / r. So
     * the kinetic energy of the hitting train is r^-q times that of this train at theta_c. */
    real before = geometry->weight * launch->kinetic_at_hit;
    *state = (struct dom_state){
        .theta = theta,
        .time = clock_time(&m->clock, theta),
        .omegasq = omegasq,
        .acceleration = acceleration,
        .kinetic = at.J * omegasq,
        .climbed = at.dH,
        .fallen = at.left,
        .before = before,
        .lost = conservative ? before * geometry->upright_inertia / launch->J0 : before - launch->kinetic,
        .friction_work = conservative || theta == 0 ? 0 : launch->kinetic - at.dH - at.J * omegasq,
    };
    return DOM_OK;
}

KERNEL enum dom_status cycle_state(const struct request *train, dom_real theta, struct dom_state *state)
{
    struct motion m;
    enum dom_status status = motion_begin(train, true, &m);
    if (status == DOM_OK)
        status = motion_state(&m, (real)theta, state);
    motion_end(&m);
    return status;
}

KERNEL enum dom_status cycle_tilt(const struct request *train, dom_real time_, dom_real *theta)
{
    struct motion m;
    real time = (real)time_, whole = 0, at = 0;
    enum dom_status status = motion_begin(train, true, &m);
    if (status == DOM_OK)
        whole = clock_time(&m.clock, m.end);
    if (status == DOM_OK && !(time >= 0 && time <= whole * (1 + fmax(m.clock.tol, 4 * REAL_EPSILON))))
        status = DOM_BAD_TIME;
    if (status == DOM_OK)
        status = clock_tilt(&m.clock, time, &at);
    motion_end(&m);
    if (status == DOM_OK)
        *theta = at;
    return status;
}

/* ---- The cycle as a table ---- */

struct table {
    struct motion m;
    dom_state_visit *visit;
    void *context;
    bool ended; /* true after the visitor has ended the walk */
};

static enum dom_status table_row(struct table *t, real theta, const struct instant *event)
{
    struct dom_state state;
    enum dom_status status = motion_state(&t->m, theta, &state);
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
    enum dom_status status = motion_begin(train, true, &t.m);
    if (status == DOM_OK)
        status = motion_events(&t.m, events, &count);
    for (size_t k = 0; k < states && status == DOM_OK && !t.ended; k++) {
        real part = states > 1 ? (real)k / (real)(states - 1) : 1, theta = part * t.m.end;
        if (by == DOM_BY_TIME && part > 0 && part < 1)
            status = clock_tilt(&t.m.clock, part * clock_time(&t.m.clock, t.m.end), &theta);
        for (; next < count && status == DOM_OK && !t.ended && events[next].theta <= theta; next++)
            status = table_row(&t, fmin(events[next].theta, t.m.end), &events[next]);
        bool between = next < count && theta > events[next > 0 ? next - 1 : 0].theta;
        if (between && status == DOM_OK && !t.ended)
            status = table_row(&t, theta, NULL);
    }
    motion_end(&t.m);
    return status == DOM_OK && t.m.stops ? DOM_STOPS : status;
}
