/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One cycle as it runs: events, times, accelerations. */
#include "motion/motion.h"
#include <stdlib.h>

/* ---- Times ---- */

KERNEL enum dom_status motion_begin(const struct request *train, struct flow *flow, struct motion *m,
                                    bool errors)
{
    m->room = (struct room){0};
    enum dom_status status = cycle_whole(train, flow, &m->cycle, errors);
    if (status != DOM_OK)
        return status;
    real margin = m->cycle.launch.kinetic - m->cycle.barrier.height;
    m->stops = cycle_stops(&m->cycle);
    m->tol = fmax((real)train->tol / 8, 16 * REAL_EPSILON * m->cycle.launch.kinetic / fabs(margin));
    if (!(m->tol < (real)0.125))
        return DOM_NO_MARGIN; /* as a duration, a time would grow like ln(1/margin) */
    return cycle_end(&m->cycle, &m->end);
}

KERNEL void motion_end(struct motion *m)
{
    free(m->room.list);
}

/*
 * The slowness before a stop grows like 1/sqrt(end - theta).  In u, theta = end (1 - u^2), it is smooth:
 * dt/du = 2 end u / (tau omega).  What is left of the energy is H(end) - H(theta), from end - theta itself,
 * and u runs from root over span as x does from 0 to 1: so nothing cancels, neither at the stop nor at the
 * launch.
 */
KERNEL real slowness_before(real x, void *context)
{
    struct motion *m = context;
    struct cycle *c = &m->cycle;
    struct tilt head = standing, rest = standing;
    struct sums at = {.J = 1};
    /* At the stop it is flat, to rounding, where the energy that is left would underflow. */
    real u = fmax(m->root + m->span * x, sqrt(REAL_EPSILON));
    real delta = fmin(m->end * u * u, m->end - m->smooth), theta = m->end - delta, left = 0;
    c->status = geometry_tilt(&c->geometry, theta, &head);
    if (c->status == DOM_OK && c->geometry.mu > 0)
        left = friction_left(&c->geometry, m->end, delta); /* w, as J w with J = 1 */
    else if (c->status == DOM_OK)
        c->status = geometry_tilt(&c->geometry, m->end, &rest);
    if (c->status == DOM_OK && c->geometry.mu == 0) {
        c->status = chain_energy_change_by(&c->geometry, rest, head, -delta, &at);
        left = -at.dH;
    }
    return c->status == DOM_OK && left > 0 ? 2 * m->end * u * sqrt(at.J / left) : REAL_NAN;
}

/* The time from m->smooth to a tilt before the stop. */
static enum dom_status motion_time_before(struct motion *m, real to, real *time)
{
    real part = 0, far = sqrt((m->end - m->smooth) / m->end);
    m->root = sqrt(fmax((m->end - to) / m->end, 0));
    m->span = (to - m->smooth) / m->end / (far + m->root);
    enum num_status solver = num_integral(slowness_before, m, 0, 1, m->tol, &part, NULL);
    *time += m->span * part;
    return model_status(m->cycle.status, solver);
}

/* Time from one tilt to another. */
KERNEL enum dom_status motion_time(struct motion *m, real from, real to, real *time)
{
    const struct barrier *b = &m->cycle.barrier;
    m->smooth = to;
    *time = 0;
    if (to <= from)
        return DOM_OK;
    if (m->stops) { /* the last piece before the stop has an end like no other */
        m->smooth = from;
        for (int i = 0; i < b->edges; i++)
            m->smooth = b->edge[i] < m->end ? fmax(m->smooth, fmin(b->edge[i], to)) : m->smooth;
    }
    enum dom_status status = cycle_integral(&m->cycle, slowness, from, m->smooth, m->tol, time, NULL);
    return status == DOM_OK && m->smooth < to ? motion_time_before(m, to, time) : status;
}

/* The events without their times. */
KERNEL enum dom_status motion_events(const struct motion *m, struct dom_event *events, int *count)
{
    bool leaves;
    struct tilt leave;
    size_t domino = 0;
    enum dom_status status = chain_leave(&m->cycle.geometry, &leaves, &leave, &domino);
    if (status != DOM_OK)
        return status;
    real top = m->cycle.barrier.theta_m, fall = leaves ? tilt_angle(leave) : 0;
    int n = 0;
    events[n++] = (struct dom_event){.kind = DOM_EVENT_LAUNCH};
    if (top > 0 && top < m->end)
        events[n++] = (struct dom_event){.kind = DOM_EVENT_TOP, .theta = top};
    if (leaves && fall < m->end) {
        int at = n++;
        bool first = at > 1 && fall < top;
        if (first)
            events[at] = events[at - 1];
        events[first ? at - 1 : at] =
            (struct dom_event){.kind = DOM_EVENT_FALL, .theta = fall, .domino = domino};
    }
    events[n++] = (struct dom_event){.kind = m->stops ? DOM_EVENT_STOP : DOM_EVENT_HIT, .theta = m->end};
    *count = n;
    return DOM_OK;
}

KERNEL enum dom_status cycle_events(const struct request *train, struct dom_event *events, int *count)
{
    struct motion m;
    FLOW(flow);
    int n = 0;
    enum dom_status status = motion_begin(train, &flow, &m, false);
    if (status == DOM_OK)
        status = motion_events(&m, events, &n);
    for (int i = 1; i < n && status == DOM_OK; i++) {
        real step = 0;
        status = motion_time(&m, (real)events[i - 1].theta, (real)events[i].theta, &step);
        events[i].time = events[i - 1].time + step;
    }
    *count = status == DOM_OK ? n : 0;
    return status == DOM_OK && m.stops ? DOM_STOPS : status;
}

/* ---- Accelerations ---- */

/* The rest of J, H1 and J'/2 from this domino on, where it is near enough to theta_inf (far_near). */
static bool acceleration_closes(const struct link *k, real second_derivative, struct sum_state *a,
                                real *half_J1)
{
    const struct geometry *geometry = k->geometry;
    const struct far *far = &geometry->far;
    if (geometry->n != CHAIN_ENDLESS || geometry->detaches || geometry->behind)
        return false;
    real e = far_off(geometry, k->tilt), H1 = k->weight * k->slope, J = k->inertia * k->slope * k->slope;
    if (e > geometry->inf.x / 16 || !far_done(&a->H1, H1 * far->H1, H1 * far->H3 * e * e, geometry->tol) ||
        !far_done(&a->J, J * far->J0, J * far->J2 * e * e, geometry->tol))
        return false;
    real J_far = far->J0 - far->J1 * e + far->J2 * e * e / 2, J1_far = far->J1 - far->J2 * e;
    series_add(&a->H1, H1 * (far->H1 - far->H2 * e + far->H3 * e * e / 2));
    series_add(&a->J, J * J_far);
    *half_J1 += k->inertia * k->slope * (second_derivative * J_far + k->slope * k->slope * J1_far / 2);
    return true;
}

/* tau^2 times the head's acceleration: half of dw/dtheta, J dw/dtheta = -H' - J' w.  *n, unless NULL: the
 * dominoes that matter. */
KERNEL enum dom_status motion_acceleration(const struct geometry *geometry, struct tilt head, real w,
                                           real *acceleration, size_t *n)
{
    struct sum_state a = {0};
    struct sums at;
    struct equation_of_motion equation_of_motion;
    struct link k = link_head(geometry, head);
    real half_J1 = 0, second_derivative = 0;
    for (;;) {
        enum dom_status status = chain_watch(geometry, k.i);
        if (status != DOM_OK)
            return status;
        if (!n && acceleration_closes(&k, second_derivative, &a, &half_J1))
            break;
        add_J(&a, &k);
        add_H1(&a, &k);
        half_J1 += k.inertia * k.slope * second_derivative;
        if (k.i + 1 >= geometry->n || !k.leads || (done_J(&a, &k) && done_H1(&a, &k, geometry->tol)))
            break;
        struct link leader = k;
        link_next(&k);
        second_derivative = link_second_derivative(&leader, second_derivative, &k);
    }
    enum dom_status status = sum_result(geometry, &a, 0, k.i + 1, &at);
    if (n)
        *n = at.n;
    *acceleration = -(at.H1 / 2 + half_J1 * w) / at.J;
    if (status == DOM_OK && geometry->mu > 0) {
        status = friction_equation_of_motion(geometry, head, &equation_of_motion);
        *acceleration = (equation_of_motion.C - equation_of_motion.B * w) / equation_of_motion.A;
    }
    return status;
}

/*
 * Of the time up to theta: the integral of the slowness's bound, and what the tolerance leaves.  Towards a
 * stop, where the slowness has no bound, the rounding of the energy counts through m->tol, and through the
 * tilt of the stop.  Off by of_end, this shifts times by of_end / omega, and by no more than the time from
 * there on; early on, by half the share of the energy that it leaves open.
 */
static enum dom_status time_error(struct motion *m, const struct dom_state *state, real *error)
{
    real of_speed = 0, theta = (real)state->theta, time = (real)state->time;
    enum num_status solver = NUM_OK;
    if (m->stops) {
        dom_real of_end;
        real energy, w = (real)state->omegasq;
        enum dom_status status = stop_error(&m->cycle, m->end, &of_end, &energy);
        if (status != DOM_OK)
            return status;
        of_speed = (real)of_end / sqrt(w + fabs((real)state->acceleration) * (real)of_end);
        if (w > 0)
            of_speed = fmin(of_speed, time * energy / (2 * (real)state->kinetic));
    }
    if (!m->stops && theta > 0)
        solver = num_integral(slowness_error, &m->cycle, 0, theta, (real)0.125, &of_speed, NULL);
    *error = 2 * of_speed + (real)(m->stops ? 64 : 1) * fmax(m->tol, 8 * UNIT) * time;
    return model_status(m->cycle.status, solver);
}

/* At the tilt where a follower leaves, which rounding may set before or behind it, it has left. */
static enum dom_status fallen_energy(const struct geometry *geometry, real theta, real *left)
{
    const real near = 4096 * REAL_EPSILON;
    bool leaves;
    struct tilt leave, head;
    struct sums at;
    enum dom_status status = chain_leave(geometry, &leaves, &leave, NULL);
    real fall = leaves ? tilt_angle(leave) : 0;
    if (status != DOM_OK || !leaves || *left != 0 || fabs(theta - fall) > near * fall)
        return status;
    status = geometry_tilt(geometry, fmin(fall * (1 + near), tilt_angle(geometry->c)), &head);
    if (status == DOM_OK)
        status = chain_energy_change(geometry, head, &at, NULL);
    if (status == DOM_OK)
        *left = at.left;
    return status;
}

/* The state at a tilt; time NaN: not known yet. */
KERNEL enum dom_status motion_state(struct motion *m, real theta, real time, struct dom_state *state,
                                    struct dom_state_error *error)
{
    struct cycle *c = &m->cycle;
    struct tilt head;
    struct sums at, e = {0};
    struct fuel fuel, fuel_error = {0};
    real omegasq = 0, omegasq_error = 0, acceleration = 0;
    enum dom_status status = geometry_tilt(&c->geometry, theta, &head);
    if (status == DOM_OK && theta > m->end * (1 + 4 * REAL_EPSILON))
        return DOM_STOPS;
    theta = fmin(theta, m->end);
    bool rubs = c->geometry.mu > 0;
    if (status == DOM_OK)
        status = chain_energy_change(&c->geometry, head, &at, error ? &e : NULL);
    if (status == DOM_OK)
        status = cycle_speed(c, theta, &omegasq, error ? &omegasq_error : NULL);
    /* At the stop it is 0, which rounding hides. */
    bool rests = m->stops && theta >= m->end * (1 - 4 * REAL_EPSILON);
    omegasq = rests ? 0 : fmax(omegasq, 0);
    if (status == DOM_OK)
        status = fallen_energy(&c->geometry, theta, &at.left);
    if (status == DOM_OK && isnan(time))
        status = motion_time(m, 0, theta, &time);
    if (status == DOM_OK)
        status = motion_acceleration(&c->geometry, head, omegasq, &acceleration, NULL);
    if (status == DOM_OK)
        status = energy_fuel(&c->geometry, &fuel, error ? &fuel_error : NULL);
    if (status != DOM_OK)
        return status;
    /* The hitting train is this one at theta_c, made smaller: its energy by r^-q. */
    real velocity_ratio = c->launch.velocity_ratio;
    real after =
        rubs ? c->geometry.flow->J_c * c->launch.omegasq / (c->geometry.r * velocity_ratio * velocity_ratio)
             : c->launch.kinetic + fuel.exact;
    real before = c->geometry.weight * after, J0 = c->launch.J0;
    *state = (struct dom_state){
        .theta = theta,
        .time = time,
        .omegasq = omegasq,
        .acceleration = acceleration,
        .kinetic = at.J * omegasq,
        .climbed = at.dH,
        .fallen = at.left,
        .before = before,
        .lost = rubs ? before - c->launch.kinetic : before / J0,
        .friction_work = rubs && theta > 0 ? c->launch.kinetic - at.dH - at.J * omegasq : 0,
    };
    if (!error)
        return DOM_OK;
    real of_time = 0, of_kinetic = c->launch_error.kinetic;
    real of_before = c->geometry.weight * (of_kinetic + fuel_error.exact) + 5 * UNIT * before;
    if (rubs)
        of_time = REAL_NAN;
    else
        status = time_error(m, state, &of_time);
    *error = (struct dom_state_error){
        .time = of_time,
        .omegasq = omegasq_error,
        .acceleration = REAL_NAN, /* no bound is known */
        .kinetic = of_kinetic + e.dH + 3 * UNIT * at.J * omegasq,
        .climbed = e.dH,
        .fallen = at.left == 0 ? 0 : e.dH,
        .before = of_before,
        .lost = (of_before + before * c->launch_error.J0 / J0) / J0 + UNIT * before,
    };
    return status;
}

KERNEL enum dom_status cycle_state(const struct request *train, dom_real theta, struct dom_state *state,
                                   struct dom_state_error *error)
{
    struct motion m;
    FLOW(flow);
    enum dom_status status = motion_begin(train, &flow, &m, error != NULL);
    return status == DOM_OK ? motion_state(&m, (real)theta, REAL_NAN, state, error) : status;
}
