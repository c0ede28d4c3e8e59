/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The checks of the values of a question, and the public functions that ask more than one precision or an
 * engine. The other public functions are where the mathematics is. */
#include "entry/other.h" /* first */

#include "growth/limit.h"
#include "row/row.h"

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

enum dom_status OWN(_limit_alone)(const struct dom_train *train, const struct dom_compute *compute, bool pair,
                                  dom_real near, struct dom_limit *limit)
{
    struct dom_train t = *train;
    t.r = 1; /* the search chooses r, so train->r need not be valid */
    const enum dom_status status = train_check(&t, compute);
    return status == DOM_OK ? limit_answer(&t, compute, pair, near, limit) : status;
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
    dom_real near = 0;
    anywhere.s = anywhere.r = 1;
    const enum dom_status status = train_check(&anywhere, given);
#ifdef DOMQ
    const struct dom_compute compute = compute_or_default(given);
    if (status == DOM_OK)
        near_best(&anywhere, &compute, &anywhere.s, &near);
#endif
    return status == DOM_OK ? limit_best(&anywhere, given, near, best) : status;
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

dom_real dom_rmax(dom_real s, dom_real d, dom_real q)
{
    struct dom_train train = dom_train_default();
    struct dom_limit limit;
    train.s = s;
    train.d = d;
    train.q = q;
    return dom_limit_rmax(&train, NULL, &limit) == DOM_OK ? limit.r_max : DOM_NAN;
}
