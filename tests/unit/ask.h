/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The library in a form that is convenient for tests: one structure holds both the train and how to compute,
 * and error bounds are in a structure of the same type as the result, so that tests treat values and bounds
 * alike.
 */
#ifndef TEST_ASK_H
#define TEST_ASK_H

#include "domino_study.h"
#include "shell/precision/any.h"
#include <string.h>

/* Define the members in the library's lists of parameters, and initializers that copy these members from
 * *a. */
#define SETUP_NUMBER(name, default_, lowest, highest, unit, meaning)      domq_real name;
#define SETUP_EFFECT(effect, member, status)                              domq_real member;
#define SETUP_COPY_NUMBER(name, default_, lowest, highest, unit, meaning) .name = a->name,
#define SETUP_COPY_EFFECT(effect, member, status)                         .member = a->member,

/* A train and how to compute. */
struct setup {
    DOMQ_TRAIN_PARAMETERS(SETUP_NUMBER)
    DOMQ_COMPUTE_PARAMETERS(SETUP_NUMBER)
    DOM_DYNAMICS(SETUP_EFFECT)
    enum precision precision;
    enum dom_fuel fuel;
    struct dom_work *work;
    const volatile sig_atomic_t *interrupt;
};

/* Returns a number as a precision has it. */
static inline domq_real rounded_to(enum precision precision, domq_real x)
{
    return precision == IN_FLOAT ? (domq_real)(float)x : precision == IN_DOUBLE ? (domq_real)(double)x : x;
}

/* Returns the defaults, with every effect off. */
static inline struct setup setup_default(void)
{
    const struct domq_train train = domq_train_default(), *a = &train;
    const struct any_compute compute = any_compute_default();
    return (struct setup){.fuel = train.fuel,
                          .tol = compute.tol,
                          .precision = compute.precision,
                          DOMQ_TRAIN_PARAMETERS(SETUP_COPY_NUMBER)};
}

static inline struct domq_train setup_train(const struct setup *a)
{
    return (struct domq_train){.fuel = a->fuel,
                               DOMQ_TRAIN_PARAMETERS(SETUP_COPY_NUMBER) DOM_DYNAMICS(SETUP_COPY_EFFECT)};
}

static inline struct any_compute setup_compute(const struct setup *a)
{
    return (struct any_compute){
        .tol = a->tol, .precision = a->precision, .work = a->work, .interrupt = a->interrupt};
}

/* The first two arguments of a call of the library: the train and how to compute. */
#define ASKED(a)                                                                                             \
    (const struct domq_train[]){setup_train(a)}, (const struct any_compute[])                                \
    {                                                                                                        \
        setup_compute(a)                                                                                     \
    }

/* Defines ask_NAME, which calls any_NAME. */
#define ASK(name, type, PARAMETER, ARGUMENT)                                                                 \
    static inline enum dom_status ask_##name(const struct setup *setup,                                      \
                                             PARAMETER struct domq_##type *result)                           \
    {                                                                                                        \
        return any_##name(ASKED(setup), ARGUMENT result);                                                    \
    }

/* Defines ask_NAME for a function whose result is one number, which is NaN if there is no result. */
#define ASK_NUMBER(name, PARAMETER, ARGUMENT)                                                                \
    static inline enum dom_status ask_##name(const struct setup *setup, PARAMETER domq_real *number)         \
    {                                                                                                        \
        *number = DOMQ_NAN;                                                                                  \
        return any_##name(ASKED(setup), ARGUMENT number);                                                    \
    }

#define ASK_AT_PARAMETER domq_real theta,
#define ASK_AT_ARGUMENT  theta,

/* clang-format off: these macros do not look like functions. */
ASK(angles_find, angles, , )
ASK(contact_find, contact, ASK_AT_PARAMETER, ASK_AT_ARGUMENT)
ASK(energy_find, energy, ASK_AT_PARAMETER, ASK_AT_ARGUMENT)
ASK(fuel_find, fuels, , )
ASK(launch_find, launch, , )
ASK(barrier_find, barrier, , )
ASK(cycle_state, state, ASK_AT_PARAMETER, ASK_AT_ARGUMENT)
ASK(limit_rmax, limit, , )
ASK(limit_pair, limit, , )
ASK(limit_best, best, , )
ASK_NUMBER(cycle_omegasq, ASK_AT_PARAMETER, ASK_AT_ARGUMENT)
ASK_NUMBER(cycle_duration, , )
/* clang-format on */

/* Finds where a train comes to rest: NaN if it keeps falling. */
static inline enum dom_status ask_cycle_stop(const struct setup *setup, domq_real *theta)
{
    struct domq_barrier barrier = {.stop = DOMQ_NAN};
    const enum dom_status status = ask_barrier_find(setup, &barrier);
    *theta = barrier.stop;
    return status == DOM_STOPS ? DOM_OK : status;
}

/* Checks a train. */
static inline enum dom_status ask_check(const struct setup *setup)
{
    struct domq_angles angles;
    return ask_angles_find(setup, &angles);
}

/* Functions with several results, and walks along a chain or a cycle. */
#define ask_cycle_events(a, ...)      any_cycle_events(ASKED(a), __VA_ARGS__)
#define ask_cycle_least_force(a, ...) any_cycle_least_force(ASKED(a), __VA_ARGS__)
#define ask_chain_walk(a, ...)        any_chain_walk(ASKED(a), __VA_ARGS__)
#define ask_cycle_walk(a, ...)        any_cycle_walk(ASKED(a), __VA_ARGS__)
#define ask_row_of_train(a, ...)      domq_row_of_train((const struct domq_train[]){setup_train(a)}, __VA_ARGS__)

static inline domq_real ask_scale_speed(const struct domq_scale *scale, const struct setup *setup,
                                        domq_real duration)
{
    const struct domq_train train = setup_train(setup);
    return domq_scale_speed(scale, &train, duration);
}

static inline enum dom_status ask_count_find(enum precision precision, domq_real first, domq_real height,
                                             domq_real r, struct domq_count *count)
{
    struct any_compute compute = any_compute_default();
    compute.precision = precision;
    return any_count_find(first, height, r, &compute, count);
}

/* What exists in double only. */
#define ASKED_IN_DOUBLE(a)                                                                                   \
    (const struct dom_train[]){train_in_double((const struct domq_train[]){setup_train(a)})},                \
        (const struct dom_compute[])                                                                         \
    {                                                                                                        \
        compute_in_double((const struct any_compute[]){setup_compute(a)})                                    \
    }
#define ask_cycle_forces(a, ...) dom_cycle_forces(ASKED_IN_DOUBLE(a), __VA_ARGS__)
#define ask_cycle_floor(a, ...)  dom_cycle_floor(ASKED_IN_DOUBLE(a), __VA_ARGS__)

/* ---- Rows ---- */

/* A row and how to compute. */
struct row_setup {
    const struct domq_domino *domino;
    size_t count;
    domq_real g, push, release;
    DOM_DYNAMICS(SETUP_EFFECT)
    domq_real boxes_above; /* as in struct domq_row */
    DOMQ_COMPUTE_PARAMETERS(SETUP_NUMBER)
    enum precision precision;
    struct dom_work *work;
    const volatile sig_atomic_t *interrupt;
};

/* Returns a row on a level floor, in double, with every effect off. */
static inline struct row_setup row_setup_default(const struct domq_domino *domino, size_t count,
                                                 domq_real push)
{
    return (struct row_setup){
        .domino = domino, .count = count, .g = 9.81, .push = push, .tol = 1e-12, .precision = IN_DOUBLE};
}

static inline struct domq_row row_setup(const struct row_setup *a)
{
    return (struct domq_row){.domino = a->domino,
                             .count = a->count,
                             .g = a->g,
                             .push = a->push,
                             .release = a->release,
                             .boxes_above = a->boxes_above,
                             DOM_DYNAMICS(SETUP_COPY_EFFECT)};
}

static inline struct any_compute row_setup_compute(const struct row_setup *a)
{
    return (struct any_compute){
        .tol = a->tol, .precision = a->precision, .work = a->work, .interrupt = a->interrupt};
}

#define ROW_SETUP(a)                                                                                         \
    (const struct domq_row[]){row_setup(a)}, (const struct any_compute[])                                    \
    {                                                                                                        \
        row_setup_compute(a)                                                                                 \
    }

#define ask_row_run(a, ...) any_row_run(ROW_SETUP(a), __VA_ARGS__)

/* The same row in double, for searches and studies. The dominoes stay until the next call. */
static inline struct dom_row row_setup_in_double(const struct row_setup *a)
{
    enum { MOST_IN_DOUBLE = 4096 };
    static struct dom_domino domino[MOST_IN_DOUBLE];
    for (size_t k = 0; a->domino && k < a->count && k < MOST_IN_DOUBLE; k++) {
        const struct domq_domino *d = &a->domino[k];
        domino[k] =
            (struct dom_domino){(double)d->height, (double)d->thickness, (double)d->gap,  (double)d->mass,
                                (double)d->radius, (double)d->lean,      (double)d->width};
    }
#define SETUP_NARROW(effect, member, status) .member = (double)a->member,
    return (struct dom_row){.domino = domino,
                            .count = a->count,
                            .g = (double)a->g,
                            .push = (double)a->push,
                            .release = (double)a->release,
                            .boxes_above = (double)a->boxes_above,
                            DOM_DYNAMICS(SETUP_NARROW)};
#undef SETUP_NARROW
}

static inline struct dom_compute row_setup_compute_in_double(const struct row_setup *a)
{
    return (struct dom_compute){.tol = (double)a->tol, .work = a->work, .interrupt = a->interrupt};
}

#define ROW_SETUP_IN_DOUBLE(a)                                                                               \
    (const struct dom_row[]){row_setup_in_double(a)}, (const struct dom_compute[])                           \
    {                                                                                                        \
        row_setup_compute_in_double(a)                                                                       \
    }

#define ask_row_watch(a, ...)        dom_row_watch(ROW_SETUP_IN_DOUBLE(a), __VA_ARGS__)
#define ask_row_floor(a, ...)        dom_row_floor(ROW_SETUP_IN_DOUBLE(a), __VA_ARGS__)
#define ask_row_windows(a, ...)      dom_row_windows(ROW_SETUP_IN_DOUBLE(a), __VA_ARGS__)
#define ask_row_weakest_push(a, ...) dom_row_weakest_push(ROW_SETUP_IN_DOUBLE(a), __VA_ARGS__)
#define ask_placement_study(a, ...)  dom_placement_study(ROW_SETUP_IN_DOUBLE(a), __VA_ARGS__)
#define ask_placement_budget(a, ...) dom_placement_budget(ROW_SETUP_IN_DOUBLE(a), __VA_ARGS__)

#endif
