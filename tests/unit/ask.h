/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The library in a form that is convenient for tests: one struct that holds both the train and how to
 * compute, and error bounds in a struct of the result's own type, so that tables of values and of bounds look
 * alike.
 */
#ifndef TEST_ASK_H
#define TEST_ASK_H

#include "domino_quad.h"
#include <string.h>

/* The members of the library's lists, and initialisers that copy them from *a. */
#define ASKED_NUMBER(name, default_, lowest, highest, unit, meaning)      domq_real name;
#define ASKED_EFFECT(effect, member, status)                              domq_real member;
#define ASKED_COPY_NUMBER(name, default_, lowest, highest, unit, meaning) .name = a->name,
#define ASKED_COPY_EFFECT(effect, member, status)                         .member = a->member,

/* A train and how to compute. */
struct asked {
    DOMQ_TRAIN_PARAMETERS(ASKED_NUMBER)
    DOMQ_COMPUTE_PARAMETERS(ASKED_NUMBER)
    DOM_DYNAMICS(ASKED_EFFECT)
    enum dom_precision precision;
    enum dom_fuel fuel;
    enum dom_method method;
    struct dom_work *work;
    const volatile sig_atomic_t *interrupt;
};

/* Returns the defaults, with every effect off. */
static inline struct asked asked_default(void)
{
    const struct domq_train train = domq_train_default(), *a = &train;
    const struct domq_compute compute = domq_compute_default();
    return (struct asked){.fuel = train.fuel,
                          .tol = compute.tol,
                          .precision = compute.precision,
                          .method = compute.method,
                          DOMQ_TRAIN_PARAMETERS(ASKED_COPY_NUMBER)};
}

static inline struct domq_train asked_train(const struct asked *a)
{
    return (struct domq_train){.fuel = a->fuel,
                               DOMQ_TRAIN_PARAMETERS(ASKED_COPY_NUMBER) DOM_DYNAMICS(ASKED_COPY_EFFECT)};
}

static inline struct domq_compute asked_compute(const struct asked *a, bool errors)
{
    return (struct domq_compute){.tol = a->tol,
                                 .precision = a->precision,
                                 .method = a->method,
                                 .errors = errors,
                                 .work = a->work,
                                 .interrupt = a->interrupt};
}

/* Copies the bounds of a result into a struct of its type, from the first member that has one; NULL:
 * nowhere. */
#define ASK_BOUNDS(result, copy, first)                                                                      \
    (void)((copy) ? memcpy(&(copy)->first, &(result)->error, sizeof(result)->error) : NULL)

/* Defines ask_NAME, which calls domq_NAME for a result and, unless error is NULL, for its bounds. */
#define ASK(name, type, first)                                                                               \
    static inline enum dom_status ask_##name(const struct asked *asked, struct domq_##type *result,          \
                                             struct domq_##type *error)                                      \
    {                                                                                                        \
        const struct domq_train train = asked_train(asked);                                                  \
        const struct domq_compute compute = asked_compute(asked, error);                                     \
        enum dom_status status = domq_##name(&train, &compute, result);                                      \
        ASK_BOUNDS(result, error, first);                                                                    \
        return status;                                                                                       \
    }

/* Defines ask_NAME for a function of one tilt. */
#define ASK_AT(name, type, first)                                                                            \
    static inline enum dom_status ask_##name(const struct asked *asked, domq_real theta,                     \
                                             struct domq_##type *result, struct domq_##type *error)          \
    {                                                                                                        \
        const struct domq_train train = asked_train(asked);                                                  \
        const struct domq_compute compute = asked_compute(asked, error);                                     \
        enum dom_status status = domq_##name(&train, &compute, theta, result);                               \
        ASK_BOUNDS(result, error, first);                                                                    \
        return status;                                                                                       \
    }

ASK(angles_find, angles, theta_c)
ASK(fuel_find, fuels, exact)
ASK(launch_find, launch, fuel)
ASK(barrier_find, barrier, theta_m)
ASK(limit_pair, limit, r_max)
ASK(limit_best, best, s)
ASK_AT(contact_find, contact, theta_1)
ASK_AT(energy_find, energy, dH)
ASK_AT(cycle_state, state, theta)

/* Finds r_max. *why, unless why is NULL, is written if there is no growth. */
static inline enum dom_status ask_limit_rmax(const struct asked *asked, struct domq_limit *limit,
                                             struct domq_limit *error, enum dom_status *why)
{
    const struct domq_train train = asked_train(asked);
    const struct domq_compute compute = asked_compute(asked, error);
    enum dom_status status = domq_limit_rmax(&train, &compute, limit);
    ASK_BOUNDS(limit, error, r_max);
    if (why && status == DOM_OK && limit->ends == DOM_END_NONE)
        *why = limit->why;
    return status;
}

static inline enum dom_status ask_train_check(const struct asked *asked)
{
    const struct domq_train train = asked_train(asked);
    const struct domq_compute compute = asked_compute(asked, false);
    return domq_train_check(&train, &compute);
}

/* ---- One number and its bound ---- */

static inline void ask_value(struct domq_value from, domq_real *value, domq_real *error)
{
    *value = from.value;
    if (error)
        *error = from.error;
}

static inline enum dom_status ask_cycle_omegasq(const struct asked *asked, domq_real theta,
                                                domq_real *omegasq, domq_real *error)
{
    struct domq_value value = {DOMQ_NAN, DOMQ_NAN};
    const struct domq_train train = asked_train(asked);
    const struct domq_compute compute = asked_compute(asked, error);
    enum dom_status status = domq_cycle_omegasq(&train, &compute, theta, &value);
    ask_value(value, omegasq, error);
    return status;
}

static inline enum dom_status ask_cycle_stop(const struct asked *asked, domq_real *theta, domq_real *error)
{
    struct domq_value value = {DOMQ_NAN, DOMQ_NAN};
    const struct domq_train train = asked_train(asked);
    const struct domq_compute compute = asked_compute(asked, error);
    enum dom_status status = domq_cycle_stop(&train, &compute, &value);
    ask_value(value, theta, error);
    return status;
}

static inline enum dom_status ask_cycle_duration(const struct asked *asked, domq_real *duration,
                                                 domq_real *error)
{
    struct domq_value value = {DOMQ_NAN, DOMQ_NAN};
    const struct domq_train train = asked_train(asked);
    const struct domq_compute compute = asked_compute(asked, error);
    enum dom_status status = domq_cycle_duration(&train, &compute, &value);
    ask_value(value, duration, error);
    return status;
}

/* ---- Without bounds ---- */

static inline enum dom_status ask_cycle_events(const struct asked *asked, struct domq_event *events,
                                               int *count)
{
    const struct domq_train train = asked_train(asked);
    const struct domq_compute compute = asked_compute(asked, false);
    return domq_cycle_events(&train, &compute, events, count);
}

static inline enum dom_status ask_cycle_tilt(const struct asked *asked, domq_real time, domq_real *theta)
{
    const struct domq_train train = asked_train(asked);
    const struct domq_compute compute = asked_compute(asked, false);
    return domq_cycle_tilt(&train, &compute, time, theta);
}

static inline enum dom_status ask_cycle_forces(const struct asked *asked, domq_real theta,
                                               domq_force_visit *visit, void *context)
{
    const struct domq_train train = asked_train(asked);
    const struct domq_compute compute = asked_compute(asked, false);
    return domq_cycle_forces(&train, &compute, theta, visit, context);
}

static inline enum dom_status ask_cycle_least_force(const struct asked *asked, struct domq_least_force *least)
{
    const struct domq_train train = asked_train(asked);
    const struct domq_compute compute = asked_compute(asked, false);
    return domq_cycle_least_force(&train, &compute, least);
}

static inline enum dom_status ask_cycle_floor(const struct asked *asked, struct domq_floor *floor)
{
    const struct domq_train train = asked_train(asked);
    const struct domq_compute compute = asked_compute(asked, false);
    return domq_cycle_floor(&train, &compute, floor);
}

static inline domq_real ask_scale_speed(const struct domq_scale *scale, const struct asked *asked,
                                        domq_real duration)
{
    const struct domq_train train = asked_train(asked);
    return domq_scale_speed(scale, &train, duration);
}

static inline enum dom_status ask_count_find(enum dom_precision precision, domq_real first, domq_real height,
                                             domq_real r, struct domq_count *count, struct domq_count *error)
{
    struct domq_compute compute = domq_compute_default();
    compute.precision = precision;
    compute.errors = error;
    enum dom_status status = domq_count_find(first, height, r, &compute, count);
    ASK_BOUNDS(count, error, exact);
    if (error)
        error->dominoes = 0; /* a whole number */
    return status;
}

/* ---- Walks: the visitor's error is NULL unless errors are asked for ---- */

typedef bool ask_visit(const struct domq_link *link, const struct domq_link *error, void *context);
typedef bool ask_state_visit(const struct domq_state *state, const struct domq_state *error,
                             const struct domq_event *event, void *context);

struct ask_walk {
    bool errors;
    ask_visit *visit;
    ask_state_visit *state_visit;
    void *context;
};

static inline bool ask_link_seen(const struct domq_link *link, void *context)
{
    const struct ask_walk *walk = context;
    struct domq_link bounds = {.i = link->i}, *error = walk->errors ? &bounds : NULL;
    ASK_BOUNDS(link, error, theta);
    return walk->visit(link, error, walk->context);
}

static inline bool ask_state_seen(const struct domq_state *state, const struct domq_event *event,
                                  void *context)
{
    const struct ask_walk *walk = context;
    struct domq_state bounds = {.theta = 0}, *error = walk->errors ? &bounds : NULL;
    ASK_BOUNDS(state, error, theta);
    return walk->state_visit(state, error, event, walk->context);
}

static inline enum dom_status ask_chain_walk(const struct asked *asked, domq_real theta, bool errors,
                                             ask_visit *visit, void *context)
{
    struct ask_walk walk = {.errors = errors, .visit = visit, .context = context};
    const struct domq_train train = asked_train(asked);
    const struct domq_compute compute = asked_compute(asked, errors);
    return domq_chain_walk(&train, &compute, theta, ask_link_seen, &walk);
}

static inline enum dom_status ask_cycle_walk(const struct asked *asked, size_t rows, enum dom_spacing by,
                                             bool errors, ask_state_visit *visit, void *context)
{
    struct ask_walk walk = {.errors = errors, .state_visit = visit, .context = context};
    const struct domq_train train = asked_train(asked);
    const struct domq_compute compute = asked_compute(asked, errors);
    return domq_cycle_walk(&train, &compute, rows, by, ask_state_seen, &walk);
}

/* ---- Rows ---- */

/* A row and how to compute. */
struct asked_row {
    const struct domq_domino *domino;
    size_t count;
    domq_real g, push;
    DOM_DYNAMICS(ASKED_EFFECT)
    bool floor;
    DOMQ_COMPUTE_PARAMETERS(ASKED_NUMBER)
    enum dom_precision precision;
    struct dom_work *work;
    const volatile sig_atomic_t *interrupt;
};

static inline struct domq_row asked_row(const struct asked_row *a)
{
    return (struct domq_row){.domino = a->domino,
                             .count = a->count,
                             .g = a->g,
                             .push = a->push,
                             .floor = a->floor,
                             DOM_DYNAMICS(ASKED_COPY_EFFECT)};
}

static inline struct domq_compute asked_row_compute(const struct asked_row *a)
{
    return (struct domq_compute){
        .tol = a->tol, .precision = a->precision, .work = a->work, .interrupt = a->interrupt};
}

static inline enum dom_status ask_row_run(const struct asked_row *asked, bool times, domq_fall_visit *visit,
                                          void *context, struct domq_verdict *verdict)
{
    const struct domq_row row = asked_row(asked);
    const struct domq_compute compute = asked_row_compute(asked);
    return domq_row_run(&row, &compute, times, visit, context, verdict);
}

static inline enum dom_status ask_row_rmax(const struct asked_row *asked, domq_real highest,
                                           domq_row_make *make, void *context, struct domq_row_growth *growth)
{
    const struct domq_row row = asked_row(asked);
    const struct domq_compute compute = asked_row_compute(asked);
    return domq_row_rmax(&row, &compute, highest, make, context, growth);
}

static inline enum dom_status ask_row_mend(const struct asked_row *asked, dom_progress *progress,
                                           void *context, struct domq_mend mends[DOM_MENDS], size_t *count)
{
    const struct domq_row row = asked_row(asked);
    const struct domq_compute compute = asked_row_compute(asked);
    return domq_row_mend(&row, &compute, progress, context, mends, count);
}

static inline enum dom_status ask_row_windows(const struct asked_row *asked, enum dom_window_of of,
                                              dom_progress *progress, void *context,
                                              struct domq_window *windows)
{
    const struct domq_row row = asked_row(asked);
    const struct domq_compute compute = asked_row_compute(asked);
    return domq_row_windows(&row, &compute, of, progress, context, windows);
}

static inline enum dom_status ask_row_push(const struct asked_row *asked, domq_real strongest,
                                           domq_real *push)
{
    const struct domq_row row = asked_row(asked);
    const struct domq_compute compute = asked_row_compute(asked);
    return domq_row_push(&row, &compute, strongest, push);
}

static inline void ask_row_of_train(const struct asked *asked, const struct domq_scale *scale, domq_real mass,
                                    struct domq_domino *domino, size_t count)
{
    const struct domq_train train = asked_train(asked);
    domq_row_of_train(&train, scale, mass, domino, count);
}

static inline enum dom_status ask_placement_study(const struct asked_row *asked,
                                                  const struct domq_placement *placement,
                                                  struct domq_study *study, size_t *stops)
{
    const struct domq_row row = asked_row(asked);
    const struct domq_compute compute = asked_row_compute(asked);
    return domq_placement_study(&row, &compute, placement, study, stops);
}

static inline enum dom_status ask_placement_budget(const struct asked_row *asked,
                                                   const struct domq_placement *placement, double probability,
                                                   struct domq_budget *budget)
{
    const struct domq_row row = asked_row(asked);
    const struct domq_compute compute = asked_row_compute(asked);
    return domq_placement_budget(&row, &compute, placement, probability, budget);
}

#endif
