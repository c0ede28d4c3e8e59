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

/* The search for the best separation begins with multiples of COARSE. The search for a row takes steps of
 * STEP. */
enum { GRID = 1000, COARSE = 20, STEP = 10 };

/*
 * A search begins with the smallest number of dominoes that may suffice. It adds at most MORE dominoes. If no
 * row fits into the hall, it ends earlier, after LONGER successive numbers with which no shorter row is
 * found.
 */
enum { MORE = 30, LONGER = 8 };

/* The state of a search for a design. If an error occurs, `status` is set to a value other than DOM_OK. From
 * then on, nothing more is computed, and every test fails. */
struct planner {
    struct dom_train train;
    struct dom_compute compute; /* settings of the search */
    const struct dom_wish *wish;
    const struct dom_limits *limits; /* the sizes that the dominoes may have, or NULL if any are allowed */
    enum dom_status status;
    /* ---- The candidate: a row of steps + 1 dominoes with the separation k / GRID ---- */
    double k;
    size_t steps;
    double push, hall;  /* its push, and the length into which it must fit */
    struct dom_row row; /* the last candidate that was written, with the dominoes `domino` */
    struct dom_domino *domino;
    /* number of the weakest domino in the last run, counted from 1: the domino with the smallest ratio of
     * kinetic energy to barrier; the first domino does not count, because its energy depends on the push */
    size_t weakest;
    double least;   /* ratio of kinetic energy to barrier of `weakest` */
    double seconds; /* duration of the last run */
};

/* Returns the growth that leads from the first height to the last in p->steps steps. */
static double growth_of(const struct planner *p)
{
    return pow(p->wish->height / p->wish->first, 1 / (double)p->steps);
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

/* Makes the row p->row of the candidate. If memory is exhausted, or if the walls do not fit into a domino,
 * sets p->status and returns false. */
static bool row_write(struct planner *p)
{
    const struct dom_wish *wish = p->wish;
    const size_t count = p->steps + 1;
    free(p->domino);
    struct dom_domino *const d = p->domino = malloc(count * sizeof *d);
    if (!d) {
        p->status = DOM_NO_MEMORY;
        return false;
    }
    const struct dom_scale scale = {.h = wish->first, .g = wish->g};
    p->train.s = p->k / GRID;
    p->train.r = growth_of(p);
    /* In air the masses count: with the density 1, the ratio of the densities is the density of the air. */
    const double mass =
        p->train.air != 0 ? wish->first * wish->first * wish->first * p->train.d * p->train.width : 1;
    dom_row_of_train(&p->train, &scale, mass, d, count);
    d[p->steps].height = wish->height;
    d[p->steps].width = p->train.width * wish->height;
    struct dom_row *const row = &p->row;
    *row = (struct dom_row){
        .domino = d, .count = count, .g = wish->g, .push = p->push, .release = wish->release};
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

/* Runs the candidate, which must have been written. Returns the smallest ratio of kinetic energy to barrier
 * among the dominoes after the first. If the row does not fall, returns 0. */
static double row_ratio(struct planner *p, bool times)
{
    struct dom_verdict verdict = {.end = DOM_ROW_STOPS};
    struct dom_compute compute = p->compute;
    enum dom_status status = p->status;
    if (status != DOM_OK)
        return 0;
    do {
        p->least = HUGE_VAL;
        p->weakest = 0;
        status = dom_row_run(&p->row, &compute, times, ratio_seen, p, &verdict);
    } while (status != DOM_OK && tried_again(p, status, &compute));
    p->seconds = verdict.seconds;
    return status == DOM_OK && verdict.end == DOM_ROW_FALLS ? p->least : 0;
}

/* Writes the candidate, and returns its length while it stands, from the back of the first domino to the
 * front of the last. After an error, returns infinity. */
static double feet_of(struct planner *p)
{
    double sum = 0;
    if (!row_write(p))
        return HUGE_VAL;
    for (size_t k = 0; k < p->row.count; k++)
        sum += p->domino[k].gap + p->domino[k].thickness;
    return sum;
}

/* ---- Tests of a candidate, each an edge_test ---- */

/* Returns true if the candidate with this k fits into the hall, and if both the candidate and an endless
 * train of such dominoes are safe enough. */
static bool gaps_enough(double k, double *spare, void *planner)
{
    struct planner *p = planner;
    const double safety = p->wish->safety;
    (void)spare;
    p->k = k;
    return train_ratio(p, k / GRID, growth_of(p)) >= safety && feet_of(p) + p->wish->height <= p->hall &&
           row_ratio(p, false) >= safety;
}

/* Returns true if the candidate is enough with this push. */
static bool push_enough(double push, double *spare, void *planner)
{
    struct planner *p = planner;
    p->push = push;
    return gaps_enough(p->k, spare, planner);
}

/* Returns true if a train with the growth r is safe at some separation. Finds the separation at which it is
 * safest: first takes coarse steps over all separations, down from the widest gap within reach, and then,
 * from the best one, ever smaller steps to both sides. If the train is safe there, keeps this separation. */
static bool growth_enough(double r, double *spare, void *planner)
{
    struct planner *p = planner;
    const int widest = (int)(GRID / r);
    int best = 0;
    *spare = 0;
    for (int step = COARSE, from = 0; step > 0; from = best) {
        const bool all = step == COARSE;
        for (int k = all ? widest : from + step; k > 0 && k >= from - step;
             k = all ? (k - 1) / step * step : k - 2 * step) {
            const double ratio = train_ratio(p, (double)k / GRID, r);
            if (ratio > *spare) {
                *spare = ratio;
                best = k;
            }
        }
        step = all || best == from ? step / 2 : step;
    }
    if (*spare >= p->wish->safety)
        p->k = best;
    return *spare >= p->wish->safety;
}

/* ---- Designs ---- */

/* Returns the k nearest to `best`, in steps of STEP, with which a row is safe, however long. Returns 0 if
 * there is none. */
static double nearest(struct planner *p, double best)
{
    p->hall = HUGE_VAL;
    for (double away = 0; p->status == DOM_OK && (away < best || best + away <= GRID); away += STEP)
        for (int side = -1; side <= (away > 0 ? 1 : -1); side += 2) {
            const double k = best + side * away;
            if (k > 0 && k <= GRID && gaps_enough(k, NULL, p))
                return k;
        }
    return 0;
}

/*
 * Finds the row with the fewest dominoes that is safe enough and fits into the hall, with k near p->k, and
 * makes it the candidate. Only rows with at least p->steps steps are tried. Returns the length of the row. If
 * no row fits, the candidate stays as it was, and the result is the length of the shortest row that is safe
 * enough, or infinity.
 */
static double row_search(struct planner *p)
{
    const size_t fewest = p->steps;
    const double best = p->k, height = p->wish->height;
    double shortest = HUGE_VAL;
    for (size_t longer = 0; p->steps <= fewest + MORE && longer < LONGER && p->status == DOM_OK; p->steps++) {
        double bad = 0, wide = nearest(p, best), k = wide;
        bool fits = k > 0 && feet_of(p) + height <= p->wish->hall;
        if (k > 0 && !fits) { /* narrow the gaps as far as the row stays safe, then only as far as needed */
            p->k = k = edge_find(gaps_enough, p, k, &bad, 1, 0);
            p->hall = p->wish->hall;
            fits = feet_of(p) + height <= p->hall;
            if (fits)
                p->k = edge_find(gaps_enough, p, k, &wide, 1, 0);
        }
        const double length = k > 0 && p->status == DOM_OK ? feet_of(p) + height : HUGE_VAL;
        if (fits)
            return length;
        longer = length < shortest || isinf(shortest) ? 0 : longer + 1;
        shortest = fmin(shortest, length);
    }
    p->k = best;
    p->steps = fewest;
    return shortest;
}

/* Finds a row, and makes it the candidate. If none is found, `limit` and `needs` of *found say why. */
static void design_search(struct planner *p, struct dom_design *found)
{
    const struct dom_wish *wish = p->wish;
    double most = GRID;
    if (!growth_enough(1, &found->needs, p)) {
        /* The largest ratio that any train can have is that of equal dominoes. */
        found->limit = DOM_DESIGN_SAFETY;
        return;
    }
    found->needs = DOM_NAN;
    most = edge_find(growth_enough, p, 1, &most, 0, 1e-7);
    for (p->steps = wish->dominoes > 2 ? wish->dominoes - 1 : 1;
         growth_of(p) > most && p->steps < (size_t)MORE * MORE;)
        p->steps++;
    const double length = row_search(p);
    if (length <= wish->hall && isfinite(length))
        return;
    found->limit = isfinite(length) ? DOM_DESIGN_HALL : DOM_DESIGN_START;
    found->needs = isfinite(length) ? length : DOM_NAN;
    if (isfinite(length))
        return;
    /* Find the weakest push with which the row is safe, however long, by doubling it. */
    double push = wish->push > 0 ? wish->push : sqrt(wish->g / wish->first) / 16, weak = 0;
    p->hall = HUGE_VAL;
    for (int i = 0; i <= 16 && isnan(found->needs); i++, weak = push, push *= 2)
        if (push_enough(push, NULL, p))
            found->needs = edge_find(push_enough, p, push, &weak, 0, 1e-4);
}

enum dom_status dom_design_find(const struct dom_train *train, const struct dom_wish *wish,
                                const struct dom_limits *limits, const struct dom_compute *compute,
                                struct dom_design *design, struct dom_domino **domino)
{
    const struct dom_compute final = compute_or_default(compute);
    struct planner p = {
        .train = *train, .compute = final, .wish = wish, .limits = limits, .push = wish->push};
    struct dom_angles angles;
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
    p.status = !(wish->first > 0 && wish->height > wish->first && isfinite(wish->height / wish->first))
                   ? DOM_BAD_HEIGHT
               : !(wish->safety > 1 && isfinite(wish->safety)) ? DOM_BAD_SAFETY
               : !(wish->hall > wish->height)                  ? DOM_BAD_HALL
               : !(wish->g > 0 && isfinite(wish->g))           ? DOM_BAD_G
               : wish->push < 0 || isinf(wish->push)           ? DOM_BAD_PUSH
               : !(wish->release >= 0)                         ? DOM_BAD_RELEASE
               : limits && limits_check(limits) != DOM_OK      ? limits_check(limits)
                                                               : dom_angles_find(&p.train, &final, &angles);
    p.compute.tol = dom_arithmetic()->tol_default;
    if (p.status == DOM_OK)
        design_search(&p, &found);
    const bool is_found = p.status == DOM_OK && found.limit == DOM_DESIGN_FITS;
    if (is_found) {
        p.compute = final; /* the answer has the requested tolerance */
        found.s = p.k / GRID;
        found.r = growth_of(&p);
        found.steps = p.steps;
        found.train = train_ratio(&p, found.s, found.r);
        found.feet = feet_of(&p);
        found.row = row_ratio(&p, true);
        found.weakest = p.weakest;
        found.seconds = p.seconds;
        found.length = found.feet + wish->height;
        /* in air, the search computes with a density of 1 */
        for (size_t k = p.steps + 1; p.status == DOM_OK && k-- > 0;)
            p.domino[k].mass /= p.domino->mass;
    }
    if (p.status == DOM_OK)
        *design = found;
    if (p.status == DOM_OK && domino)
        *domino = is_found ? p.domino : NULL;
    if (p.status != DOM_OK || !domino || !is_found)
        free(p.domino);
    return p.status;
}
