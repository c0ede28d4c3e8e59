/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The structures of a question: their defaults, what follows from them without mathematics, and the checks of
 * their values. Then the public functions that ask more than one precision or an engine. The other public
 * functions are where the mathematics is. */
#include "entry/other.h" /* first */

#include "growth/limit.h"
#include "row/row.h"

#define DEFAULT(name, default_, lowest, highest, unit, meaning) .name = default_,

struct dom_train dom_train_default(void)
{
    return (struct dom_train){DOM_TRAIN_PARAMETERS(DEFAULT).fuel = DOM_FUEL_EXACT};
}

struct dom_scale dom_scale_default(void)
{
    return (struct dom_scale){DOM_SCALE_PARAMETERS(DEFAULT)};
}

struct dom_row dom_row_default(void)
{
    return (struct dom_row){.g = dom_scale_default().g, .push = DOM_NAN};
}

dom_real dom_train_reach(const struct dom_train *train)
{
    return reach_span(train->rho) / train->s;
}

/* The smallest tolerance of each precision is 4 to 10 times its epsilon. */
#define DOUBLE_FLOOR (1 / 1e15)
#define TENTH(power) (1 / (dom_real)(power)) /* `power` is a power of ten that a double holds exactly */

#if defined DOMF
static const struct dom_arithmetic arithmetic = {
    "float", "float", FLT_MANT_DIG, (double)FLT_EPSILON, TENTH(1e5F), TENTH(1e6F), 5};
#elif !defined DOMQ
static const struct dom_arithmetic arithmetic = {
    "double", "double", DBL_MANT_DIG, DBL_EPSILON, TENTH(1e12), DOUBLE_FLOOR, 10};
#elif defined DOMQ_REAL_FLOAT128
static const struct dom_arithmetic arithmetic = {
    "quad", "__float128", 113, 0x1p-112, TENTH(1e15) / (dom_real)1e15, TENTH(1e15) / (dom_real)1e18, 30};
#elif LDBL_MANT_DIG == 113
static const struct dom_arithmetic arithmetic = {
    "quad", "long double", 113, 0x1p-112, TENTH(1e15) / (dom_real)1e15, TENTH(1e15) / (dom_real)1e18, 30};
#elif LDBL_MANT_DIG > DBL_MANT_DIG
static const struct dom_arithmetic arithmetic = {
    "quad", "long double", LDBL_MANT_DIG, (double)LDBL_EPSILON, TENTH(1e17), TENTH(1e18), 17};
#else
static const struct dom_arithmetic arithmetic = {
    "quad", "none wider than double", 0, DBL_EPSILON, TENTH(1e12), TENTH(1e15), 10};
#endif

const struct dom_arithmetic *dom_arithmetic(void)
{
    return &arithmetic;
}

struct dom_compute dom_compute_default(void)
{
    return (struct dom_compute){.tol = arithmetic.tol_default};
}

/* ---- Checks ---- */

/* The statuses for values outside the ranges in DOM_TRAIN_PARAMETERS and DOM_COMPUTE_PARAMETERS. */
#define BAD_s     DOM_BAD_S
#define BAD_r     DOM_BAD_R
#define BAD_d     DOM_BAD_D
#define BAD_q     DOM_BAD_Q
#define BAD_width DOM_BAD_WIDTH
#define BAD_tol   DOM_BAD_TOL

/* Sets `status` to an error if the parameter is outside its range and no earlier check failed. */
#define CHECK(of, name, lowest, highest)                                                                     \
    if (status == DOM_OK && !((of)->name >= (dom_real)(lowest) && (of)->name <= (dom_real)(highest)))        \
        status = BAD_##name;

KERNEL enum dom_status train_check(const struct dom_train *train, const struct dom_compute *given)
{
    const struct dom_compute compute = compute_or_default(given), *c = &compute;
    enum dom_status status = IS_NEWER(train) || IS_NEWER(c) ? DOM_NEWER : DOM_OK;
#define CHECK_TRAIN(name, default_, lowest, highest, unit, meaning)   CHECK(train, name, lowest, highest)
#define CHECK_COMPUTE(name, default_, lowest, highest, unit, meaning) CHECK(c, name, lowest, highest)
    DOM_TRAIN_PARAMETERS(CHECK_TRAIN)
    if (status == DOM_OK)
        status = dynamics_check(train);
    if (status == DOM_OK && train->fuel > DOM_FUEL_PAPER)
        status = DOM_BAD_FUEL;
    if (status == DOM_OK && dom_arithmetic()->bits == 0)
        status = DOM_NO_PRECISION;
    DOM_COMPUTE_PARAMETERS(CHECK_COMPUTE)
    return status == DOM_OK && compute.tol < dom_arithmetic()->tol_floor ? DOM_BAD_TOL : status;
}

/* ---- Limits, which more than one precision may find ---- */

#define THERE(name, ...)                     .name = (other_real)train->name,
#define EFFECT_THERE(effect, member, status) .member = (other_real)train->member,

static other_train train_there(const struct dom_train *train)
{
    return (other_train){DOM_TRAIN_PARAMETERS(THERE) DOM_DYNAMICS(EFFECT_THERE).fuel = train->fuel};
}

static other_compute compute_there(const struct dom_compute *compute, other_real tol)
{
    return (other_compute){.tol = tol, .work = compute->work, .interrupt = compute->interrupt};
}

/* Finds a limit. In quad, a search for r_max starts from that in double. A limit that is open in float or
 * double is computed again in quad, where fewer minima of the margin are open. */
static enum dom_status limit_of(const struct dom_train *train, const struct dom_compute *given, bool pair,
                                struct dom_limit *limit)
{
    const struct dom_compute compute = compute_or_default(given);
    other_limit found;
#ifdef DOMQ
    const other_train there = train_there(train);
    const other_compute coarse = compute_there(&compute, DOUBLE_FLOOR);
    const bool near = !pair && OTHER(_limit_answer)(&there, &coarse, false, 0, &found) == DOM_OK &&
                      found.ends == DOM_END_BARRIER && found.r_max > 1;
    return limit_answer(train, &compute, pair, near ? (real)found.r_max : 0, limit);
#else
    const enum dom_status status = limit_answer(train, &compute, pair, 0, limit);
    if (status != DOM_OPEN)
        return status;
    const other_train there = train_there(train);
    const other_compute same = compute_there(&compute, (other_real)compute.tol);
    const enum dom_status then = OTHER(_limit_answer)(&there, &same, pair, 0, &found);
    if (then == DOM_OK || then == DOM_OPEN)
        *limit = (struct dom_limit){.r_max = (real)found.r_max,
                                    .ends = found.ends,
                                    .why = found.why,
                                    .uncertainty = (real)found.uncertainty,
                                    .open = (real)found.open};
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
    struct dom_train from = *train;
    dom_real near = 0;
    from.s = 1; /* the search chooses s, so train->s need not be valid */
#ifdef DOMQ
    const struct dom_compute compute = compute_or_default(given);
    const other_train there = train_there(&from);
    const other_compute coarse = compute_there(&compute, DOUBLE_FLOOR);
    other_best found;
    if (OTHER(_limit_best)(&there, &coarse, 0, &found) == DOM_OK) {
        from.s = (real)found.s;
        near = (real)found.r_max;
    }
#endif
    return limit_best(&from, given, near, best);
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

/* ---- Rows ---- */

enum dom_status dom_row_run(const struct dom_row *row, const struct dom_compute *given, bool times,
                            dom_fall_visit *visit, void *context, struct dom_verdict *verdict)
{
    if (!row->engine) {
        const struct run_options options = {.times = times};
        return row_run(row, given, &options, visit, context, verdict);
    }
#if defined DOMF || defined DOMQ
    return DOM_NO_METHOD;
#else
    const struct dom_compute compute = compute_or_default(given);
    if (IS_NEWER(row) || IS_NEWER(&compute))
        return DOM_NEWER;
    for (size_t k = 0; k < row->count; k++)
        if (row->domino[k].lean != 0)
            return DOM_NO_LEAN;
    if (row->release > 0 && isfinite(row->release)) {
        double touch;
        const enum dom_status status = dom_row_touch(row, given, &touch);
        if (status == DOM_OK && row->release > touch)
            *verdict = (struct dom_verdict){.end = DOM_ROW_SKEWED, .domino = 1, .seconds = DOM_NAN};
        if (status != DOM_OK || row->release > touch)
            return status;
    }
    return row->engine->run(row, &compute, times, visit, context, verdict);
#endif
}

enum dom_status dom_row_touch(const struct dom_row *given, const struct dom_compute *compute, dom_real *tilt)
{
    struct dom_row two = *given;
    struct row row;
    size_t wrong;
    two.count = given->count < 2 ? given->count : 2;
    two.push = 0;
    two.release = (dom_real)HUGE_VAL;
    const enum dom_status status = row_begin(&two, compute, &row, &wrong);
    if (status == DOM_OK)
        *tilt = tilt_angle(row.geometry[0].c);
    row_free(&row);
    return status;
}

void dom_row_of_train(const struct dom_train *train, const struct dom_scale *scale, dom_real mass,
                      struct dom_domino *domino, size_t count)
{
    const dom_real heavier = pow(train->r, train->q - 1);
    dom_real height = scale->h;
    for (size_t k = 0; k < count; k++, height *= train->r, mass *= heavier)
        domino[k] = (struct dom_domino){
            .height = height,
            .thickness = train->d * height,
            .gap = k == 0 ? 0 : train->s * height,
            .width = train->width * height,
            .mass = mass,
        };
}

void dom_lean_limits(const struct dom_domino *domino, dom_real alpha, dom_real rho, dom_real lean[2])
{
    dom_real radius = rho != 0 && domino->radius > 0 ? domino->radius : rho * domino->height;
    dom_real limit = atan((domino->thickness - 2 * radius) / domino->height);
    lean[0] = -limit - alpha;
    lean[1] = limit - alpha;
}
