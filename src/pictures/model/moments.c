/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Finds the state of a row at given times. The motion of each head is divided into passages: whenever a
 * domino detaches, a new passage begins. A detached domino keeps its tilt. Within a passage, a clock finds
 * the tilt at a given time.
 */
#include "dynamics/dynamics.h"
#include "numerics/api.h"
#include "row/row.h"
#include <stdlib.h>

/* The times at which the caller wants the state of a row, and the current state. */
struct watch {
    const double *time; /* the requested times in s, in ascending order */
    size_t times, next; /* number of requested times, and index of the next one to report */
    dom_moment_visit *visit;
    void *context;
    bool ended;           /* true if the callback has ended the run */
    double *tilt, *omega; /* tilt and angular velocity of each domino, in rad and rad/s */
    size_t head, moving;  /* index of the head, and number of moving dominoes */
    struct descent last;  /* the last motion over a segment */
};

/* ---- The state at a given tilt of the head ---- */

/* Sets the tilts and angular velocities of all moving dominoes from those of the head, `theta` and `omega`,
 * in rad and rad/s. */
static enum dom_status watch_lean(struct watch *w, const struct segment *st, size_t head, real theta,
                                  real omega)
{
    struct tilt tilt;
    enum dom_status status = geometry_tilt(&st->geometry, theta, &tilt);
    if (status != DOM_OK)
        return status;
    struct link k = link_head(&st->geometry, tilt, st->geometry.rolls);
    w->moving = st->geometry.n;
    for (;;) {
        w->tilt[head - k.i] = k.i == 0 ? theta : tilt_angle(k.tilt);
        w->omega[head - k.i] = k.slope * omega;
        if (k.i + 1 >= st->geometry.n)
            return DOM_OK;
        /* All n dominoes lean on each other, so `leads` should be true. Only a rounding error at the end of a
         * passage can make it false. */
        if (!k.leads) {
            link_touch(&k);
            k.contact.slope = 0;
        }
        link_on(&k);
    }
}

static void watch_visit(struct watch *w, dom_real time)
{
    const struct dom_moment moment = {
        .time = time, .head = w->head + 1, .moving = w->moving, .tilt = w->tilt, .omega = w->omega};
    w->next++;
    w->ended = !w->visit(&moment, w->context);
    if (w->ended)
        w->times = w->next;
}

/* Sets the state at the tilt theta of the last motion. */
static enum dom_status watch_state(struct watch *w, real theta)
{
    const struct descent *d = &w->last;
    const struct segment *st = &d->st;
    const bool still = (d->stops && theta >= d->to) || (st->start.omegasq == 0 && theta <= st->lo);
    real omegasq = 0;
    enum dom_status status = still ? DOM_OK : dynamics_speed(&st->geometry, &st->start, theta, &omegasq);
    return status == DOM_OK ? watch_lean(w, st, d->head, theta, sqrt(fmax(omegasq, 0)) / d->tau) : status;
}

/* Returns the time at which a motion over a segment ends, in s. */
static real end_of(const struct descent *d)
{
    return d->begins + (d->time + d->lasts) * d->tau;
}

static void watch_head(struct run *run, size_t k)
{
    struct watch *w = run->options->context;
    w->head = k;
    if (k == 0) /* the first domino may be released at another tilt than its lean */
        w->tilt[0] = run->row->geometry[0].lean;
}

/* Reports the states at those requested times that lie in the motion over a segment. */
static enum dom_status watch_motion(struct run *run, const struct descent *d)
{
    struct watch *w = run->options->context;
    enum dom_status status = isnan(end_of(d)) && w->next < w->times ? DOM_NO_MARGIN : DOM_OK;
    w->last = *d;
    while (status == DOM_OK && w->next < w->times && w->time[w->next] < end_of(d)) {
        const real time = (w->time[w->next] - d->begins) / d->tau - d->time;
        real theta = d->st.lo;
        if (time > 0)
            status = clock_tilt(&run->clock, time, &theta);
        if (status == DOM_OK)
            status = watch_state(w, theta);
        if (status == DOM_OK)
            watch_visit(w, w->time[w->next]);
    }
    return status;
}

/* Stores the tilts of the dominoes that detach. They keep these tilts. */
static enum dom_status watch_detach(struct run *run, const struct descent *d)
{
    struct watch *w = run->options->context;
    enum dom_status status = watch_lean(w, &d->st, d->head, d->st.hi, 0);
    w->moving = d->moving;
    return status;
}

/* After the end of the run, reports the states at all remaining requested times. */
static enum dom_status watch_rest(struct run *run)
{
    struct watch *w = run->options->context;
    enum dom_status status = DOM_OK;
    if (w->next >= w->times)
        return DOM_OK;
    if (w->last.run) /* a domino has moved */
        status = watch_state(w, w->last.to);
    while (status == DOM_OK && w->next < w->times)
        watch_visit(w, end_of(&w->last));
    return status;
}

/* ---- Public ---- */

static bool watch_goes_on(const struct dom_fall *fall, void *context)
{
    const struct watch *w = context;
    (void)fall;
    return !w->ended;
}

enum dom_status dom_row_watch(const struct dom_row *row, const struct dom_compute *compute,
                              const double *times, size_t count, dom_moment_visit *visit, void *context,
                              struct dom_verdict *verdict)
{
    if (row->engine)
        return DOM_NO_METHOD;
    for (size_t k = 0; k < count; k++)
        if (isnan(times[k]) || times[k] < 0 || (k > 0 && times[k] < times[k - 1]))
            return DOM_BAD_TIME;
    struct watch w = {.time = times,
                      .times = count,
                      .visit = visit,
                      .context = context,
                      .tilt = calloc(row->count + 1, sizeof *w.tilt),
                      .omega = calloc(row->count + 1, sizeof *w.omega)};
    const struct run_options options = {.times = true,
                                        .begins = watch_head,
                                        .moves = watch_motion,
                                        .detaches = watch_detach,
                                        .rests = watch_rest,
                                        .context = &w};
    enum dom_status status = w.tilt && w.omega ? DOM_OK : DOM_NO_MEMORY;
    for (size_t k = 0; status == DOM_OK && k < row->count; k++)
        w.tilt[k] = row->domino[k].lean;
    if (status == DOM_OK)
        status = row_run(row, compute, &options, watch_goes_on, &w, verdict);
    free(w.tilt);
    free(w.omega);
    return status;
}

/* ---- The contact forces of a train at a tilt ---- */

enum dom_status dom_cycle_forces(const struct dom_train *train, const struct dom_compute *compute,
                                 double theta, dom_force_visit *visit, void *context)
{
    struct motion m;
    struct kinematics motion;
    struct tilt head;
    struct loaded *list = NULL;
    size_t n = 0;
    enum dom_status status = motion_prepare(train, compute, false, &m);
    if (status == DOM_OK)
        status = geometry_tilt(&m.segment.geometry, theta, &head);
    if (status == DOM_OK && theta > m.end * (1 + 4 * REAL_EPSILON))
        status = DOM_STOPS;
    if (status == DOM_OK)
        status = forces_at(&m.segment, fmin(theta, m.end), 0, &motion, &list, &n);
    for (size_t i = 0; i < n; i++) {
        const struct dom_force force = {.i = i,
                                        .force = list[i].force,
                                        .per_weight = list[i].force * list[i].size / list[i].link.weight,
                                        .impulse = list[i].impulse};
        if (!visit(&force, context))
            break;
    }
    motion_end(&m);
    free(list);
    return status;
}
