/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Public entry points: check the arguments, then call the kernel of the requested precision or method. */
#include "dispatch/dispatch.h"
#include "effects/effects.h"

/* Makes a question about a limit of growth. The search chooses r, so train->r need not be valid. */
static struct question question_of_limit(const struct dom_train *train, const struct dom_compute *compute)
{
    struct dom_train t = *train;
    t.r = 1;
    return question_make(&t, compute);
}

enum dom_status dom_train_check(const struct dom_train *train, const struct dom_compute *compute)
{
    struct dom_angles angles;
    struct question q = question_make(train, compute);
    return ASK(q, angles_find, &angles);
}

enum dom_status dom_angles_find(const struct dom_train *train, const struct dom_compute *compute,
                                struct dom_angles *angles)
{
    struct question q = question_make(train, compute);
    return ASK(q, angles_find, angles);
}

enum dom_status dom_contact_find(const struct dom_train *train, const struct dom_compute *compute,
                                 dom_real theta, struct dom_contact *contact)
{
    struct question q = question_make(train, compute);
    return ASK(q, contact_find, theta, contact);
}

enum dom_status dom_chain_walk(const struct dom_train *train, const struct dom_compute *compute,
                               dom_real theta, dom_visit *visit, void *context)
{
    struct question q = question_make(train, compute);
    return ASK(q, chain_walk, theta, visit, context);
}

enum dom_status dom_energy_find(const struct dom_train *train, const struct dom_compute *compute,
                                dom_real theta, struct dom_energy *energy)
{
    struct question q = question_make(train, compute);
    return ASK(q, energy_find, theta, energy);
}

enum dom_status dom_fuel_find(const struct dom_train *train, const struct dom_compute *compute,
                              struct dom_fuels *fuels)
{
    struct question q = question_make(train, compute);
    return ASK(q, fuel_find, fuels);
}

enum dom_status dom_launch_find(const struct dom_train *train, const struct dom_compute *compute,
                                struct dom_launch *launch)
{
    struct question q = question_make(train, compute);
    return ASK(q, launch_find, launch);
}

enum dom_status dom_barrier_find(const struct dom_train *train, const struct dom_compute *compute,
                                 struct dom_barrier *barrier)
{
    struct question q = question_make(train, compute);
    return ASK(q, barrier_find, barrier);
}

enum dom_status dom_cycle_omegasq(const struct dom_train *train, const struct dom_compute *compute,
                                  dom_real theta, dom_real *omegasq)
{
    struct question q = question_make(train, compute);
    *omegasq = DOM_NAN;
    return ASK(q, cycle_omegasq, theta, omegasq);
}

enum dom_status dom_cycle_stop(const struct dom_train *train, const struct dom_compute *compute,
                               dom_real *theta)
{
    struct question q = question_make(train, compute);
    return ASK(q, cycle_stop, theta);
}

enum dom_status dom_cycle_duration(const struct dom_train *train, const struct dom_compute *compute,
                                   dom_real *duration)
{
    struct question q = question_make(train, compute);
    return ASK(q, cycle_duration, duration);
}

enum dom_status dom_cycle_events(const struct dom_train *train, const struct dom_compute *compute,
                                 struct dom_event *events, int *count)
{
    *count = 0;
    struct question q = question_make(train, compute);
    return ASK(q, cycle_events, events, count);
}

enum dom_status dom_cycle_state(const struct dom_train *train, const struct dom_compute *compute,
                                dom_real theta, struct dom_state *state)
{
    struct question q = question_make(train, compute);
    return ASK(q, cycle_state, theta, state);
}

enum dom_status dom_cycle_tilt(const struct dom_train *train, const struct dom_compute *compute,
                               dom_real time, dom_real *theta)
{
    struct question q = question_make(train, compute);
    return ASK(q, cycle_tilt, time, theta);
}

enum dom_status dom_cycle_walk(const struct dom_train *train, const struct dom_compute *compute, size_t count,
                               enum dom_spacing by, dom_state_visit *visit, void *context)
{
    struct question q = question_make(train, compute);
    return ASK(q, cycle_walk, count, by, visit, context);
}

enum dom_status dom_cycle_forces(const struct dom_train *train, const struct dom_compute *compute,
                                 dom_real theta, dom_force_visit *visit, void *context)
{
    struct question q = question_make(train, compute);
    return ASK(q, cycle_forces, theta, visit, context);
}

enum dom_status dom_cycle_least_force(const struct dom_train *train, const struct dom_compute *compute,
                                      struct dom_least_force *least)
{
    struct question q = question_make(train, compute);
    return ASK(q, cycle_least_force, least);
}

enum dom_status dom_cycle_floor(const struct dom_train *train, const struct dom_compute *compute,
                                struct dom_floor *floor)
{
    struct question q = question_make(train, compute);
    return ASK(q, cycle_floor, floor);
}

/* Makes the request for the double kernel from which a search in the quad kernel starts. Returns false if the
 * question is invalid or does not go to the quad kernel. */
static bool coarse_first(const struct question *q, struct request *coarse)
{
    *coarse = q->request;
    coarse->precision = DOM_DOUBLE;
    coarse->tol = dom_arithmetic(DOM_DOUBLE)->tol_floor;
    return q->status == DOM_OK && q->request.precision == DOM_QUAD && q->request.method == DOM_METHOD_OURS;
}

/* Asks the same question in quad, about the train whose parameters are rounded to the precision of `q`. */
static struct question question_in_quad(const struct question *q)
{
    struct question fine = *q;
    struct request *f = &fine.request;
#define ROUND(x)                   ((x) = q->request.precision == DOM_FLOAT ? (dom_real)(float)(x) : (dom_real)(double)(x))
#define ROUND_PARAMETER(name, ...) ROUND(f->name);
    DOM_TRAIN_PARAMETERS(ROUND_PARAMETER)
    for (int k = 0; k < DOM_DYNAMICS_COUNT; k++)
        ROUND(f->effect[k]);
#undef ROUND_PARAMETER
#undef ROUND
    f->precision = DOM_QUAD;
    f->near = 0;
    fine.kernel = kernels[DOM_QUAD];
    return fine;
}

typedef enum dom_status find_limit(const struct request *request, struct dom_limit *limit);

/* Finds a limit. An open answer is computed again in quad, where fewer minima of the margin are open. */
static enum dom_status limit_ask(const struct question *q, find_limit *(*find)(const struct kernel *),
                                 struct dom_limit *limit)
{
    if (q->status != DOM_OK)
        return q->status;
    find_limit *of = find(q->kernel);
    enum dom_status status = of ? of(&q->request, limit) : DOM_NO_METHOD;
    if (status == DOM_OPEN && q->request.precision != DOM_QUAD && dom_arithmetic(DOM_QUAD)->bits > 0) {
        struct question fine = question_in_quad(q);
        struct dom_limit again;
        const enum dom_status in_quad = find(fine.kernel)(&fine.request, &again);
        if (in_quad == DOM_OK || in_quad == DOM_OPEN)
            *limit = again;
        status = in_quad == DOM_OK || in_quad == DOM_INTERRUPTED ? in_quad : status;
    }
    return status;
}

static find_limit *kernel_rmax(const struct kernel *kernel)
{
    return kernel->limit_rmax;
}

static find_limit *kernel_pair(const struct kernel *kernel)
{
    return kernel->limit_pair;
}

enum dom_status dom_limit_rmax(const struct dom_train *train, const struct dom_compute *compute,
                               struct dom_limit *limit)
{
    struct question q = question_of_limit(train, compute);
    struct request coarse;
    struct dom_limit near;
    if (coarse_first(&q, &coarse) && kernels[DOM_DOUBLE]->limit_rmax(&coarse, &near) == DOM_OK &&
        near.ends == DOM_END_BARRIER && near.r_max > 1)
        q.request.near = near.r_max;
    return limit_ask(&q, kernel_rmax, limit);
}

enum dom_status dom_limit_pair(const struct dom_train *train, const struct dom_compute *compute,
                               struct dom_limit *limit)
{
    struct question q = question_of_limit(train, compute);
    return limit_ask(&q, kernel_pair, limit);
}

enum dom_status dom_limit_best(const struct dom_train *train, const struct dom_compute *compute,
                               struct dom_best *best)
{
    struct dom_train anywhere = *train;
    anywhere.s = 1;
    struct question q = question_of_limit(&anywhere, compute);
    struct request coarse;
    struct dom_best near;
    if (coarse_first(&q, &coarse) && kernels[DOM_DOUBLE]->limit_best(&coarse, &near) == DOM_OK) {
        q.request.s = near.s;
        q.request.near = near.r_max;
    }
    return ASK(q, limit_best, best);
}

enum dom_status dom_row_run(const struct dom_row *row, const struct dom_compute *compute, bool times,
                            dom_fall_visit *visit, void *context, struct dom_verdict *verdict)
{
    return row_verdict(row, compute, times, visit, context, verdict);
}

static bool tilt_seen(const struct dom_fall *fall, void *context)
{
    *(dom_real *)context = fall->theta;
    return false;
}

enum dom_status dom_row_touch(const struct dom_row *row, const struct dom_compute *compute, dom_real *tilt)
{
    struct dom_verdict verdict;
    struct dom_row two = *row;
    two.count = row->count < 2 ? row->count : 2;
    two.engine = NULL;
    two.floor = false;
    two.push = 0;
    two.release = (dom_real)HUGE_VAL;
    return row_verdict(&two, compute, false, tilt_seen, tilt, &verdict);
}

enum dom_status dom_row_watch(const struct dom_row *row, const struct dom_compute *compute,
                              const dom_real *times, size_t count, dom_moment_visit *visit, void *context,
                              struct dom_verdict *verdict)
{
    struct row_question q = row_question_make(row, compute);
    return row->engine ? DOM_NO_METHOD : ASK(q, row_watch, times, count, visit, context, verdict);
}

enum dom_status dom_count_find(dom_real first, dom_real height, dom_real r, const struct dom_compute *given,
                               struct dom_count *count)
{
    struct dom_compute compute = compute_or_default(given);
    enum dom_status status = precision_check(compute.precision);
    return status == DOM_OK ? kernels[compute.precision]->count_find(first, height, r, &compute, count)
                            : status;
}

/* ---- Simple API ---- */

dom_real dom_rmax(dom_real s, dom_real d, dom_real q)
{
    struct dom_train train = dom_train_default();
    struct dom_limit limit;
    train.s = s;
    train.d = d;
    train.q = q;
    return dom_limit_rmax(&train, NULL, &limit) == DOM_OK ? limit.r_max : DOM_NAN;
}

dom_real dom_dominoes(dom_real first, dom_real height, dom_real r)
{
    struct dom_count count;
    return dom_count_find(first, height, r, NULL, &count) == DOM_OK ? count.dominoes : DOM_NAN;
}

dom_real dom_speed(dom_real h, dom_real s, dom_real d)
{
    struct dom_train train = dom_train_default();
    struct dom_scale scale = dom_scale_default();
    dom_real duration;
    train.s = s;
    train.d = d;
    train.r = 1;
    scale.h = h;
    return h > 0 && dom_cycle_duration(&train, NULL, &duration) == DOM_OK
               ? dom_scale_speed(&scale, &train, duration)
               : DOM_NAN;
}
