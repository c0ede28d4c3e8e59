/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One cycle as it runs: events, times, accelerations. */
#include "motion/motion.h"

/* ---- Times ---- */

KERNEL enum dom_status motion_begin(const struct dom_train *train, struct flow *flow, struct motion *m)
{
    enum dom_status status = cycle_whole(train, flow, &m->cycle, false);
    if (status != DOM_OK)
        return status;
    m->end = tilt_angle(m->cycle.lean.c);
    real margin = m->cycle.launch.kinetic - m->cycle.barrier.height;
    m->stops = margin < 0;
    m->tol = fmax((real)train->tol / 8, 16 * REAL_EPSILON * m->cycle.launch.kinetic / fabs(margin));
    if (!(m->tol < (real)0.125))
        return DOM_NOT_CONVERGED; /* as a duration, a time would grow like ln(1/margin) */
    return m->stops ? cycle_rest(m->cycle, &m->end) : DOM_OK;
}

/*
 * H(end) - H(end - delta) for a small delta, as the integral of H' (Gauss, three points): nothing cancels.
 * With friction the same of u.
 */
static enum dom_status motion_drop(const struct lean *g, real end, real delta, real *drop)
{
    const real root = sqrt((real)3 / 5);
    const real place[] = {(1 - root) / 2, (real)1 / 2, (1 + root) / 2};
    static const int weight[] = {5, 8, 5};
    *drop = 0;
    for (int k = 0; k < 3; k++) {
        struct tilt head;
        struct sums at;
        enum dom_status status = lean_tilt(g, end - place[k] * delta, &head);
        if (status == DOM_OK)
            status =
                g->mu > 0 ? friction_rate(g, head, end - place[k] * delta, &at.H1) : chain_sum(g, head, &at);
        if (status != DOM_OK)
            return status;
        *drop += delta * (real)weight[k] / 18 * at.H1;
    }
    return DOM_OK;
}

/* This close to a stop, as a part of its tilt, the energy that is left comes from motion_drop. */
#define CLOSE ((real)0.01)

/* slowness_before of a train with friction: w = G (u(end) - u(theta)). */
static real rubbing_before(struct motion *m, real theta, real delta, real root)
{
    struct cycle *c = &m->cycle;
    real ln_G, u;
    friction_at(&c->lean, theta, &ln_G, &u);
    real left = c->launch.omegasq - u;
    if (c->status == DOM_OK && root * root < CLOSE)
        c->status = motion_drop(&c->lean, m->end, delta, &left);
    return c->status == DOM_OK && left > 0 ? 2 * m->end * root / sqrt(exp(ln_G) * left) : REAL_NAN;
}

/*
 * With theta = end (1 - u^2) the slowness before a stop, which grows like 1/sqrt(end - theta), is smooth:
 * dt/du = 2 end u / (tau omega), and at u = 0 the limit of that.
 */
static real slowness_before(real u, void *context)
{
    struct motion *m = context;
    struct cycle *c = &m->cycle;
    struct tilt head;
    struct sums at = {.J = 1};
    real delta = m->end * u * u, theta = m->end - delta, left = 0;
    c->status = lean_tilt(&c->lean, theta, &head);
    if (c->lean.mu > 0)
        return rubbing_before(m, theta, delta, u);
    if (c->status == DOM_OK)
        c->status = u * u < CLOSE ? chain_sum(&c->lean, head, &at) : chain_rise(&c->lean, head, &at, NULL);
    left = c->launch.kinetic - at.dH;
    if (c->status == DOM_OK && u * u < CLOSE)
        c->status = motion_drop(&c->lean, m->end, delta, &left);
    return c->status == DOM_OK && left > 0 ? 2 * m->end * u * sqrt(at.J / left) : REAL_NAN;
}

/* Time from one tilt to another. */
static enum dom_status motion_time(struct motion *m, real from, real to, real *time)
{
    const struct barrier *b = &m->cycle.barrier;
    real smooth = to, part = 0;
    *time = 0;
    if (to <= from)
        return DOM_OK;
    if (m->stops) { /* the last piece before the stop has an end like no other */
        smooth = from;
        for (int i = 0; i < b->edges; i++)
            smooth = b->edge[i] < to ? fmax(smooth, b->edge[i]) : smooth;
    }
    enum dom_status status = cycle_integral(&m->cycle, slowness, from, smooth, m->tol, time, NULL);
    if (status != DOM_OK || !m->stops)
        return status;
    enum num_status solver = num_integral(slowness_before, m, sqrt(fmax(1 - to / m->end, 0)),
                                          sqrt(1 - smooth / m->end), m->tol, &part, NULL);
    *time += part;
    return model_status(m->cycle.status, solver);
}

KERNEL enum dom_status cycle_events(const struct dom_train *train, struct dom_event *events, int *count)
{
    struct motion m;
    struct flow flow;
    bool leaves;
    struct tilt leave;
    size_t domino = 0;
    enum dom_status status = motion_begin(train, &flow, &m);
    if (status == DOM_OK)
        status = chain_leave(&m.cycle.lean, &leaves, &leave, &domino);
    if (status != DOM_OK)
        return status;
    real top = m.cycle.barrier.theta_m, fall = leaves ? tilt_angle(leave) : 0;
    int n = 0;
    events[n++] = (struct dom_event){.kind = DOM_EVENT_LAUNCH};
    if (top > 0 && top < m.end)
        events[n++] = (struct dom_event){.kind = DOM_EVENT_TOP, .theta = top};
    if (leaves && fall < m.end) {
        int at = n++;
        bool first = at > 1 && fall < top;
        if (first)
            events[at] = events[at - 1];
        events[first ? at - 1 : at] =
            (struct dom_event){.kind = DOM_EVENT_FALL, .theta = fall, .domino = domino};
    }
    events[n++] = (struct dom_event){.kind = m.stops ? DOM_EVENT_STOP : DOM_EVENT_HIT, .theta = m.end};
    for (int i = 1; i < n && status == DOM_OK; i++) {
        real step = 0;
        status = motion_time(&m, (real)events[i - 1].theta, (real)events[i].theta, &step);
        events[i].time = events[i - 1].time + step;
    }
    *count = status == DOM_OK ? n : 0;
    return status == DOM_OK && m.stops ? DOM_STOPS : status;
}

/*
 * The tilt at a time, by Newton, whose derivative is omega, and halving where that leaves the bracket;
 * *at is where it begins and where it ends.
 */
static enum dom_status tilt_search(struct motion *m, real time, real tol, real *at)
{
    real lo = 0, hi = m->end;
    m->tol = tol;
    for (int i = 0; i < 200; i++) {
        real omegasq = 0, passed = 0;
        enum dom_status status = cycle_speed(&m->cycle, *at, &omegasq, NULL);
        if (status == DOM_OK)
            status = motion_time(m, 0, *at, &passed);
        if (status != DOM_OK)
            return status;
        real off = time - passed, next = *at + off * sqrt(fmax(omegasq, 0));
        *(off >= 0 ? &lo : &hi) = *at;
        if (!(next > lo && next < hi))
            next = (lo + hi) / 2;
        bool there = fabs(next - *at) <= fmax(tol, 4 * REAL_EPSILON) * m->end;
        *at = next;
        if (there)
            return DOM_OK;
    }
    return DOM_NOT_CONVERGED;
}

KERNEL enum dom_status cycle_tilt(const struct dom_train *train, dom_real time_, dom_real *theta)
{
    struct motion m;
    struct flow flow;
    real time = (real)time_, whole = 0, at = 0;
    enum dom_status status = motion_begin(train, &flow, &m);
    if (status == DOM_OK)
        status = motion_time(&m, 0, m.end, &whole);
    if (status != DOM_OK)
        return status;
    if (!(time >= 0 && time <= whole * (1 + 4 * REAL_EPSILON)))
        return DOM_BAD_TILT;
    if (time == 0 || time >= whole) {
        *theta = time == 0 ? 0 : m.end;
        return DOM_OK;
    }
    /* Cheap integrals lead close by; then each step doubles the digits. */
    const real tol = m.tol;
    status = tilt_search(&m, time, fmax(tol, (real)1e-8), &at);
    if (status == DOM_OK && tol < (real)1e-8)
        status = tilt_search(&m, time, tol, &at);
    if (status == DOM_OK)
        *theta = at;
    return status;
}

/* ---- Accelerations ---- */

/* tau^2 times the head's acceleration: half of dw/dtheta, J dw/dtheta = -H' - J' w. */
KERNEL enum dom_status motion_acceleration(const struct lean *g, struct tilt head, real w, real *acceleration,
                                           size_t *n)
{
    struct sums at;
    struct law law;
    enum dom_status status = chain_sum(g, head, &at);
    if (status == DOM_OK)
        *n = at.n;
    if (status == DOM_OK && g->mu > 0) {
        status = friction_law(g, head, &law);
        *acceleration = (law.C - law.B * w) / law.A;
    }
    if (status != DOM_OK || g->mu > 0)
        return status;
    struct link k = link_head(g, head);
    real half_J1 = 0, bend = 0;
    for (size_t i = 0; i < at.n; i++) {
        half_J1 += k.inertia * k.slope * bend;
        if (!k.leads || i + 1 == at.n)
            break;
        struct link leader = k;
        link_next(&k);
        bend = link_bend(&leader, bend, &k);
    }
    *acceleration = -(at.H1 / 2 + half_J1 * w) / at.J;
    return DOM_OK;
}

/*
 * Of the time up to theta: the integral of the slowness's bound, and what the tolerance leaves.  Towards a
 * stop, where the slowness has no bound, the rounding of the energy counts through m->tol alone.
 */
static enum dom_status time_error(struct motion *m, real theta, real time, real *error)
{
    real of_speed = 0;
    enum num_status solver = NUM_OK;
    if (!m->stops && theta > 0)
        solver = num_integral(slowness_error, &m->cycle, 0, theta, (real)0.125, &of_speed, NULL);
    *error = 2 * of_speed + (real)(m->stops ? 64 : 1) * fmax(m->tol, 8 * UNIT) * time;
    return model_status(m->cycle.status, solver);
}

/* At the tilt where a follower leaves, which rounding may set before or behind it, it has left. */
static enum dom_status fallen_energy(const struct lean *g, real theta, real *left)
{
    const real near = 4096 * REAL_EPSILON;
    bool leaves;
    struct tilt leave, head;
    struct sums at;
    enum dom_status status = chain_leave(g, &leaves, &leave, NULL);
    real fall = leaves ? tilt_angle(leave) : 0;
    if (status != DOM_OK || !leaves || *left != 0 || fabs(theta - fall) > near * fall)
        return status;
    status = lean_tilt(g, fmin(fall * (1 + near), tilt_angle(g->c)), &head);
    if (status == DOM_OK)
        status = chain_rise(g, head, &at, NULL);
    if (status == DOM_OK)
        *left = at.left;
    return status;
}

KERNEL enum dom_status cycle_state(const struct dom_train *train, dom_real theta_, struct dom_state *state,
                                   struct dom_state *error)
{
    struct motion m;
    struct flow flow;
    struct tilt head;
    struct sums at, e = {0};
    struct fuel fuel, fuel_error = {0};
    real theta = (real)theta_, omegasq = 0, omegasq_error = 0, time = 0, acceleration = 0;
    size_t matter;
    enum dom_status status = motion_begin(train, &flow, &m);
    if (status != DOM_OK)
        return status;
    struct cycle *c = &m.cycle;
    status = lean_tilt(&c->lean, theta, &head);
    if (status == DOM_OK && theta > m.end * (1 + 4 * REAL_EPSILON))
        return DOM_STOPS;
    theta = fmin(theta, m.end);
    bool rubs = c->lean.mu > 0;
    if (status == DOM_OK && error && rubs)
        c->launch_error = (struct launch){REAL_NAN, REAL_NAN, REAL_NAN, REAL_NAN, REAL_NAN};
    else if (status == DOM_OK && error)
        status = collision_launch(&c->lean, train->fuel, &c->launch, &c->launch_error);
    if (status == DOM_OK)
        status = chain_rise(&c->lean, head, &at, error ? &e : NULL);
    if (status == DOM_OK)
        status = cycle_speed(c, theta, &omegasq, error ? &omegasq_error : NULL);
    /* At the stop it is 0, which rounding hides. */
    bool rests = m.stops && theta >= m.end * (1 - 4 * REAL_EPSILON);
    omegasq = rests ? 0 : fmax(omegasq, 0);
    if (status == DOM_OK)
        status = fallen_energy(&c->lean, theta, &at.left);
    if (status == DOM_OK)
        status = motion_time(&m, 0, theta, &time);
    if (status == DOM_OK)
        status = motion_acceleration(&c->lean, head, omegasq, &acceleration, &matter);
    if (status == DOM_OK)
        status = energy_fuel(&c->lean, &fuel, error ? &fuel_error : NULL);
    if (status != DOM_OK)
        return status;
    /* The hitting train is this one at theta_c, made smaller: its energy by r^-q. */
    real keeps = c->launch.keeps;
    real after =
        rubs ? flow.J_c * c->launch.omegasq / (c->lean.r * keeps * keeps) : c->launch.kinetic + fuel.exact;
    real before = c->lean.weight * after, J0 = c->launch.J0;
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
        .rubbed = rubs && theta > 0 ? c->launch.kinetic - at.dH - at.J * omegasq : 0,
    };
    if (!error)
        return DOM_OK;
    real of_time = 0, of_kinetic = c->launch_error.kinetic;
    real of_before = c->lean.weight * (of_kinetic + fuel_error.exact) + 5 * UNIT * before;
    if (rubs)
        of_time = REAL_NAN;
    else
        status = time_error(&m, theta, time, &of_time);
    *error = (struct dom_state){
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
