/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "motion/motion.h"
#include <stdlib.h>

/* ---- Times ---- */

KERNEL enum dom_status motion_begin(const struct request *train, struct motion *m)
{
    m->room = (struct room){0};
    enum dom_status status = cycle_begin(train, &m->cycle);
    m->cycle.segment.room = &m->room;
    if (status != DOM_OK)
        return status;
    real margin = m->cycle.launch.kinetic - m->cycle.segment.barrier.height;
    m->stops = cycle_stops(&m->cycle);
    m->tol = fmax((real)train->tol / 8, 16 * REAL_EPSILON * m->cycle.launch.kinetic / fabs(margin));
    if (!(m->tol < (real)0.125))
        /* times grow like ln(1/margin), so they need an accurate margin */
        return DOM_NO_MARGIN;
    return cycle_end(&m->cycle, &m->end);
}

KERNEL void motion_end(struct motion *m)
{
    cycle_free(&m->cycle);
    free(m->room.list);
}

/* Returns the integrand of the time before a stop. Near the stop, the slowness grows like 1/sqrt(end -
 * theta), so it is not integrated over theta. The substitution theta = end (1 - u^2) gives the smooth
 * integrand dt/du = 2 end u / (tau omega). The argument x runs from 0 to 1, and u = `root` + `span` x. */
KERNEL real slowness_before(real x, void *context)
{
    struct motion *m = context;
    struct segment *st = &m->cycle.segment;
    /* Very near the stop, the remaining energy would underflow, and dt/du hardly changes any more. So dt/du
     * is computed at u = sqrt(REAL_EPSILON) instead of at a smaller u. */
    real u = fmax(m->root + m->span * x, sqrt(REAL_EPSILON));
    real delta = fmin(m->end * u * u, m->end - m->smooth), slowness_squared = REAL_NAN;
    st->status = st->geometry.dynamics->near_rest(&st->geometry, m->end, delta, &slowness_squared);
    return st->status == DOM_OK ? 2 * m->end * u * sqrt(slowness_squared) : REAL_NAN;
}

/* Adds the time of the motion from the tilt m->smooth to the tilt `to`, which is at or before the stop. */
static enum dom_status motion_time_before(struct motion *m, real to, real *time)
{
    real part = 0, far = sqrt((m->end - m->smooth) / m->end);
    m->root = sqrt(fmax((m->end - to) / m->end, 0));
    m->span = (to - m->smooth) / m->end / (far + m->root);
    enum num_status solver = num_integral(slowness_before, m, 0, 1, m->tol, &part, NULL);
    *time += m->span * part;
    return model_status(m->cycle.segment.status, solver);
}

KERNEL enum dom_status motion_time(struct motion *m, real from, real to, real *time)
{
    const struct barrier *b = &m->cycle.segment.barrier;
    m->smooth = to;
    *time = 0;
    if (to <= from)
        return DOM_OK;
    if (m->stops) { /* only the last piece before the stop needs slowness_before */
        m->smooth = from;
        for (int i = 0; i < b->edges; i++)
            m->smooth = b->edge[i] < m->end ? fmax(m->smooth, fmin(b->edge[i], to)) : m->smooth;
    }
    enum dom_status status = segment_integral(&m->cycle.segment, slowness, from, m->smooth, m->tol, time);
    return status == DOM_OK && m->smooth < to ? motion_time_before(m, to, time) : status;
}

KERNEL enum dom_status motion_events(const struct motion *m, struct instant *events, int *count)
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
    real time = 0;
    int n = 0;
    enum dom_status status = motion_begin(train, &m);
    if (status == DOM_OK)
        status = motion_events(&m, at, &n);
    for (int i = 0; i < n && status == DOM_OK; i++) {
        real step = 0;
        if (i > 0)
            status = motion_time(&m, at[i - 1].theta, at[i].theta, &step);
        time += step;
        events[i] = (struct dom_event){
            .kind = at[i].kind, .theta = at[i].theta, .time = time, .domino = at[i].domino};
    }
    motion_end(&m);
    *count = status == DOM_OK ? n : 0;
    return status == DOM_OK && m.stops ? DOM_STOPS : status;
}

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

KERNEL enum dom_status motion_state(struct motion *m, real theta, real time, struct dom_state *state)
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
    if (status == DOM_OK && isnan(time))
        status = motion_time(m, 0, theta, &time);
    if (status == DOM_OK)
        status = geometry->dynamics->acceleration(geometry, head, omegasq, &acceleration, NULL);
    if (status != DOM_OK)
        return status;
    /* Just before the hit, the train that hits the head looks like this train at theta_c, scaled by 1 / r. So
     * the kinetic energy of the hitting train is r^-q times that of this train at theta_c. */
    real before = geometry->weight * launch->kinetic_at_hit;
    *state = (struct dom_state){
        .theta = theta,
        .time = time,
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
    enum dom_status status = motion_begin(train, &m);
    if (status == DOM_OK)
        status = motion_state(&m, (real)theta, REAL_NAN, state);
    motion_end(&m);
    return status;
}
