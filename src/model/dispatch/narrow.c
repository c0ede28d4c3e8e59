/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The kernel with which the functions of <domino.h> compute in float or quad, or by a method for comparison.
 * Only the kernel in double is compiled for <domino.h>. All others are compiled once, for <domino_quad.h>,
 * and this kernel calls the functions of <domino_quad.h> and rounds their results to double.
 */
#include "dispatch/narrow.h"

NARROW(angles_error)
NARROW(angles)
NARROW(contact_error)
NARROW(contact)
NARROW(link_error)
NARROW(link)
NARROW(energy_error)
NARROW(energy)
NARROW(fuels_error)
NARROW(fuels)
NARROW(launch_error)
NARROW(launch)
NARROW(barrier_error)
NARROW(barrier)
NARROW(value)
NARROW(event)
NARROW(state_error)
NARROW(state)
NARROW(force)
NARROW(least_force)
NARROW(floor)
NARROW(limit_error)
NARROW(limit)
NARROW(best_error)
NARROW(best)
NARROW(count_error)
NARROW(count)

/* ---- Questions about a train ---- */

#define COPY(name, default_, lowest, highest, unit, meaning) .name = q->name,

static struct domq_train wide_train(const struct request *q)
{
    return (struct domq_train){DOM_TRAIN_PARAMETERS(COPY) DOM_DYNAMICS(EFFECT).fuel = q->fuel};
}

static struct domq_compute wide_compute(const struct request *q)
{
    return (struct domq_compute){.tol = wide_tol(q->tol, q->precision),
                                 .precision = q->precision,
                                 .method = q->method,
                                 .errors = q->errors,
                                 .work = q->work,
                                 .interrupt = q->interrupt};
}

/* Defines a function of the kernel whose result is a structure. The structure is written only if the status
 * is one of those listed. */
#define FIND(find, structure, is_written)                                                                    \
    static enum dom_status narrow_##find(const struct request *q, struct dom_##structure *found)             \
    {                                                                                                        \
        const struct domq_train train = wide_train(q);                                                       \
        const struct domq_compute compute = wide_compute(q);                                                 \
        struct domq_##structure wide;                                                                        \
        enum dom_status status = domq_##find(&train, &compute, &wide);                                       \
        if (is_written)                                                                                      \
            narrow_##structure(found, &wide);                                                                \
        return status;                                                                                       \
    }
#define FIND_AT(find, structure)                                                                             \
    static enum dom_status narrow_##find(const struct request *q, dom_real theta,                            \
                                         struct dom_##structure *found)                                      \
    {                                                                                                        \
        const struct domq_train train = wide_train(q);                                                       \
        const struct domq_compute compute = wide_compute(q);                                                 \
        struct domq_##structure wide;                                                                        \
        enum dom_status status = domq_##find(&train, &compute, theta, &wide);                                \
        if (status == DOM_OK)                                                                                \
            narrow_##structure(found, &wide);                                                                \
        return status;                                                                                       \
    }
FIND(angles_find, angles, status == DOM_OK)
FIND_AT(contact_find, contact)
FIND_AT(energy_find, energy)
FIND(fuel_find, fuels, status == DOM_OK)
FIND(launch_find, launch, status == DOM_OK || status == DOM_NO_FUEL)
FIND(barrier_find, barrier, status == DOM_OK || status == DOM_STOPS || status == DOM_NO_FUEL)
FIND_AT(cycle_omegasq, value)
FIND(cycle_stop, value, status == DOM_OK)
FIND(cycle_duration, value, status == DOM_OK)
FIND_AT(cycle_state, state)
FIND(cycle_least_force, least_force, status == DOM_OK)
FIND(cycle_floor, floor, status == DOM_OK)
FIND(limit_rmax, limit, status == DOM_OK)
FIND(limit_pair, limit, status == DOM_OK)
FIND(limit_best, best, status == DOM_OK)

static enum dom_status narrow_cycle_events(const struct request *q, struct dom_event *events, int *count)
{
    const struct domq_train train = wide_train(q);
    const struct domq_compute compute = wide_compute(q);
    struct domq_event wide[DOM_EVENTS_MAX];
    enum dom_status status = domq_cycle_events(&train, &compute, wide, count);
    for (int k = 0; k < *count; k++)
        narrow_event(&events[k], &wide[k]);
    return status;
}

static enum dom_status narrow_cycle_tilt(const struct request *q, dom_real time, dom_real *theta)
{
    const struct domq_train train = wide_train(q);
    const struct domq_compute compute = wide_compute(q);
    domq_real wide;
    enum dom_status status = domq_cycle_tilt(&train, &compute, time, &wide);
    if (status == DOM_OK)
        *theta = (dom_real)wide;
    return status;
}

/* ---- Walks: the caller's callback gets structures in double ---- */

/* The caller's callback, which is one of these three, and its context. */
struct visitor {
    dom_visit *link;
    dom_state_visit *state;
    dom_force_visit *force;
    void *context;
};

static bool visit_link(const struct domq_link *wide, void *context)
{
    const struct visitor *v = context;
    struct dom_link link;
    narrow_link(&link, wide);
    return v->link(&link, v->context);
}

static bool visit_state(const struct domq_state *wide, const struct domq_event *wide_event, void *context)
{
    const struct visitor *v = context;
    struct dom_state state;
    struct dom_event event;
    narrow_state(&state, wide);
    if (wide_event)
        narrow_event(&event, wide_event);
    return v->state(&state, wide_event ? &event : NULL, v->context);
}

static bool visit_force(const struct domq_force *wide, void *context)
{
    const struct visitor *v = context;
    struct dom_force force;
    narrow_force(&force, wide);
    return v->force(&force, v->context);
}

static enum dom_status narrow_chain_walk(const struct request *q, dom_real theta, dom_visit *visit,
                                         void *context)
{
    const struct domq_train train = wide_train(q);
    const struct domq_compute compute = wide_compute(q);
    return domq_chain_walk(&train, &compute, theta, visit_link,
                           &(struct visitor){.link = visit, .context = context});
}

static enum dom_status narrow_cycle_walk(const struct request *q, size_t rows, enum dom_spacing by,
                                         dom_state_visit *visit, void *context)
{
    const struct domq_train train = wide_train(q);
    const struct domq_compute compute = wide_compute(q);
    return domq_cycle_walk(&train, &compute, rows, by, visit_state,
                           &(struct visitor){.state = visit, .context = context});
}

static enum dom_status narrow_cycle_forces(const struct request *q, dom_real theta, dom_force_visit *visit,
                                           void *context)
{
    const struct domq_train train = wide_train(q);
    const struct domq_compute compute = wide_compute(q);
    return domq_cycle_forces(&train, &compute, theta, visit_force,
                             &(struct visitor){.force = visit, .context = context});
}

static enum dom_status narrow_count_find(dom_real first, dom_real height, dom_real r,
                                         const struct dom_compute *compute, struct dom_count *count)
{
    const struct domq_compute settings = {.precision = compute->precision, .errors = compute->errors};
    struct domq_count wide;
    enum dom_status status = domq_count_find(first, height, r, &settings, &wide);
    if (status == DOM_OK)
        narrow_count(count, &wide);
    return status;
}

/* ---- The kernel ---- */

#define ENTRY(name, ...) .name = narrow_##name,
const struct kernel kernel_narrow = {KERNEL_FUNCTIONS(ENTRY)};
