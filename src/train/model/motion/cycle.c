/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The cycle of an endless train: its launch, barrier and verdict, its events and its states. */
#include "motion/motion.h"

/* Returns the relative tolerance to which two terms must be computed, so that their difference is known to
 * the relative tolerance tol. Both terms are about `whole`, and their difference is about `left`. */
static real balance_tol(real tol, real left, real whole)
{
    return left > whole / 4 ? tol : fmin(tol, fmax(tol * left / whole, 4 * REAL_EPSILON));
}

/* Finds the launch and the barrier. If the kinetic energy and the barrier are nearly equal, their difference
 * is inexact. Then both are computed again with a finer tolerance. */
static enum dom_status motion_balance(struct motion *m, enum dom_fuel fuel)
{
    struct segment *st = &m->segment;
    real tol;
    do {
        enum dom_status status = dynamics_launch(&st->geometry, fuel, &m->launch);
        if (status == DOM_OK)
            status = barrier_search(&st->geometry, false, st->geometry.tol / 8, &st->barrier);
        if (status != DOM_OK || m->launch.fuel <= 0)
            return status == DOM_OK ? DOM_NO_FUEL : status;
        tol = st->geometry.tol;
        st->geometry.tol = balance_tol(tol, fabs(m->launch.kinetic - st->barrier.height), m->launch.kinetic);
    } while (st->geometry.tol < tol / 4);
    return DOM_OK;
}

KERNEL_SHARED enum dom_status motion_prepare(const struct dom_train *train, const struct dom_compute *compute,
                                             bool timed, struct motion *m)
{
    struct segment *st = &m->segment;
    const struct launch *launch = &m->launch;
    *m = (struct motion){.launch.fuel = REAL_NAN};
    enum dom_status status = train_make(train, compute, true, &st->geometry);
    m->tol = st->geometry.tol;
    st->geometry.flow = &m->flow;
    m->end = st->hi = tilt_angle(st->geometry.c);
    if (status == DOM_OK)
        status = motion_balance(m, train->fuel);
    if (status != DOM_OK)
        return status;
    st->start = (struct start){
        .from = standing, .J = launch->J0, .omegasq = launch->omegasq, .kinetic = launch->kinetic};
    st->gain = 1;
    st->inertia_ratio = launch->inertia_ratio;
    /* (26; c8), corrected: the paper leaves out the factor J(0). The search for r_max compares the same
     * energies (growth/limit.h). */
    m->stops = !(launch->kinetic >= st->barrier.height);
    if (m->stops)
        status = segment_rest(st, &m->end);
    return status == DOM_OK && timed ? clock_begin(&m->clock, st, m->end, m->stops, m->tol) : status;
}

KERNEL_SHARED void motion_end(struct motion *m)
{
    num_linear_free(&m->flow.solution);
    clock_free(&m->clock);
}

/* Finds tau^2 omega^2 at theta. Returns DOM_STOPS if the train does not reach theta. Where the train comes to
 * rest, *omegasq is exactly 0. */
static enum dom_status motion_speed(const struct motion *m, real theta, real *omegasq)
{
    if (theta > m->end * (1 + 4 * REAL_EPSILON))
        return DOM_STOPS;
    enum dom_status status =
        dynamics_speed(&m->segment.geometry, &m->segment.start, fmin(theta, m->end), omegasq);
    bool rests = m->stops && theta >= m->end * (1 - 4 * REAL_EPSILON);
    *omegasq = rests ? 0 : fmax(*omegasq, 0);
    return status;
}

enum dom_status dom_barrier_find(const struct dom_train *train, const struct dom_compute *compute,
                                 struct dom_barrier *barrier)
{
    struct motion m;
    const struct barrier *b = &m.segment.barrier;
    const enum dom_status status = motion_prepare(train, compute, false, &m);
    const real kinetic = status == DOM_OK ? m.launch.kinetic : REAL_NAN;
    motion_end(&m);
    if (status != DOM_OK && status != DOM_NO_FUEL)
        return status;
    *barrier = (struct dom_barrier){.theta_m = b->theta_m,
                                    .barrier = b->height,
                                    .kinetic = kinetic,
                                    .margin = kinetic - b->height,
                                    .stop = m.stops ? m.end : REAL_NAN};
    return m.stops ? DOM_STOPS : status;
}

enum dom_status dom_cycle_omegasq(const struct dom_train *train, const struct dom_compute *compute,
                                  dom_real theta, dom_real *omegasq)
{
    struct dom_compute finer = compute_or_default(compute);
    real w = 0, tol;
    *omegasq = DOM_NAN;
    /* Near a stop, the remaining energy is the small difference of two large terms. Then both terms are
     * computed again with a finer tolerance. */
    do {
        struct motion m;
        struct tilt head;
        enum dom_status status = motion_prepare(train, &finer, false, &m);
        if (status == DOM_OK)
            status = geometry_tilt(&m.segment.geometry, theta, &head);
        if (status == DOM_OK)
            status = motion_speed(&m, theta, &w);
        motion_end(&m);
        if (status != DOM_OK)
            return status;
        tol = m.segment.geometry.tol;
        finer.tol = fmax(balance_tol(tol, w, m.launch.omegasq), dom_arithmetic()->tol_floor);
    } while (w != 0 && finer.tol < tol / 4);
    *omegasq = w;
    return DOM_OK;
}

enum dom_status dom_cycle_duration(const struct dom_train *train, const struct dom_compute *compute,
                                   dom_real *duration)
{
    struct motion m;
    enum dom_status status = motion_prepare(train, compute, false, &m);
    if (status == DOM_OK)
        status = m.stops ? DOM_STOPS : clock_begin(&m.clock, &m.segment, m.end, false, m.tol);
    if (status == DOM_OK)
        *duration = clock_time(&m.clock, m.end);
    motion_end(&m);
    return status;
}

/* ---- Events ---- */

/* The event of a follower that detaches has a tilt that is larger by this fraction: whatever rounding does,
 * the state is that after the follower has detached. */
#define DETACHED (64 * REAL_EPSILON)

/* Lists the events of the motion in order, and returns their number, which is at most DOM_EVENTS_MAX. */
static int motion_events(const struct motion *m, struct dom_event *events)
{
    const struct barrier *b = &m->segment.barrier;
    const real top = b->theta_m > 0 ? b->theta_m : m->end, fall = b->leave * (1 + DETACHED);
    const struct dom_event passed[] = {{.kind = DOM_EVENT_TOP, .theta = top},
                                       {.kind = DOM_EVENT_DETACH, .theta = fall, .domino = b->domino}};
    int n = 0;
    events[n++] = (struct dom_event){.kind = DOM_EVENT_LAUNCH};
    for (int i = 0; i < 2; i++) {
        events[n] = passed[fall < top ? 1 - i : i];
        n += events[n].theta < m->end;
    }
    events[n++] = (struct dom_event){.kind = m->stops ? DOM_EVENT_STOP : DOM_EVENT_HIT, .theta = m->end};
    for (int i = 0; i < n; i++)
        events[i].time = clock_time(&m->clock, events[i].theta);
    return n;
}

enum dom_status dom_cycle_events(const struct dom_train *train, const struct dom_compute *compute,
                                 struct dom_event *events, int *count)
{
    struct motion m;
    const enum dom_status status = motion_prepare(train, compute, true, &m);
    *count = status == DOM_OK ? motion_events(&m, events) : 0;
    motion_end(&m);
    return status == DOM_OK && m.stops ? DOM_STOPS : status;
}

/* ---- The state at a tilt ---- */

static enum dom_status motion_state(struct motion *m, real theta, struct dom_state *state)
{
    const struct launch *launch = &m->launch;
    const struct geometry *geometry = &m->segment.geometry;
    const bool conservative = geometry->conservative;
    struct tilt head;
    struct sums at;
    struct equation_of_motion equation;
    real omegasq = 0;
    enum dom_status status = geometry_tilt(geometry, theta, &head);
    if (status == DOM_OK)
        status = motion_speed(m, theta, &omegasq);
    theta = fmin(theta, m->end);
    if (status == DOM_OK)
        status = chain_change(geometry, standing, head, PASS_PLAIN, &at);
    if (status == DOM_OK)
        status = chain_equation(geometry, head, &equation);
    if (status != DOM_OK)
        return status;
    /* Just before the hit, the train that hits the head looks like this train at theta_c, scaled by 1 / r. So
     * the kinetic energy of the hitting train is r^-q times that of this train at theta_c. */
    real before = geometry->weight * launch->kinetic_at_hit;
    *state = (struct dom_state){
        .theta = theta,
        .time = clock_time(&m->clock, theta),
        .omegasq = omegasq,
        .acceleration = (equation.C - equation.B * omegasq) / equation.A,
        .kinetic = at.J * omegasq,
        .climbed = at.dH,
        .fallen = at.left,
        .before = before,
        .lost = conservative ? before * geometry->upright_inertia / launch->J0 : before - launch->kinetic,
        .friction_work = conservative || theta == 0 ? 0 : launch->kinetic - at.dH - at.J * omegasq,
    };
    return DOM_OK;
}

enum dom_status dom_cycle_state(const struct dom_train *train, const struct dom_compute *compute,
                                dom_real theta, struct dom_state *state)
{
    struct motion m;
    enum dom_status status = motion_prepare(train, compute, true, &m);
    if (status == DOM_OK)
        status = motion_state(&m, theta, state);
    motion_end(&m);
    return status;
}

/* ---- The cycle as a table ---- */

enum dom_status dom_cycle_walk(const struct dom_train *train, const struct dom_compute *compute,
                               size_t states, enum dom_spacing by, dom_state_visit *visit, void *context)
{
    struct motion m;
    struct dom_event events[DOM_EVENTS_MAX];
    int next = 0;
    bool more = true;
    enum dom_status status = motion_prepare(train, compute, true, &m);
    const int count = status == DOM_OK ? motion_events(&m, events) : 0;
    for (size_t k = 0; k < states && status == DOM_OK && more; k++) {
        real part = states > 1 ? (real)k / (real)(states - 1) : 1, theta = part * m.end;
        if (by == DOM_BY_TIME && part > 0 && part < 1)
            status = clock_tilt(&m.clock, part * clock_time(&m.clock, m.end), &theta);
        /* First the events up to this state, then the state, unless it is that of an event. */
        for (bool happens = true; happens && status == DOM_OK && more;) {
            struct dom_state state;
            happens = next < count && events[next].theta <= theta;
            if (!happens && !(next < count && theta > events[next > 0 ? next - 1 : 0].theta))
                break;
            status = motion_state(&m, happens ? fmin(events[next].theta, m.end) : theta, &state);
            more = status == DOM_OK && visit(&state, happens ? &events[next] : NULL, context);
            next += happens;
        }
    }
    motion_end(&m);
    return status == DOM_OK && m.stops ? DOM_STOPS : status;
}
