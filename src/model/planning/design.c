/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Designs a row: given the heights of the first and the last domino, finds a separation, a growth and a
 * number of dominoes with which every cycle has `safety` times the energy that it needs. The search runs the
 * same computations as the public functions, so that a designed row gets the same verdict as one that a user
 * enters.
 */
#include "dispatch/dispatch.h"
#ifdef DOMQ
#define REAL_QUAD
#endif
#include "numerics/real.h"
#include <stdlib.h>

/* Separations are multiples of 1/GRID, which is about 0.05 mm for the standard domino. The search for the
 * best separation starts with steps of COARSE/GRID. */
enum { GRID = 1000, COARSE = 20 };

/* The search tries rows with up to MORE dominoes more than the fewest that may suffice. The search for the
 * shortest row ends after LONGER successive rows that are not shorter than the best one, or after
 * LONGER_IN_ENGINE such rows if an engine runs each row. */
enum { MORE = 30, LONGER = 8, LONGER_IN_ENGINE = 2 };

/* After a failure the tolerance is multiplied by ROUGHER, but never raised above ROUGHEST. */
#define ROUGHER  1000
#define ROUGHEST ((dom_real)1e-6)

/* The state of a search. Once the status is not DOM_OK, no further train or row is computed, and every test
 * counts as failed. */
struct planner {
    struct dom_train train;
    /* settings of the search, which computes in double for every precision of the result */
    struct dom_compute compute;
    const struct dom_wish *wish;
    struct dom_domino *domino; /* array with room for `room` dominoes */
    size_t room;
    enum dom_status status;
    dom_real failed; /* last separation at which a train or row could not be computed, or 0 */
    bool whole;      /* if false, a run of a row may end at the first domino without the safety */
    size_t weakest;  /* number of the domino with the smallest ratio in the last row */
    dom_real least;  /* kinetic / barrier of that domino */
    dom_real seconds, engine_seconds; /* duration of the last row, by the model and by the engine */
    bool engine_refused; /* some row had the safety in the model, but did not fall in the engine */
};

/* A candidate row: the separation k/GRID, and the number of steps from the first domino to the last. */
struct choice {
    int k;
    size_t steps;
};

static dom_real separation(int k)
{
    return (dom_real)k / GRID;
}

/* Returns the growth that leads from the first height to the last one in `steps` steps. */
static dom_real growth(const struct planner *p, size_t steps)
{
    return pow(p->wish->height / p->wish->first, 1 / (dom_real)steps);
}

/* ---- Kinetic energy relative to the barrier, for a train and for a row ---- */

/* Returns true if a computation that ended with this status should be repeated, and then raises its
 * tolerance. If the arithmetic has too few digits for the sums, a few digits of a ratio can still be
 * found. */
static bool tried_again(enum dom_status status, struct dom_compute *compute)
{
    if ((status != DOM_NOT_CONVERGED && status != DOM_NOT_FINITE) || !(compute->tol < ROUGHEST))
        return false;
    compute->tol = fmin(ROUGHER * compute->tol, ROUGHEST);
    return true;
}

/* Records a failure. A status that has nothing to do with this train or row ends the search. A separation at
 * which the computation did not converge is only skipped, so that a row at another separation can still be
 * found. */
static void failure_keep(struct planner *p, enum dom_status status)
{
    if (status == DOM_NOT_CONVERGED || status == DOM_NOT_FINITE)
        p->failed = p->train.s;
    else
        p->status = status;
}

/* Returns the kinetic energy of the endless train divided by its barrier, or 0 if the train has no cycle. */
static dom_real train_ratio(struct planner *p, dom_real s, dom_real r)
{
    struct dom_barrier barrier = {.kinetic = DOM_NAN, .barrier = DOM_NAN};
    if (p->status != DOM_OK || s * r > 1)
        return 0;
    p->train.s = s;
    p->train.r = r;
    struct dom_compute compute = p->compute;
    enum dom_status status;
    do {
        struct question q = question_make(&p->train, &compute);
        status = ASK(q, barrier_find, &barrier);
    } while (tried_again(status, &compute));
    if (status == DOM_OK || status == DOM_STOPS)
        return barrier.kinetic / barrier.barrier;
    if (status != DOM_NO_FUEL && status != DOM_LOCKS && status != DOM_OUT_OF_REACH &&
        status != DOM_UNDERFLOW && status != DOM_TOO_LONG)
        failure_keep(p, status);
    return 0;
}

/* Called for each domino: remembers the domino with the smallest ratio. The first domino does not count,
 * since its energy depends on the push. Returns false, which ends the run, if the ratio is already too
 * small. */
static bool ratio_seen(const struct dom_fall *fall, void *context)
{
    struct planner *p = context;
    dom_real ratio = fall->kinetic / fall->barrier;
    if (fall->domino > 1 && !(ratio >= p->least)) {
        p->least = ratio;
        p->weakest = fall->domino;
    }
    return p->whole || p->least >= p->wish->safety;
}

/* Writes the dominoes of a candidate row, and enlarges the array if necessary. Returns false if memory is
 * exhausted. */
static bool row_write(struct planner *p, struct choice c)
{
    size_t count = c.steps + 1;
    if (count > p->room) {
        struct dom_domino *more = realloc(p->domino, count * sizeof *more);
        if (!more) {
            p->status = DOM_NO_MEMORY;
            return false;
        }
        p->domino = more;
        p->room = count;
    }
    const struct dom_scale scale = {.h = p->wish->first, .g = p->wish->g};
    p->train.s = separation(c.k);
    p->train.r = growth(p, c.steps);
    dom_row_of_train(&p->train, &scale, 1, p->domino, count);
    p->domino[c.steps].height = p->wish->height;
    return true;
}

/* Returns the row whose dominoes were written last. */
static struct dom_row row_of(const struct planner *p, struct choice c, dom_real push,
                             const struct dom_engine *engine)
{
    struct dom_row row = {
        .domino = p->domino, .count = c.steps + 1, .g = p->wish->g, .push = push, .engine = engine};
#define VALUE(effect, member, status) row.member = p->train.member;
    DOM_DYNAMICS(VALUE)
#undef VALUE
    row.walls *= p->wish->first; /* from multiples of the first height to m */
    return row;
}

/* Returns the smallest kinetic / barrier of the row's dominoes, or 0 if not all of them fall. Unless `times`
 * is set, the run ends at the first ratio below the safety. */
static dom_real row_ratio(struct planner *p, struct choice c, dom_real push, bool times)
{
    struct dom_verdict verdict = {.end = DOM_ROW_STOPS};
    if (p->status != DOM_OK || !row_write(p, c))
        return 0;
    const struct dom_row row = row_of(p, c, push, NULL);
    struct dom_compute compute = p->compute;
    enum dom_status status;
    do {
        p->least = (dom_real)INFINITY;
        p->weakest = 0;
        p->whole = times;
        status = row_verdict(&row, &compute, times, ratio_seen, p, &verdict);
    } while (tried_again(status, &compute));
    p->seconds = verdict.seconds;
    if (status != DOM_OK)
        failure_keep(p, status);
    return status == DOM_OK && verdict.end == DOM_ROW_FALLS ? p->least : 0;
}

static bool train_enough(struct planner *p, struct choice c)
{
    return train_ratio(p, separation(c.k), growth(p, c.steps)) >= p->wish->safety;
}

static bool enough(struct planner *p, struct choice c)
{
    return train_enough(p, c) && row_ratio(p, c, p->wish->push, false) >= p->wish->safety;
}

/* Returns true if the row has the safety in the model, and all its dominoes also fall in the engine. A row
 * that the engine cannot decide counts as one that does not fall. */
static bool enough_in_engine(struct planner *p, struct choice c)
{
    struct dom_verdict verdict = {.end = DOM_ROW_STOPS};
    if (!enough(p, c))
        return false;
    const struct dom_row row = row_of(p, c, p->wish->push, p->wish->engine);
    enum dom_status status = row_verdict(&row, &p->compute, true, NULL, NULL, &verdict);
    bool falls = status == DOM_OK && verdict.end == DOM_ROW_FALLS;
    p->engine_seconds = verdict.seconds;
    p->engine_refused |= !falls;
    p->status = status == DOM_NOT_CONVERGED ? DOM_OK : status;
    return falls;
}

/* ---- Lengths ---- */

/* Returns the length from the back of the first domino to the front of the last one, while all stand, for the
 * separation s and the thickness d of the train. */
static dom_real feet_of(const struct planner *p, size_t steps, dom_real s)
{
    dom_real r = growth(p, steps), height = p->wish->first, sum = 0;
    for (size_t k = 0; k <= steps; k++, height *= r)
        sum += (p->train.d + (k ? s : 0)) * height;
    return sum;
}

/* Returns the length of the row after the last domino has fallen forwards. */
static dom_real length_of(const struct planner *p, struct choice c)
{
    return feet_of(p, c.steps, separation(c.k)) + p->wish->height;
}

/* Returns the largest k with which the row fits into a hall of this length, or a number below 1 if the row
 * does not fit with any k. */
static int widest(const struct planner *p, size_t steps, dom_real hall)
{
    dom_real closed = feet_of(p, steps, 0), open = feet_of(p, steps, 1);
    dom_real s = (hall - p->wish->height - closed) / (open - closed);
    return s >= 1 ? GRID : s > 0 ? (int)(double)floor(s * GRID) : 0;
}

/* ---- The separation ---- */

/* Returns the largest growth at which the train has the safety, with a relative tolerance of 1e-7. Returns 0
 * if the train does not have the safety at r = 1. */
static dom_real safe_growth(struct planner *p, dom_real s)
{
    dom_real lo = 1, hi = 1 / s;
    if (!(train_ratio(p, s, 1) >= p->wish->safety))
        return 0;
    if (train_ratio(p, s, hi) >= p->wish->safety)
        return hi;
    while (hi - lo > (dom_real)1e-7 * hi && p->status == DOM_OK) {
        dom_real middle = (lo + hi) / 2;
        *(train_ratio(p, s, middle) >= p->wish->safety ? &lo : &hi) = middle;
    }
    return lo;
}

/* Finds the separation on the grid with which a train can grow most and still have the safety, first in
 * coarse steps and then in steps that are halved. Returns the growth at that separation, or 0 if no train has
 * the safety. */
static dom_real separation_find(struct planner *p, int *best)
{
    dom_real most = 0;
    *best = 0;
    for (int k = COARSE; k <= GRID; k += COARSE) {
        dom_real r = safe_growth(p, separation(k));
        if (r > most) {
            most = r;
            *best = k;
        }
    }
    for (int step = COARSE / 2, from = *best; step > 0 && most > 0; step = step / 2, from = *best)
        for (int k = from - step; k <= from + step; k += 2 * step) {
            dom_real r = k > 0 && k <= GRID ? safe_growth(p, separation(k)) : 0;
            if (r > most) {
                most = r;
                *best = k;
            }
        }
    return most;
}

typedef bool choice_test(struct planner *p, struct choice c);

/* Returns the index of the separation nearest to k with which the row passes the test, or 0 if none does. The
 * search moves away from k in both directions in multiples of `step`, and never above `most`. */
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

/* Returns the smallest separation down to which the row keeps the safety. With the separation `good` the row
 * must have the safety. */
static int closest(struct planner *p, size_t steps, int good)
{
    int bad = good;
    while (bad > 0 && enough(p, (struct choice){bad, steps})) {
        good = bad;
        bad -= COARSE / 2;
    }
    bad = bad > 0 ? bad : 0;
    while (good - bad > 1) {
        int middle = (good + bad) / 2;
        *(enough(p, (struct choice){middle, steps}) ? &good : &bad) = middle;
    }
    return good;
}

/* Steps of the search for a separation, in units of 1/GRID. For one row an engine takes as long as the model
 * takes for hundreds. */
enum { STEP = 10, STEP_OF_ENGINE = 100 };

/* ---- The number of dominoes ---- */

/* Returns the next number of steps to try. With an engine, the increments grow, since every row takes
 * long. */
static size_t steps_next(const struct planner *p, size_t fewest, size_t n)
{
    return n + 1 + (p->wish->engine ? (n - fewest) / 4 : 0);
}

/* Finds the shortest row with at least `fewest` steps. Returns false if no row has the safety. */
static bool shortest(struct planner *p, size_t fewest, int k, struct choice *best)
{
    dom_real length = (dom_real)INFINITY, engine_seconds = DOM_NAN;
    size_t longer = 0, longer_most = p->wish->engine ? LONGER_IN_ENGINE : LONGER;
    for (size_t n = fewest; n <= fewest + MORE && longer < longer_most && p->status == DOM_OK;
         n = steps_next(p, fewest, n)) {
        if (length_of(p, (struct choice){0, n}) >= length)
            break;
        struct choice c = {nearest(p, n, k, GRID, STEP, enough), n};
        if (c.k > 0)
            c.k = closest(p, n, c.k);
        if (c.k > 0 && p->wish->engine)
            c.k = nearest(p, n, c.k, widest(p, n, length), STEP_OF_ENGINE, enough_in_engine);
        bool shorter = c.k > 0 && length_of(p, c) < length;
        longer = shorter || !isfinite(length) ? 0 : longer + 1;
        if (shorter) {
            *best = c;
            length = length_of(p, c);
            engine_seconds = p->engine_seconds;
        }
    }
    p->engine_seconds = engine_seconds;
    return p->status == DOM_OK && isfinite(length);
}

/* Finds the row with the fewest dominoes that has the safety and fits into the hall. Returns false if there
 * is no such row. */
static bool fewest_that_fits(struct planner *p, size_t fewest, int k, struct choice *best)
{
    for (size_t n = fewest; n <= fewest + MORE && p->status == DOM_OK; n = steps_next(p, fewest, n)) {
        int most = widest(p, n, p->wish->hall);
        if (most <= 0) /* a row with more dominoes does not fit either */
            return false;
        *best = (struct choice){nearest(p, n, k, most, STEP, enough), n};
        if (best->k > 0 && p->wish->engine)
            best->k = nearest(p, n, best->k, most, STEP_OF_ENGINE, enough_in_engine);
        if (best->k > 0)
            return true;
    }
    return false;
}

/* Returns the weakest push with which the row has the safety, with a relative tolerance of 1e-4. Returns NaN
 * if no push was found. */
static dom_real push_enough(struct planner *p, struct choice c)
{
    dom_real hi = isnan(p->wish->push) ? sqrt(p->wish->g / p->wish->first) / 16 : p->wish->push, lo = 0;
    for (int i = 0; i < 16 && row_ratio(p, c, hi, false) < p->wish->safety; i++) {
        lo = hi;
        hi *= 2;
    }
    if (!(row_ratio(p, c, hi, false) >= p->wish->safety))
        return DOM_NAN;
    while (hi - lo > (dom_real)1e-4 * hi && p->status == DOM_OK) {
        dom_real middle = (lo + hi) / 2;
        *(row_ratio(p, c, middle, false) >= p->wish->safety ? &hi : &lo) = middle;
    }
    return hi;
}

/* Returns the largest ratio of kinetic energy to barrier that a train of any separation and growth has. That
 * is the ratio of a train of equal dominoes (r = 1). */
static dom_real safety_most(struct planner *p)
{
    dom_real most = 0;
    for (int k = COARSE / 2; k <= GRID; k += COARSE / 2)
        most = fmax(most, train_ratio(p, separation(k), 1));
    return most;
}

/* Computes the chosen row with the requested precision, and fills the design with the result. */
static void design_fill(struct planner *p, struct choice c, const struct dom_compute *compute,
                        struct dom_design *design)
{
    p->compute = *compute;
    dom_real train = train_ratio(p, separation(c.k), growth(p, c.steps));
    dom_real row = row_ratio(p, c, p->wish->push, true);
    design->s = separation(c.k);
    design->r = growth(p, c.steps);
    design->steps = c.steps;
    design->feet = feet_of(p, c.steps, design->s);
    design->length = length_of(p, c);
    design->train = train > 0 ? train : DOM_NAN;
    design->row = row > 0 ? row : DOM_NAN;
    design->weakest = p->weakest;
    design->seconds = p->wish->engine ? p->engine_seconds : p->seconds;
}

static void design_search(struct planner *p, const struct dom_compute *compute, struct dom_design *design)
{
    struct choice c = {0, 0};
    int k;
    dom_real most = separation_find(p, &k);
    if (most == 0) {
        design->limit = DOM_DESIGN_SAFETY;
        design->needs = safety_most(p);
        return;
    }
    size_t fewest = 1;
    while (growth(p, fewest) > most && fewest < (size_t)MORE * MORE)
        fewest++;
    bool fits = p->wish->least != DOM_LEAST_LENGTH && fewest_that_fits(p, fewest, k, &c);
    bool searched = p->wish->least != DOM_LEAST_LENGTH && isinf(p->wish->hall);
    if (!fits && !searched && shortest(p, fewest, k, &c)) {
        fits = length_of(p, c) <= p->wish->hall;
        design->limit = fits ? DOM_DESIGN_FITS : DOM_DESIGN_HALL;
        design->needs = fits ? DOM_NAN : length_of(p, c);
    } else if (!fits && p->engine_refused) {
        design->limit = DOM_DESIGN_ENGINE;
    } else if (!fits && p->status == DOM_OK) {
        design->limit = DOM_DESIGN_START;
        design->needs = push_enough(p, (struct choice){k, fewest});
    }
    if (fits && p->status == DOM_OK)
        design_fill(p, c, compute, design);
}

enum dom_status dom_design_find(const struct dom_train *train, const struct dom_wish *wish,
                                const struct dom_compute *compute, struct dom_design *design)
{
    struct dom_compute final = compute_or_default(compute);
    final.errors = false;
    final.method = DOM_METHOD_OURS;
    struct planner p = {.train = *train, .compute = final, .wish = wish, .status = DOM_OK};
    if (!(wish->first > 0 && wish->height > wish->first && isfinite(wish->height / wish->first)))
        return DOM_BAD_HEIGHT;
    if (!(wish->safety > 1 && isfinite(wish->safety)))
        return DOM_BAD_SAFETY;
    if (!(wish->hall > wish->height))
        return DOM_BAD_HALL;
    if (!(wish->g > 0 && isfinite(wish->g)))
        return DOM_BAD_G;
    if (wish->push < 0 || isinf(wish->push))
        return DOM_BAD_PUSH;
    p.train.s = separation(GRID / 2);
    p.train.r = 1;
    struct question q = question_make(&p.train, &p.compute);
    struct dom_angles angles;
    p.status = ASK(q, angles_find, &angles);
    p.compute.precision = DOM_DOUBLE;
    p.compute.tol = dom_arithmetic(DOM_DOUBLE)->tol_default;
    struct dom_design found = {.s = DOM_NAN,
                               .r = DOM_NAN,
                               .feet = DOM_NAN,
                               .length = DOM_NAN,
                               .seconds = DOM_NAN,
                               .train = DOM_NAN,
                               .row = DOM_NAN,
                               .needs = DOM_NAN};
    if (p.status == DOM_OK)
        design_search(&p, &final, &found);
    bool remedy = found.limit == DOM_DESIGN_HALL || (found.limit == DOM_DESIGN_START && !isnan(found.needs));
    if (found.limit != DOM_DESIGN_FITS && !remedy && p.failed > 0) {
        found.limit = DOM_DESIGN_FAILED;
        found.needs = p.failed;
    }
    if (p.status == DOM_OK)
        *design = found;
    free(p.domino);
    return p.status;
}
