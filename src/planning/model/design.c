/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Designs a row whose first and last heights are given. The search finds a separation, a growth and a number
 * of dominoes. When a domino after the first is hit in the designed row, the moving dominoes have at least
 * `safety` times the energy that they need. The search uses the same computations as the public functions, so
 * their results agree.
 *
 * The separation s is a gap divided by the height of the domino after the gap. Only multiples of 1 / GRID are
 * tried: s = k / GRID. If k increases by 1, the gaps of the standard domino become 0.05 mm wider.
 */
#include "numerics/api.h"
#include "numerics/real.h"
#include "planning/model/shape.h"
#include "rows/model/boxes.h"
#include "search/search.h"
#include <stdlib.h>

/* In the first search, k is a multiple of COARSE. A search for a separation takes steps of STEP. */
enum { GRID = 1000, COARSE = 20, STEP = 10 };

/*
 * A search begins with the smallest number of dominoes that may suffice. It adds at most MORE dominoes. If no
 * row fits into the hall, it ends earlier, after LONGER successive numbers with which no shorter row is
 * found.
 */
enum { MORE = 30, LONGER = 8 };

/* A candidate row. Its separation is k / GRID, and it has steps + 1 dominoes. */
struct choice {
    int k;
    size_t steps;
};

/* The state of a search for a design. If an error occurs, `status` is set to a value other than DOM_OK. From
 * then on, nothing more is computed, and every test fails. */
struct planner {
    struct dom_train train;
    struct dom_compute compute; /* settings of the search */
    const struct dom_wish *wish;
    const struct dom_limits *limits; /* the sizes that the dominoes may have, or NULL if any are allowed */
    struct dom_row row;              /* the last candidate row, with the dominoes `domino` */
    struct dom_domino *domino;
    enum dom_status status;
    /* number of the weakest domino in the last run, counted from 1: the domino with the smallest ratio of
     * kinetic energy to barrier; the first domino does not count, because its energy depends on the push */
    size_t weakest;
    double least;         /* ratio of kinetic energy to barrier of `weakest` */
    double seconds;       /* duration of the last run */
    struct choice pushed; /* the row for which a push is searched */
};

/* Returns the growth that leads from the first height to the last in `steps` steps. */
static double growth_of(const struct planner *p, size_t steps)
{
    return pow(p->wish->height / p->wish->first, 1 / (double)steps);
}

/* ---- Kinetic energy relative to the barrier, for a train and for a row ---- */

/* A few digits can be found even if rounding errors exceed the usual tolerance. If this is why a computation
 * has failed, sets a larger tolerance in *compute and returns true. If it is already large, or after another
 * failure, ends the search. */
static bool tried_again(struct planner *p, enum dom_status status, struct dom_compute *compute)
{
    const double rougher = 1000, roughest = 1e-6;
    const bool imprecise = status == DOM_NOT_CONVERGED || status == DOM_NOT_FINITE;
    if (imprecise && compute->tol < roughest) {
        compute->tol = fmin(rougher * compute->tol, roughest);
        return true;
    }
    p->status = status;
    return false;
}

/* Returns the ratio of kinetic energy to barrier in an endless train. If there is no such ratio, for example
 * because the next domino is out of reach, returns 0. */
static double train_ratio(struct planner *p, double s, double r)
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

/* Makes the row p->row of a candidate. If memory is exhausted, or if the walls do not fit into a domino, sets
 * p->status and returns false. */
static bool row_write(struct planner *p, struct choice c)
{
    const struct dom_wish *wish = p->wish;
    const size_t count = c.steps + 1;
    free(p->domino);
    struct dom_domino *const d = p->domino = malloc(count * sizeof *d);
    if (!d) {
        p->status = DOM_NO_MEMORY;
        return false;
    }
    const struct dom_scale scale = {.h = wish->first, .g = wish->g};
    p->train.s = (double)c.k / GRID;
    p->train.r = growth_of(p, c.steps);
    /* In air the masses count: with the density 1, the ratio of the densities is the density of the air. */
    const double mass =
        p->train.air != 0 ? wish->first * wish->first * wish->first * p->train.d * p->train.width : 1;
    dom_row_of_train(&p->train, &scale, mass, d, count);
    d[c.steps].height = wish->height;
    d[c.steps].width = p->train.width * wish->height;
    struct dom_row *const row = &p->row;
    *row = (struct dom_row){
        .domino = d, .count = count, .g = wish->g, .push = wish->push, .release = wish->release};
#define VALUE(effect, member, status) row->member = p->train.member;
    DOM_DYNAMICS(VALUE)
#undef VALUE
    row->walls *= wish->first; /* converts the thickness of walls from multiples of the first height to m */
    if (wish->boxes_above > 0) {
        row->walls = wish->walls;
        row->boxes_above = wish->boxes_above;
    }
    for (size_t k = 0; row->boxes_above > 0 && k < count; k++) {
        d[k].mass = mass * wood_volume(row, &d[k]) / wood_volume(row, d);
        if (!(d[k].mass > 0)) {
            p->status = DOM_NO_ROOM;
            return false;
        }
    }
    if (p->limits)
        shape_round(&(struct shape){row, p->limits}, count, d);
    return true;
}

/* Records the smallest ratio of kinetic energy to barrier so far. */
static bool ratio_seen(const struct dom_fall *fall, void *context)
{
    struct planner *p = context;
    double ratio = fall->barrier > 0 ? fall->kinetic / fall->barrier : HUGE_VAL;
    if (fall->domino > 1 && !(ratio >= p->least)) {
        p->least = ratio;
        p->weakest = fall->domino;
    }
    return true;
}

/* Writes a candidate row and runs it. Returns the smallest ratio of kinetic energy to barrier among the
 * dominoes after the first. If the row does not fall, returns 0. */
static double row_ratio(struct planner *p, struct choice c, double push, bool times)
{
    struct dom_verdict verdict = {.end = DOM_ROW_STOPS};
    if (p->status != DOM_OK || !row_write(p, c))
        return 0;
    p->row.push = push;
    struct dom_compute compute = p->compute;
    enum dom_status status;
    do {
        p->least = HUGE_VAL;
        p->weakest = 0;
        status = dom_row_run(&p->row, &compute, times, ratio_seen, p, &verdict);
    } while (status != DOM_OK && tried_again(p, status, &compute));
    p->seconds = verdict.seconds;
    return status == DOM_OK && verdict.end == DOM_ROW_FALLS ? p->least : 0;
}

/* ---- Lengths, and tests of a candidate ---- */

/* Returns the length of the row p->row while it stands, from the back of the first domino to the front of the
 * last. */
static double feet_of(const struct planner *p)
{
    double sum = 0;
    for (size_t k = 0; k < p->row.count; k++)
        sum += p->domino[k].gap + p->domino[k].thickness;
    return sum;
}

/* Returns the largest k, up to GRID, for which a row with the separation k / GRID fits into the hall. If
 * there is none, returns 0. The dimensions of the row are not rounded to a grid. */
static int widest(const struct planner *p, size_t steps, double hall)
{
    const double r = growth_of(p, steps), first = p->wish->first;
    double heights = 0, height = first;
    for (size_t k = 0; k <= steps; k++, height *= r)
        heights += height;
    const double s = (hall - p->wish->height - p->train.d * heights) / (heights - first);
    return s >= 1 ? GRID : s > 0 ? (int)floor(s * GRID) : 0;
}

/* Returns true if the row is safe enough, and so is an endless train of such dominoes, and if the row fits
 * into the hall. */
static bool enough(struct planner *p, struct choice c, double hall)
{
    return train_ratio(p, (double)c.k / GRID, growth_of(p, c.steps)) >= p->wish->safety &&
           row_ratio(p, c, p->wish->push, false) >= p->wish->safety && feet_of(p) + p->wish->height <= hall;
}

/* ---- The separation ---- */

/* An edge_test: returns true if a train with the separation p->train.s and the growth r is safe. */
static bool growth_enough(double r, double *spare, void *planner)
{
    struct planner *p = planner;
    (void)spare;
    return train_ratio(p, p->train.s, r) >= p->wish->safety;
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
            double r = k > 0 && k <= GRID ? safe_growth(p, (double)k / GRID) : 0;
            if (r > most) {
                most = r;
                *best = k;
            }
        }
    }
    return most;
}

/* Searches for a separation k / GRID at which the row is safe and fits into the hall. Starts at k, or at the
 * largest separation that fits if k is larger. Moves away from there in both directions, in steps of STEP.
 * Returns the first k that is found, or 0 if there is none. */
static int nearest(struct planner *p, size_t steps, int k, double hall)
{
    const int most = widest(p, steps, hall), from = k < most ? k : most;
    for (int away = 0; p->status == DOM_OK && (from - away > 0 || from + away <= most); away += STEP)
        for (int side = -1; side <= (away ? 1 : -1); side += 2) {
            struct choice c = {from + side * away, steps};
            if (c.k > 0 && c.k <= most && enough(p, c, hall))
                return c.k;
        }
    return 0;
}

/* Narrows the gaps of a row that is safe with k = `good`, as long as it stays safe. Returns the smallest k,
 * or 0 if `good` is 0. */
static int closest(struct planner *p, size_t steps, int good)
{
    for (int step = COARSE / 2; step > 0 && good > 0;) {
        const struct choice closer = {good - step, steps};
        if (closer.k > 0 && enough(p, closer, HUGE_VAL))
            good = closer.k;
        else
            step /= 2;
    }
    return good;
}

/* ---- The number of dominoes ---- */

/*
 * Finds the row with the fewest dominoes that is safe enough and fits into the hall, with k near `best`. If
 * there is none, finds the shortest row that is safe enough. Only rows with at least `fewest` steps are
 * tried. Returns the length of the row, or infinity if no row is found.
 */
static double row_search(struct planner *p, size_t fewest, int best, struct choice *found)
{
    const double hall = p->wish->hall;
    double shortest = HUGE_VAL;
    size_t longer = 0;
    /* Beyond a certain number of dominoes, the row would be longer even without gaps. */
    for (size_t n = fewest; n <= fewest + MORE && longer < LONGER && widest(p, n, shortest) > 0; n++) {
        struct choice c = {nearest(p, n, best, hall), n};
        if (c.k == 0 && isfinite(hall))
            c.k = closest(p, n, nearest(p, n, best, HUGE_VAL));
        const double length = c.k > 0 && row_write(p, c) ? feet_of(p) + p->wish->height : HUGE_VAL;
        longer = length < shortest || isinf(shortest) ? 0 : longer + 1;
        if (length < shortest) {
            *found = c;
            shortest = length;
        }
        if (p->status != DOM_OK || (isfinite(shortest) && shortest <= hall))
            break;
    }
    return p->status == DOM_OK ? shortest : HUGE_VAL;
}

/* An edge_test: returns true if the row p->pushed is safe enough with this push. */
static bool push_enough(double push, double *spare, void *planner)
{
    struct planner *p = planner;
    (void)spare;
    return row_ratio(p, p->pushed, push, false) >= p->wish->safety;
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

/* ---- Designs ---- */

/* Finds a row. If none is found, returns a choice with k = 0, and says in `limit` and `needs` of *found
 * why. */
static struct choice design_search(struct planner *p, struct dom_design *found)
{
    const struct dom_wish *wish = p->wish;
    struct choice c = {0, 0};
    size_t fewest = wish->dominoes > 2 ? wish->dominoes - 1 : 1;
    int best;
    const double most = separation_find(p, &best);
    if (most == 0) {
        /* The largest ratio that any train can have is that of equal dominoes. This estimate is slightly too
         * low, because only some separations are tried. */
        found->limit = DOM_DESIGN_SAFETY;
        found->needs = 0;
        for (int k = COARSE / 2; k <= GRID; k += COARSE / 2)
            found->needs = fmax(found->needs, train_ratio(p, (double)k / GRID, 1));
        return c;
    }
    while (growth_of(p, fewest) > most && fewest < (size_t)MORE * MORE)
        fewest++;
    const double length = row_search(p, fewest, best, &c);
    if (length <= wish->hall && isfinite(length))
        return c;
    if (isfinite(length)) {
        found->limit = DOM_DESIGN_HALL;
        found->needs = length;
    } else if (p->status == DOM_OK) {
        found->limit = DOM_DESIGN_START;
        found->needs = push_find(p, (struct choice){best, fewest});
    }
    return (struct choice){0, 0};
}

/* Returns DOM_OK, or a status that says which argument is outside its range. */
static enum dom_status wish_check(const struct dom_train *train, const struct dom_wish *wish,
                                  const struct dom_limits *limits, const struct dom_compute *compute)
{
    struct dom_angles angles;
    return !(wish->first > 0 && wish->height > wish->first && isfinite(wish->height / wish->first))
               ? DOM_BAD_HEIGHT
           : !(wish->safety > 1 && isfinite(wish->safety)) ? DOM_BAD_SAFETY
           : !(wish->hall > wish->height)                  ? DOM_BAD_HALL
           : !(wish->g > 0 && isfinite(wish->g))           ? DOM_BAD_G
           : wish->push < 0 || isinf(wish->push)           ? DOM_BAD_PUSH
           : !(wish->release >= 0)                         ? DOM_BAD_RELEASE
           : limits && limits_check(limits) != DOM_OK      ? limits_check(limits)
                                                           : dom_angles_find(train, compute, &angles);
}

enum dom_status dom_design_find(const struct dom_train *train, const struct dom_wish *wish,
                                const struct dom_limits *limits, const struct dom_compute *compute,
                                struct dom_design *design, struct dom_domino **domino)
{
    const struct dom_compute final = compute_or_default(compute);
    struct planner p = {.train = *train, .compute = final, .wish = wish, .limits = limits};
    struct dom_design found = {.s = DOM_NAN,
                               .r = DOM_NAN,
                               .feet = DOM_NAN,
                               .length = DOM_NAN,
                               .seconds = DOM_NAN,
                               .train = DOM_NAN,
                               .row = DOM_NAN,
                               .needs = DOM_NAN};
    p.train.s = 0.5;
    p.train.r = 1;
    if (wish->boxes_above > 0)
        p.train.walls = 0; /* in a train, walls affect only the times, which are not needed */
    p.status = wish_check(&p.train, wish, limits, &final);
    p.compute.tol = dom_arithmetic()->tol_default;
    struct choice c = {0, 0};
    if (p.status == DOM_OK)
        c = design_search(&p, &found);
    if (p.status == DOM_OK && c.k > 0) {
        p.compute = final; /* the answer has the requested tolerance */
        found.s = (double)c.k / GRID;
        found.r = growth_of(&p, c.steps);
        found.steps = c.steps;
        found.train = train_ratio(&p, found.s, found.r);
        found.row = row_ratio(&p, c, wish->push, true);
        found.weakest = p.weakest;
        found.seconds = p.seconds;
        found.feet = feet_of(&p);
        found.length = found.feet + wish->height;
        for (size_t k = c.steps + 1; k-- > 0;) /* in air, the search computes with a density of 1 */
            p.domino[k].mass /= p.domino->mass;
    }
    const bool keeps = p.status == DOM_OK && domino;
    if (p.status == DOM_OK)
        *design = found;
    if (keeps)
        *domino = c.k > 0 ? p.domino : NULL;
    if (!keeps || c.k == 0)
        free(p.domino);
    return p.status;
}
