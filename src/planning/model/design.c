/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Designs a row whose first and last heights are given. The search finds a separation, a growth and a number
 * of dominoes. When a domino after the first is hit in the designed row, the moving dominoes have at least
 * `safety` times the energy that they need. The search uses the same computations as the public functions, so
 * their results agree. planner.h describes the candidates.
 */
#include "planning/model/planner.h"
#include "planning/model/shape.h"
#include "search/edge.h"
#include <stdlib.h>

/* In the first search, k is a multiple of COARSE. A search for a separation takes steps of STEP, or of
 * STEP_OF_ENGINE with an engine, which is about a thousand times slower than the model. */
enum { COARSE = 20, STEP = 10, STEP_OF_ENGINE = 100 };

/*
 * A search begins with the smallest number of dominoes that may suffice. It adds at most MORE dominoes. The
 * search for the shortest row can end earlier: once it has found a row, it gives up after LONGER successive
 * attempts that do not find a shorter one, or LONGER_IN_ENGINE with an engine.
 */
enum { MORE = 30, LONGER = 8, LONGER_IN_ENGINE = 2 };

/* ---- Tests of a candidate ---- */

/* Returns the length of a candidate row after its last domino has fallen forwards. */
static double length_of(struct planner *p, struct choice c)
{
    return planner_feet(p, c) + p->wish->height;
}

typedef bool choice_test(struct planner *p, struct choice c);

/* Returns true if the row is safe enough and fits into the hall. */
static bool row_enough(struct planner *p, struct choice c)
{
    return planner_row_ratio(p, c, p->wish->push, false) >= p->wish->safety &&
           (!p->limits || length_of(p, c) <= p->hall);
}

/* Returns true if row_enough holds, and an endless train of such dominoes is safe enough, too. */
static bool enough(struct planner *p, struct choice c)
{
    return planner_train_ratio(p, separation(c.k), planner_growth(p, c.steps)) >= p->wish->safety &&
           row_enough(p, c);
}

/* Returns true if the row also falls in the engine. If the engine cannot decide whether it falls, returns
 * false. */
static bool enough_in_engine(struct planner *p, struct choice c)
{
    struct dom_verdict verdict = {.end = DOM_ROW_STOPS};
    if (!enough(p, c))
        return false;
    const struct dom_row row = planner_row(p, c.steps + 1, p->wish->push, p->wish->engine);
    enum dom_status status = dom_row_run(&row, &p->compute, true, NULL, NULL, &verdict);
    bool falls = status == DOM_OK && verdict.end == DOM_ROW_FALLS;
    p->engine_seconds = verdict.seconds;
    p->engine_refused |= !falls;
    p->status = status == DOM_NOT_CONVERGED ? DOM_OK : status;
    return falls;
}

/* ---- The separation ---- */

/* An edge_test: returns true if a train with the separation p->train.s and the growth r is safe. */
static bool growth_enough(double r, double *spare, void *planner)
{
    struct planner *p = planner;
    (void)spare;
    return planner_train_ratio(p, p->train.s, r) >= p->wish->safety;
}

/* Returns the largest growth r at which a train with the separation s is safe. Its relative error is at most
 * 1e-7. If the train is not safe at r = 1, returns 0. */
static double safe_growth(struct planner *p, double s)
{
    double most = 1 / s;
    p->train.s = s;
    return !growth_enough(1, NULL, p)     ? 0
           : growth_enough(most, NULL, p) ? most
                                          : edge_find(growth_enough, p, 1, &most, 0, 1e-7);
}

/* Finds the separation whose train is safe at the largest growth. Sets *best to this separation and returns
 * the growth. If no train is safe, returns 0. The search first takes coarse steps over all separations, and
 * then, from the best one, ever smaller steps to both sides. */
static double separation_find(struct planner *p, int *best)
{
    double most = 0;
    *best = 0;
    for (int step = COARSE, from = 0; step > 0; step /= 2, from = *best) {
        const bool all = step == COARSE;
        for (int k = all ? step : from - step; k <= (all ? GRID : from + step); k += all ? step : 2 * step) {
            double r = k > 0 && k <= GRID ? safe_growth(p, separation(k)) : 0;
            if (r > most) {
                most = r;
                *best = k;
            }
        }
    }
    return most;
}

/* Searches for a separation at which the row passes the test. Starts at k, or at `most` if k is larger. Moves
 * away from there in both directions, in steps of `step`, but not beyond `most`. Returns the first separation
 * at which the row passes, or 0 if there is none. Separations are in units of 1/GRID. */
static int nearest(struct planner *p, size_t steps, int k, int most, int step, choice_test *test)
{
    int from = k < most ? k : most;
    for (int away = 0; p->status == DOM_OK && (from - away > 0 || from + away <= most); away += step)
        for (int side = -1; side <= (away ? 1 : -1); side += 2) {
            struct choice c = {from + side * away, steps};
            if (c.k > 0 && c.k <= most && test(p, c))
                return c.k;
        }
    return 0;
}

/* Narrows the gaps of a safe row. Starts at the separation `good`, at which the row must be safe, and reduces
 * it as long as the row stays safe. Returns the smallest separation that is reached. Separations are in units
 * of 1/GRID. */
static int closest(struct planner *p, size_t steps, int good)
{
    for (int step = COARSE / 2; step > 0;) {
        const struct choice closer = {good - step, steps};
        if (closer.k > 0 && enough(p, closer))
            good = closer.k;
        else
            step /= 2;
    }
    return good;
}

/* ---- The number of dominoes ---- */

/*
 * Finds the row with the fewest dominoes that is safe enough and fits into the hall. If `shortest` is true,
 * finds the shortest row that is safe enough instead, whatever the hall. Only rows with at least `fewest`
 * steps are tried. Returns the length of the row, or infinity if no row is found.
 */
static double row_search(struct planner *p, size_t fewest, int k, bool shortest, struct choice *best)
{
    double length = HUGE_VAL;
    size_t longer = 0, longer_most = p->wish->engine ? LONGER_IN_ENGINE : LONGER;
    p->hall = shortest ? HUGE_VAL : p->wish->hall;
    for (size_t n = fewest; n <= fewest + MORE && longer < longer_most && p->status == DOM_OK; n++) {
        const int most = shortest ? GRID : planner_widest(p, n, p->hall);
        if (most <= 0 || planner_widest(p, n, length) == 0)
            break; /* a row with more dominoes would be too long, too */
        struct choice c = {nearest(p, n, k, most, STEP, enough), n};
        if (c.k > 0 && shortest)
            c.k = closest(p, n, c.k);
        if (c.k > 0 && p->wish->engine)
            c.k = nearest(p, n, c.k, shortest ? planner_widest(p, n, length) : most, STEP_OF_ENGINE,
                          enough_in_engine);
        const double found = c.k > 0 ? length_of(p, c) : HUGE_VAL;
        longer = found < length || !isfinite(length) ? 0 : longer + 1;
        if (!(found < length))
            continue;
        *best = c;
        length = found;
        if (!shortest)
            break;
    }
    return p->status == DOM_OK ? length : HUGE_VAL;
}

/* An edge_test: returns true if the row p->pushed is safe enough with this push. */
static bool push_enough(double push, double *spare, void *planner)
{
    struct planner *p = planner;
    (void)spare;
    return planner_row_ratio(p, p->pushed, push, false) >= p->wish->safety;
}

/* Returns the weakest push that makes the row safe enough, with a relative error of at most 1e-4. If no such
 * push is found, returns NaN. */
static double push_find(struct planner *p, struct choice c)
{
    double push = !(p->wish->push > 0) ? sqrt(p->wish->g / p->wish->first) / 16 : p->wish->push, weak = 0;
    p->pushed = c;
    for (int i = 0; i <= 16; i++, weak = push, push *= 2)
        if (push_enough(push, NULL, p))
            return edge_find(push_enough, p, push, &weak, 0, 1e-4);
    return DOM_NAN;
}

/* Returns an estimate of the largest ratio of kinetic energy to barrier that any train can have. This ratio
 * occurs at r = 1. The estimate is slightly too low, because only some separations are tried. */
static double safety_most(struct planner *p)
{
    double most = 0;
    for (int k = COARSE / 2; k <= GRID; k += COARSE / 2)
        most = fmax(most, planner_train_ratio(p, separation(k), 1));
    return most;
}

/* ---- Designs ---- */

/* The result of a search that found no row. */
static const struct dom_design no_design = {.s = DOM_NAN,
                                            .r = DOM_NAN,
                                            .feet = DOM_NAN,
                                            .length = DOM_NAN,
                                            .seconds = DOM_NAN,
                                            .train = DOM_NAN,
                                            .row = DOM_NAN,
                                            .needs = DOM_NAN};

/* Prepares a search. If an argument is outside its range, the member `status` of the result tells which. The
 * caller must free the member `domino` of the result. */
static struct planner planner_make(const struct dom_train *train, const struct dom_wish *wish,
                                   const struct dom_limits *limits, const struct dom_compute *compute)
{
    struct planner p = {
        .train = *train, .compute = *compute, .wish = wish, .limits = limits, .hall = wish->hall};
    p.compute.method = DOM_METHOD_OURS;
    p.status = !(wish->first > 0 && wish->height > wish->first && isfinite(wish->height / wish->first))
                   ? DOM_BAD_HEIGHT
               : !(wish->safety > 1 && isfinite(wish->safety)) ? DOM_BAD_SAFETY
               : !(wish->hall > wish->height)                  ? DOM_BAD_HALL
               : !(wish->g > 0 && isfinite(wish->g))           ? DOM_BAD_G
               : wish->push < 0 || isinf(wish->push)           ? DOM_BAD_PUSH
               : !(wish->release >= 0)                         ? DOM_BAD_RELEASE
               : limits                                        ? limits_check(limits)
                                                               : DOM_OK;
    if (p.status != DOM_OK)
        return p;
    p.train.s = separation(GRID / 2);
    p.train.r = 1;
    if (wish->boxes_above > 0)
        p.train.walls = 0; /* in a train, walls affect only the times, which are not needed */
    p.status = dom_train_check(&p.train, &p.compute);
    p.compute.tol = dom_arithmetic()->tol_default;
    return p;
}

/* Ends a search. If a row was found, computes it with the requested tolerance. */
static enum dom_status planner_end(struct planner *p, struct choice c, const struct dom_compute *compute,
                                   struct dom_design *found, struct dom_design *design)
{
    if (p->status == DOM_OK && c.k > 0 && p->wish->engine)
        (void)enough_in_engine(p, c); /* for the time in the engine */
    if (p->status == DOM_OK && c.k > 0) {
        p->compute = *compute;
        const double s = separation(c.k), r = planner_growth(p, c.steps),
                     train = planner_train_ratio(p, s, r), row = planner_row_ratio(p, c, p->wish->push, true),
                     feet = planner_feet(p, c);
        *found = (struct dom_design){.s = s,
                                     .r = r,
                                     .steps = c.steps,
                                     .feet = feet,
                                     .length = feet + p->wish->height,
                                     .seconds = p->wish->engine ? p->engine_seconds : p->seconds,
                                     .train = train > 0 ? train : DOM_NAN,
                                     .row = row > 0 ? row : DOM_NAN,
                                     .weakest = p->weakest,
                                     .needs = DOM_NAN};
    }
    if (p->status == DOM_OK)
        *design = *found;
    free(p->domino);
    return p->status;
}

/* Finds a row. If none is found, says in `limit` and `needs` of *found why. */
static struct choice design_search(struct planner *p, struct dom_design *found)
{
    const struct choice none = {0, 0};
    const struct dom_wish *wish = p->wish;
    struct choice c = none;
    int k;
    size_t fewest = 1;
    double most = separation_find(p, &k), length = HUGE_VAL;
    if (most == 0) {
        found->limit = DOM_DESIGN_SAFETY;
        found->needs = safety_most(p);
        return none;
    }
    while (planner_growth(p, fewest) > most && fewest < (size_t)MORE * MORE)
        fewest++;
    if (wish->least != DOM_LEAST_LENGTH)
        length = row_search(p, fewest, k, false, &c);
    if (isinf(length) && (wish->least == DOM_LEAST_LENGTH || isfinite(wish->hall)))
        length = row_search(p, fewest, k, true, &c);
    if (length <= wish->hall && isfinite(length))
        return c;
    if (isfinite(length)) {
        found->limit = DOM_DESIGN_HALL;
        found->needs = length;
    } else if (p->engine_refused) {
        found->limit = DOM_DESIGN_ENGINE;
    } else if (p->status == DOM_OK) {
        found->limit = DOM_DESIGN_START;
        found->needs = push_find(p, (struct choice){k, fewest});
    }
    return none;
}

enum dom_status dom_design_fit(const struct dom_train *train, const struct dom_wish *wish,
                               const struct dom_limits *limits, const struct dom_compute *compute,
                               struct dom_design *design)
{
    const struct dom_compute final = compute_or_default(compute);
    struct planner p = planner_make(train, wish, limits, &final);
    struct dom_design found = no_design;
    struct choice c = {0, 0};
    if (p.status == DOM_OK)
        c = design_search(&p, &found);
    bool remedy = found.limit == DOM_DESIGN_HALL || (found.limit == DOM_DESIGN_START && !isnan(found.needs));
    if (found.limit != DOM_DESIGN_FITS && !remedy && p.failed_s > 0) {
        found.limit = DOM_DESIGN_FAILED;
        found.needs = p.failed_s;
    }
    return planner_end(&p, c, &final, &found, design);
}

enum dom_status dom_design_find(const struct dom_train *train, const struct dom_wish *wish,
                                const struct dom_compute *compute, struct dom_design *design)
{
    return dom_design_fit(train, wish, NULL, compute, design);
}

enum dom_status dom_design_steps(const struct dom_train *train, const struct dom_wish *wish,
                                 const struct dom_limits *limits, const struct dom_compute *compute,
                                 size_t steps, struct dom_design *design)
{
    const struct dom_compute final = compute_or_default(compute);
    struct planner p = planner_make(train, wish, limits, &final);
    struct dom_design found = no_design;
    struct dom_wish falls = *wish;
    struct choice c = {0, steps};
    int k = 0;
    if (p.status == DOM_OK && steps == 0)
        p.status = DOM_BAD_COUNT;
    falls.safety = 1 + 1.0 / 1000;
    falls.engine = NULL;
    if (p.status == DOM_OK && separation_find(&p, &k) == 0) {
        p.wish = &falls; /* no train has the required safety, so look for one that merely falls */
        (void)separation_find(&p, &k);
    }
    p.wish = &falls;
    const int most = p.status == DOM_OK ? planner_widest(&p, steps, wish->hall) : 0;
    if (k > 0 && most > 0)
        c.k = nearest(&p, steps, k, most, STEP, row_enough);
    found.limit = c.k > 0 ? DOM_DESIGN_FITS : most <= 0 ? DOM_DESIGN_HALL : DOM_DESIGN_SAFETY;
    return planner_end(&p, c, &final, &found, design);
}

enum dom_status dom_design_dominoes(const struct dom_train *train, const struct dom_wish *wish,
                                    const struct dom_limits *limits, const struct dom_design *design,
                                    struct dom_domino *domino)
{
    const struct dom_compute compute = compute_or_default(NULL);
    struct planner p = planner_make(train, wish, limits, &compute);
    const struct choice c = {(int)floor(design->s * GRID + 0.5), design->steps};
    if (p.status == DOM_OK && design->limit != DOM_DESIGN_FITS)
        p.status = DOM_BAD_COUNT;
    if (p.status == DOM_OK && planner_write(&p, c))
        for (size_t k = 0; k <= c.steps; k++) {
            domino[k] = p.domino[k];
            domino[k].mass /= p.domino->mass; /* in air, the planner computes with a density of 1 */
        }
    free(p.domino);
    return p.status;
}
