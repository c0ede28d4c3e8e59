/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "planning/model/planner.h"
#include "planning/model/shape.h"
#include "rows/model/boxes.h"
#include <stdlib.h>

/* ---- Kinetic energy relative to the barrier, for a train and for a row ---- */

/* Decides whether a failed computation is tried again. A few digits can be found even if rounding errors
 * exceed the usual tolerance. So if the computation did not converge, or if its result is not finite, sets a
 * larger tolerance in *compute and returns true. If the tolerance is already large, only the present
 * separation is skipped. Any other failure ends the search. */
static bool tried_again(struct planner *p, enum dom_status status, struct dom_compute *compute)
{
    const double rougher = 1000, roughest = 1e-6;
    const bool imprecise = status == DOM_NOT_CONVERGED || status == DOM_NOT_FINITE;
    if (imprecise && compute->tol < roughest) {
        compute->tol = fmin(rougher * compute->tol, roughest);
        return true;
    }
    if (imprecise)
        p->failed_s = p->train.s;
    else
        p->status = status;
    return false;
}

double planner_train_ratio(struct planner *p, double s, double r)
{
    struct dom_barrier barrier;
    struct dom_compute compute = p->compute;
    enum dom_status status;
    if (p->status != DOM_OK || s * r > 1)
        return 0;
    p->train.s = s;
    p->train.r = r;
    do {
        status = dom_barrier_find(&p->train, &compute, &barrier);
        if (status == DOM_OK || status == DOM_STOPS)
            return barrier.kinetic / barrier.barrier;
    } while (status != DOM_NO_FUEL && status != DOM_LOCKS && status != DOM_OUT_OF_REACH &&
             status != DOM_UNDERFLOW && status != DOM_TOO_LONG && tried_again(p, status, &compute));
    return 0;
}

struct dom_row planner_row(const struct planner *p, size_t count, double push,
                           const struct dom_engine *engine)
{
    struct dom_row row = {.domino = p->domino,
                          .count = count,
                          .g = p->wish->g,
                          .push = push,
                          .release = p->wish->release,
                          .engine = engine};
#define VALUE(effect, member, status) row.member = p->train.member;
    DOM_DYNAMICS(VALUE)
#undef VALUE
    row.walls *= p->wish->first; /* converts the thickness of walls from multiples of the first height to m */
    if (p->wish->boxes_above > 0) {
        row.walls = p->wish->walls;
        row.boxes_above = p->wish->boxes_above;
    }
    return row;
}

bool planner_write(struct planner *p, struct choice c)
{
    const size_t count = c.steps + 1;
    struct dom_domino *more = count > p->room ? realloc(p->domino, count * sizeof *more) : p->domino;
    if (!more) {
        p->status = DOM_NO_MEMORY;
        return false;
    }
    p->domino = more;
    p->room = count > p->room ? count : p->room;
    const struct dom_scale scale = {.h = p->wish->first, .g = p->wish->g};
    p->train.s = separation(c.k);
    p->train.r = planner_growth(p, c.steps);
    /* In air the masses count: with the density 1, the ratio of the densities is the density of the air. */
    const double volume = p->wish->first * p->wish->first * p->wish->first * p->train.d * p->train.width,
                 mass = p->train.air != 0 ? volume : 1;
    dom_row_of_train(&p->train, &scale, mass, p->domino, count);
    p->domino[c.steps].height = p->wish->height;
    p->domino[c.steps].width = p->train.width * p->wish->height;
    const struct dom_row row = planner_row(p, count, p->wish->push, NULL);
    for (size_t k = 0; row.boxes_above > 0 && k < count; k++) {
        struct dom_domino *d = &p->domino[k], *first = p->domino;
        d->mass = mass * wood_volume(&row, d) / wood_volume(&row, first);
        if (!(d->mass > 0)) {
            p->status = DOM_NO_ROOM;
            return false;
        }
    }
    if (p->limits)
        shape_round(&(struct shape){&row, p->limits}, p->domino);
    return true;
}

/* Records the smallest ratio of kinetic energy to barrier so far. Returns false to end the run. */
static bool ratio_seen(const struct dom_fall *fall, void *context)
{
    struct planner *p = context;
    double ratio = fall->barrier > 0 ? fall->kinetic / fall->barrier : HUGE_VAL;
    if (fall->domino > 1 && !(ratio >= p->least)) {
        p->least = ratio;
        p->weakest = fall->domino;
    }
    return p->whole || p->least >= p->wish->safety;
}

double planner_row_ratio(struct planner *p, struct choice c, double push, bool times)
{
    struct dom_verdict verdict = {.end = DOM_ROW_STOPS};
    if (p->status != DOM_OK || !planner_write(p, c))
        return 0;
    const struct dom_row row = planner_row(p, c.steps + 1, push, NULL);
    struct dom_compute compute = p->compute;
    enum dom_status status;
    do {
        p->least = HUGE_VAL;
        p->weakest = 0;
        p->whole = times;
        status = dom_row_run(&row, &compute, times, ratio_seen, p, &verdict);
    } while (status != DOM_OK && tried_again(p, status, &compute));
    p->seconds = verdict.seconds;
    return status == DOM_OK && verdict.end == DOM_ROW_FALLS ? p->least : 0;
}

/* ---- Lengths ---- */

/* Returns the length of a standing row, from the back of the first domino to the front of the last. The row
 * has the separation s. Its dimensions are not rounded to a grid. */
static double feet_of(const struct planner *p, size_t steps, double s)
{
    double r = planner_growth(p, steps), height = p->wish->first, sum = 0;
    for (size_t k = 0; k <= steps; k++, height *= r)
        sum += (p->train.d + (k ? s : 0)) * height;
    return sum;
}

int planner_widest(const struct planner *p, size_t steps, double hall)
{
    double closed = feet_of(p, steps, 0), open = feet_of(p, steps, 1);
    double s = (hall - p->wish->height - closed) / (open - closed);
    return s >= 1 ? GRID : s > 0 ? (int)floor(s * GRID) : 0;
}

double planner_feet(struct planner *p, struct choice c)
{
    double sum = 0;
    if (!p->limits)
        return feet_of(p, c.steps, separation(c.k));
    for (size_t k = 0; planner_write(p, c) && k <= c.steps; k++)
        sum += p->domino[k].gap + p->domino[k].thickness;
    return sum;
}
