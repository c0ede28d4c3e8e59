/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Public entry points: check the arguments, then call the function that answers. */
#include "entry/other.h" /* first */

#include "effects/effects.h"
#include "entry/answers.h"
#include "entry/study.h"

/* A question about a train. */
struct question {
    struct request request;
    enum dom_status status;
};

/* Asks a question: calls the function that answers, unless the question has an error. The value of the macro
 * is the status. */
#define ASK(question, find, ...)                                                                             \
    ((question).status != DOM_OK ? (question).status : find(&(question).request, __VA_ARGS__))

/* The statuses for values outside the ranges in DOM_TRAIN_PARAMETERS and DOM_COMPUTE_PARAMETERS. */
#define BAD_s     DOM_BAD_S
#define BAD_r     DOM_BAD_R
#define BAD_d     DOM_BAD_D
#define BAD_q     DOM_BAD_Q
#define BAD_width DOM_BAD_WIDTH
#define BAD_tol   DOM_BAD_TOL

/* Sets `status` to an error if the parameter is outside its range and no earlier check failed. */
#define CHECK(name, default_, lowest, highest, unit, meaning)                                                \
    if (status == DOM_OK && !(q->name >= (dom_real)(lowest) && q->name <= (dom_real)(highest)))              \
        status = BAD_##name;

/* Returns true if a member is set that this version of the library does not have. */
#define IS_NEWER(given)                                                                                      \
    ((given)->later[0] != 0 || (given)->later[1] != 0 || (given)->later[2] != 0 || (given)->later[3] != 0)
_Static_assert(DOM_LATER == 4, "IS_NEWER");

static enum dom_status request_check(const struct request *q)
{
    enum dom_status status = DOM_OK;
    DOM_TRAIN_PARAMETERS(CHECK)
    if (status == DOM_OK)
        status = dynamics_check(q->effect);
    if (status == DOM_OK && q->fuel > DOM_FUEL_PAPER)
        status = DOM_BAD_FUEL;
    if (status == DOM_OK && dom_arithmetic()->bits == 0)
        status = DOM_NO_PRECISION;
    DOM_COMPUTE_PARAMETERS(CHECK)
    if (status == DOM_OK && q->tol < dom_arithmetic()->tol_floor)
        status = DOM_BAD_TOL;
    return status;
}
#undef CHECK

/* DOM_DYNAMICS(TRAIN_VALUE) and DOM_DYNAMICS(ROW_VALUE) list the values of all effects. */
#define TRAIN_VALUE(effect, member, status) train->member,
#define ROW_VALUE(effect, member, status)   row->member,

static struct question question_make(const struct dom_train *train, const struct dom_compute *given)
{
    struct dom_compute compute = compute_or_default(given);
#define COPY(name, default_, lowest, highest, unit, meaning)         .name = train->name,
#define COPY_COMPUTE(name, default_, lowest, highest, unit, meaning) .name = compute.name,
    struct question q = {
        .request = {DOM_TRAIN_PARAMETERS(COPY) DOM_COMPUTE_PARAMETERS(COPY_COMPUTE).fuel = train->fuel,
                    .effect = {DOM_DYNAMICS(TRAIN_VALUE)}, .work = compute.work,
                    .interrupt = compute.interrupt}};
#undef COPY
#undef COPY_COMPUTE
    q.status = IS_NEWER(train) || IS_NEWER(&compute) ? DOM_NEWER : request_check(&q.request);
    return q;
}

KERNEL_SHARED enum dom_status row_request_of(const struct dom_row *row, const struct dom_compute *given,
                                             struct row_request *request)
{
    const struct dom_compute compute = compute_or_default(given);
    *request = (struct row_request){.domino = row->domino,
                                    .count = row->count,
                                    .g = row->g,
                                    .push = row->push,
                                    .release = row->release,
                                    .effect = {DOM_DYNAMICS(ROW_VALUE)},
                                    .boxes_above = row->boxes_above,
                                    .floor = row->floor,
                                    .tol = compute.tol,
                                    .work = compute.work,
                                    .interrupt = compute.interrupt};
    return dom_arithmetic()->bits == 0           ? DOM_NO_PRECISION
           : IS_NEWER(row) || IS_NEWER(&compute) ? DOM_NEWER
                                                 : DOM_OK;
}

/* Makes a question about a limit of growth. The search chooses r, so train->r need not be valid. */
static struct question question_of_limit(const struct dom_train *train, const struct dom_compute *compute)
{
    struct dom_train t = *train;
    t.r = 1;
    return question_make(&t, compute);
}

/* Define public functions that answer a question about a train, or about a train at a tilt or a time. */
#define ANSWER(find, structure)                                                                              \
    enum dom_status dom_##find(const struct dom_train *train, const struct dom_compute *compute,             \
                               structure *found)                                                             \
    {                                                                                                        \
        struct question q = question_make(train, compute);                                                   \
        return ASK(q, find, found);                                                                          \
    }
#define ANSWER_AT(find, structure)                                                                           \
    enum dom_status dom_##find(const struct dom_train *train, const struct dom_compute *compute,             \
                               dom_real at, structure *found)                                                \
    {                                                                                                        \
        struct question q = question_make(train, compute);                                                   \
        return ASK(q, find, at, found);                                                                      \
    }
ANSWER(angles_find, struct dom_angles)
ANSWER(fuel_find, struct dom_fuels)
ANSWER(launch_find, struct dom_launch)
ANSWER(barrier_find, struct dom_barrier)
ANSWER(cycle_duration, dom_real)
ANSWER(cycle_least_force, struct dom_least_force)
ANSWER(cycle_floor, struct dom_floor)
ANSWER_AT(contact_find, struct dom_contact)
ANSWER_AT(energy_find, struct dom_energy)
ANSWER_AT(cycle_state, struct dom_state)

enum dom_status dom_cycle_omegasq(const struct dom_train *train, const struct dom_compute *compute,
                                  dom_real theta, dom_real *omegasq)
{
    struct question q = question_make(train, compute);
    *omegasq = DOM_NAN;
    return ASK(q, cycle_omegasq, theta, omegasq);
}

enum dom_status dom_chain_walk(const struct dom_train *train, const struct dom_compute *compute,
                               dom_real theta, dom_visit *visit, void *context)
{
    struct question q = question_make(train, compute);
    return ASK(q, chain_walk, theta, visit, context);
}

enum dom_status dom_cycle_events(const struct dom_train *train, const struct dom_compute *compute,
                                 struct dom_event *events, int *count)
{
    struct question q = question_make(train, compute);
    *count = 0;
    return ASK(q, cycle_events, events, count);
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

/* ---- Limits, which more than one precision may find ---- */

enum dom_status OWN(_limit_alone)(const struct dom_train *train, const struct dom_compute *compute, bool pair,
                                  dom_real near, struct dom_limit *limit)
{
    struct question q = question_of_limit(train, compute);
    q.request.near = near;
    return pair ? ASK(q, limit_pair, limit) : ASK(q, limit_rmax, limit);
}

/* Finds a limit. In quad, a search for r_max starts from that in double. A limit that is open in float or
 * double is computed again in quad, where fewer minima of the margin are open. */
static enum dom_status limit_of(const struct dom_train *train, const struct dom_compute *given, bool pair,
                                struct dom_limit *limit)
{
    const struct dom_compute compute = compute_or_default(given);
#ifdef DOMQ
    return OWN(_limit_alone)(train, &compute, pair, pair ? 0 : near_rmax(train, &compute), limit);
#else
    const enum dom_status status = OWN(_limit_alone)(train, &compute, pair, 0, limit);
    const enum dom_status then = status == DOM_OPEN ? limit_in_quad(train, &compute, pair, limit) : DOM_OPEN;
    return then == DOM_OK || then == DOM_INTERRUPTED ? then : status;
#endif
}

enum dom_status dom_limit_rmax(const struct dom_train *train, const struct dom_compute *compute,
                               struct dom_limit *limit)
{
    return limit_of(train, compute, false, limit);
}

enum dom_status dom_limit_pair(const struct dom_train *train, const struct dom_compute *compute,
                               struct dom_limit *limit)
{
    return limit_of(train, compute, true, limit);
}

enum dom_status dom_limit_best(const struct dom_train *train, const struct dom_compute *given,
                               struct dom_best *best)
{
    struct dom_train anywhere = *train;
    anywhere.s = 1;
    struct question q = question_of_limit(&anywhere, given);
#ifdef DOMQ
    const struct dom_compute compute = compute_or_default(given);
    if (q.status == DOM_OK && !near_best(&anywhere, &compute, &q.request.s, &q.request.near))
        q.request.near = 0;
#endif
    return ASK(q, limit_best, best);
}

/* ---- Rows and counts ---- */

enum dom_status dom_row_run(const struct dom_row *row, const struct dom_compute *given, bool times,
                            dom_fall_visit *visit, void *context, struct dom_verdict *verdict)
{
    struct row_request request;
    enum dom_status status = row_request_of(row, given, &request);
    if (status != DOM_OK || !row->engine)
        return status == DOM_OK ? row_run(&request, times, visit, context, verdict) : status;
#if defined DOMF || defined DOMQ
    return DOM_NO_METHOD;
#else
    const struct dom_compute compute = compute_or_default(given);
    for (size_t k = 0; k < row->count; k++)
        if (row->domino[k].lean != 0)
            return DOM_NO_LEAN;
    if (row->release > 0 && isfinite(row->release)) {
        double touch;
        status = dom_row_touch(row, given, &touch);
        if (status == DOM_OK && row->release > touch)
            *verdict = (struct dom_verdict){.end = DOM_ROW_SKEWED, .domino = 1, .seconds = DOM_NAN};
        if (status != DOM_OK || row->release > touch)
            return status;
    }
    return row->engine->run(row, &compute, times, visit, context, verdict);
#endif
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
    return dom_row_run(&two, compute, false, tilt_seen, tilt, &verdict);
}

enum dom_status dom_row_watch(const struct dom_row *row, const struct dom_compute *compute,
                              const dom_real *times, size_t count, dom_moment_visit *visit, void *context,
                              struct dom_verdict *verdict)
{
    struct row_request request;
    const enum dom_status status = row_request_of(row, compute, &request);
    return status != DOM_OK ? status
           : row->engine    ? DOM_NO_METHOD
                            : row_watch(&request, times, count, visit, context, verdict);
}

#if !defined DOMF && !defined DOMQ

enum dom_status row_run_on(const struct dom_row *row, const struct dom_compute *compute,
                           dom_fall_visit *visit, void *context, struct dom_verdict *verdict)
{
    struct row_request request;
    const enum dom_status status = row_request_of(row, compute, &request);
    request.carries_on = true;
    return status == DOM_OK ? row_run(&request, false, visit, context, verdict) : status;
}

#endif

enum dom_status dom_count_find(dom_real first, dom_real height, dom_real r, struct dom_count *count)
{
    return dom_arithmetic()->bits == 0 ? DOM_NO_PRECISION : count_find(first, height, r, count);
}

dom_real dom_rmax(dom_real s, dom_real d, dom_real q)
{
    struct dom_train train = dom_train_default();
    struct dom_limit limit;
    train.s = s;
    train.d = d;
    train.q = q;
    return dom_limit_rmax(&train, NULL, &limit) == DOM_OK ? limit.r_max : DOM_NAN;
}

/* ---- Many trains at once ---- */

static const size_t answer_sizes[] = {
    [DOM_ASK_ANGLES] = sizeof(struct dom_angles), [DOM_ASK_CONTACT] = sizeof(struct dom_contact),
    [DOM_ASK_ENERGY] = sizeof(struct dom_energy), [DOM_ASK_FUEL] = sizeof(struct dom_fuels),
    [DOM_ASK_LAUNCH] = sizeof(struct dom_launch), [DOM_ASK_BARRIER] = sizeof(struct dom_barrier),
    [DOM_ASK_OMEGASQ] = sizeof(dom_real),         [DOM_ASK_DURATION] = sizeof(dom_real),
    [DOM_ASK_RMAX] = sizeof(struct dom_limit),    [DOM_ASK_PAIR] = sizeof(struct dom_limit),
    [DOM_ASK_BEST] = sizeof(struct dom_best),
};

static enum dom_status train_ask(enum dom_question question, const struct dom_train *train,
                                 const struct dom_compute *compute, const dom_real *tilt, void *answer)
{
    switch (question) {
    case DOM_ASK_ANGLES:
        return dom_angles_find(train, compute, answer);
    case DOM_ASK_CONTACT:
        return dom_contact_find(train, compute, *tilt, answer);
    case DOM_ASK_ENERGY:
        return dom_energy_find(train, compute, *tilt, answer);
    case DOM_ASK_FUEL:
        return dom_fuel_find(train, compute, answer);
    case DOM_ASK_LAUNCH:
        return dom_launch_find(train, compute, answer);
    case DOM_ASK_BARRIER:
        return dom_barrier_find(train, compute, answer);
    case DOM_ASK_OMEGASQ:
        return dom_cycle_omegasq(train, compute, *tilt, answer);
    case DOM_ASK_DURATION:
        return dom_cycle_duration(train, compute, answer);
    case DOM_ASK_RMAX:
        return dom_limit_rmax(train, compute, answer);
    case DOM_ASK_PAIR:
        return dom_limit_pair(train, compute, answer);
    case DOM_ASK_BEST:
        break;
    }
    return dom_limit_best(train, compute, answer);
}

enum dom_status dom_trains_ask(enum dom_question question, const struct dom_train *trains,
                               const dom_real *tilts, size_t count, const struct dom_compute *compute,
                               void *answers, enum dom_status *statuses)
{
    bool interrupted = false;
    if ((unsigned)question >= sizeof answer_sizes / sizeof *answer_sizes)
        return DOM_NO_METHOD;
    for (size_t k = 0; k < count; k++) {
        void *answer = (char *)answers + k * answer_sizes[question];
        interrupted = interrupted || (compute && dom_interrupted(compute->interrupt));
        statuses[k] = interrupted
                          ? DOM_INTERRUPTED
                          : train_ask(question, &trains[k], compute, tilts ? &tilts[k] : NULL, answer);
        interrupted = interrupted || statuses[k] == DOM_INTERRUPTED;
    }
    return interrupted ? DOM_INTERRUPTED : DOM_OK;
}

#undef ASK
#undef ANSWER
#undef ANSWER_AT
