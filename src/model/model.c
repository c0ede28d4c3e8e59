/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The library's doors: who asks for a precision or a method gets its kernel, and nobody else's. */
#include "dynamics/list.h"
#include "precision/kernel.h"

static enum dom_status range_check(const struct dom_train *train)
{
#define CHECK(name, default_, lowest, highest, unit, meaning)                                                \
    if (!(train->name >= (dom_real)(lowest) && train->name <= (dom_real)(highest)))                          \
        return DOM_BAD_PARAMETER;
    DOM_TRAIN_PARAMETERS(CHECK)
#undef CHECK
    if (train->precision > DOM_QUAD || train->method > DOM_METHOD_PAPER)
        return DOM_BAD_PARAMETER;
    if (dom_arithmetic(train->precision)->bits == 0)
        return DOM_NO_PRECISION;
    const struct dynamics_values values = dynamics_of_train(train);
    if (!dynamics_allowed(&values))
        return DOM_BAD_PARAMETER;
    return (double)train->tol < (double)dom_arithmetic(train->precision)->tol_floor ? DOM_BAD_PARAMETER
                                                                                    : DOM_OK;
}

static const struct kernel *const kernels[] = {
    [DOM_FLOAT] = &kernel_float, [DOM_DOUBLE] = &kernel_double, [DOM_QUAD] = &kernel_quad};

/* The kernel for a train; NULL with a status if there is none. */
static const struct kernel *kernel_of(const struct dom_train *train, enum dom_status *status)
{
    *status = range_check(train);
    if (*status != DOM_OK)
        return NULL;
    if (dom_dynamics(train) && train->method != DOM_METHOD_OURS) {
        *status = DOM_NO_METHOD;
        return NULL;
    }
    return train->method == DOM_METHOD_GSL     ? &kernel_gsl
           : train->method == DOM_METHOD_PAPER ? &kernel_paper
                                               : kernels[train->precision];
}

/* Calls the member of the train's kernel. */
#define ASK(train, member, ...)                                                                              \
    enum dom_status status;                                                                                  \
    const struct kernel *kernel = kernel_of(train, &status);                                                 \
    return !kernel ? status : !kernel->member ? DOM_NO_METHOD : kernel->member(__VA_ARGS__)

enum dom_status dom_train_check(const struct dom_train *train)
{
    struct dom_angles angles;
    return dom_angles_find(train, &angles, NULL);
}

enum dom_status dom_angles_find(const struct dom_train *train, struct dom_angles *angles,
                                struct dom_angles *error)
{
    ASK(train, angles_find, train, angles, error);
}

enum dom_status dom_contact_find(const struct dom_train *train, dom_real theta, struct dom_contact *contact,
                                 struct dom_contact *error)
{
    ASK(train, contact_find, train, theta, contact, error);
}

enum dom_status dom_chain_walk(const struct dom_train *train, dom_real theta, bool errors, dom_visit *visit,
                               void *context)
{
    ASK(train, chain_walk, train, theta, errors, visit, context);
}

enum dom_status dom_energy_find(const struct dom_train *train, dom_real theta, struct dom_energy *energy,
                                struct dom_energy *error)
{
    ASK(train, energy_find, train, theta, energy, error);
}

enum dom_status dom_fuel_find(const struct dom_train *train, struct dom_fuels *fuels, struct dom_fuels *error)
{
    ASK(train, fuel_find, train, fuels, error);
}

enum dom_status dom_launch_find(const struct dom_train *train, struct dom_launch *launch,
                                struct dom_launch *error)
{
    ASK(train, launch_find, train, launch, error);
}

enum dom_status dom_barrier_find(const struct dom_train *train, struct dom_barrier *barrier,
                                 struct dom_barrier *error)
{
    ASK(train, barrier_find, train, barrier, error);
}

enum dom_status dom_cycle_omegasq(const struct dom_train *train, dom_real theta, dom_real *omegasq,
                                  dom_real *error)
{
    *omegasq = DOM_NAN;
    ASK(train, cycle_omegasq, train, theta, omegasq, error);
}

enum dom_status dom_cycle_stop(const struct dom_train *train, dom_real *theta, dom_real *error)
{
    ASK(train, cycle_stop, train, theta, error);
}

enum dom_status dom_cycle_duration(const struct dom_train *train, dom_real *duration, dom_real *error)
{
    ASK(train, cycle_duration, train, duration, error);
}

enum dom_status dom_cycle_events(const struct dom_train *train, struct dom_event *events, int *count)
{
    *count = 0;
    ASK(train, cycle_events, train, events, count);
}

enum dom_status dom_cycle_state(const struct dom_train *train, dom_real theta, struct dom_state *state,
                                struct dom_state *error)
{
    ASK(train, cycle_state, train, theta, state, error);
}

enum dom_status dom_cycle_tilt(const struct dom_train *train, dom_real time, dom_real *theta)
{
    ASK(train, cycle_tilt, train, time, theta);
}

enum dom_status dom_cycle_walk(const struct dom_train *train, size_t rows, enum dom_spacing by, bool errors,
                               dom_state_visit *visit, void *context)
{
    ASK(train, cycle_walk, train, rows, by, errors, visit, context);
}

enum dom_status dom_cycle_forces(const struct dom_train *train, dom_real theta, dom_force_visit *visit,
                                 void *context)
{
    ASK(train, cycle_forces, train, theta, visit, context);
}

enum dom_status dom_cycle_least_force(const struct dom_train *train, struct dom_least_force *least)
{
    ASK(train, cycle_least_force, train, least);
}

enum dom_status dom_cycle_floor(const struct dom_train *train, struct dom_floor *floor)
{
    ASK(train, cycle_floor, train, floor);
}

/* The limits have r of their own: the train's may be anything. */
static struct dom_train without_r(const struct dom_train *train)
{
    struct dom_train t = *train;
    t.r = 1;
    return t;
}

enum dom_status dom_limit_rmax(const struct dom_train *train, struct dom_limit *limit,
                               struct dom_limit *error, enum dom_status *why)
{
    struct dom_train t = without_r(train);
    ASK(&t, limit_rmax, &t, limit, error, why);
}

enum dom_status dom_limit_pair(const struct dom_train *train, struct dom_limit *limit,
                               struct dom_limit *error)
{
    struct dom_train t = without_r(train);
    ASK(&t, limit_pair, &t, limit, error);
}

enum dom_status dom_limit_best(const struct dom_train *train, struct dom_best *best, struct dom_best *error)
{
    struct dom_train t = without_r(train);
    t.s = 1;
    ASK(&t, limit_best, &t, best, error);
}

enum dom_status dom_row_run(const struct dom_row *row, bool times, dom_fall_visit *visit, void *context,
                            struct dom_verdict *verdict)
{
    if (row->precision > DOM_QUAD)
        return DOM_BAD_PARAMETER;
    return dom_arithmetic(row->precision)->bits
               ? kernels[row->precision]->row_run(row, times, visit, context, verdict)
               : DOM_NO_PRECISION;
}

enum dom_status dom_count_find(enum dom_precision precision, dom_real first, dom_real height, dom_real r,
                               struct dom_count *count, struct dom_count *error)
{
    if (precision > DOM_QUAD)
        return DOM_BAD_PARAMETER;
    return dom_arithmetic(precision)->bits ? kernels[precision]->count_find(first, height, r, count, error)
                                           : DOM_NO_PRECISION;
}
