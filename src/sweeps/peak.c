/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "sweeps/peak.h"
#include "domino_quad.h"
#include <float.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_min.h>
#include <math.h>

struct spot {
    double x, value;
};

struct search {
    const struct slope *slope;
    const double *value;
    size_t count;
    struct spot best;
    double lowest; /* the smallest value of all points */
    bool is_edge;  /* `best` was found by bisection, beside a place without a value */
};

size_t peak_points(const struct slope *s, size_t most)
{
    const double span = s->to - s->from;
    return s->whole && span < (double)most ? (size_t)span + 1 : most;
}

double peak_point(const struct slope *s, size_t count, size_t k)
{
    const double part = count > 1 ? (double)k / (double)(count - 1) : 0,
                 x = k + 1 == count ? s->to : (1 - part) * s->from + part * s->to;
    return s->whole ? round(x) : x;
}

static double x_of(const struct search *s, size_t k)
{
    return peak_point(s->slope, s->count, k);
}

static double value_at(const struct search *s, double x)
{
    return s->slope->at(x, s->slope->context);
}

/* Makes x the best place if its value is the largest so far. */
static void consider(struct spot *best, double x, double value)
{
    if (isfinite(value) && !(value <= best->value))
        *best = (struct spot){x, value};
}

/* Finds by bisection where the values end. Returns the place with a value next to this end. */
static struct spot edge_find(const struct search *s, struct spot good, double bad)
{
    enum { HALVINGS = 44 };
    for (int i = 0; i < HALVINGS && !dom_raised(s->slope->interrupt); i++) {
        double middle = (good.x + bad) / 2;
        middle = s->slope->whole ? floor(middle) : middle;
        if (middle == good.x || middle == bad)
            break;
        const double value = value_at(s, middle);
        if (isnan(value))
            bad = middle;
        else
            good = (struct spot){middle, value};
    }
    return good;
}

/* ---- One maximum ---- */

/* For GSL, which looks for a minimum. A place without a value is as bad as the worst point. */
static double negative(double x, void *context)
{
    const struct search *s = context;
    const double value = value_at(s, x);
    return isnan(value) ? -s->lowest : -value;
}

/* Follows a maximum whose value m is larger than those at a and b. */
static struct spot brent(struct search *s, struct spot a, struct spot m, struct spot b)
{
    enum { STEPS = 60 };
    gsl_min_fminimizer *solver = gsl_min_fminimizer_alloc(gsl_min_fminimizer_brent);
    gsl_function f = {.function = negative, .params = s};
    double low = a.x, high = b.x;
    const double least = s->slope->least * (s->slope->to - s->slope->from);
    if (solver && gsl_min_fminimizer_set_with_values(solver, &f, m.x, -m.value, a.x, -a.value, b.x,
                                                     -b.value) == GSL_SUCCESS)
        for (int i = 0; i < STEPS && gsl_min_test_interval(low, high, least, 0) == GSL_CONTINUE &&
                        !dom_raised(s->slope->interrupt);
             i++) {
            if (gsl_min_fminimizer_iterate(solver) != GSL_SUCCESS)
                break;
            low = gsl_min_fminimizer_x_lower(solver);
            high = gsl_min_fminimizer_x_upper(solver);
            const double x = gsl_min_fminimizer_x_minimum(solver);
            consider(&m, x, -gsl_min_fminimizer_f_minimum(solver));
        }
    gsl_min_fminimizer_free(solver);
    return m;
}

/* Takes all whole numbers from `low` to `high`. */
static struct spot whole_find(const struct search *s, struct spot best, double low, double high)
{
    for (double x = low; x <= high && !dom_raised(s->slope->interrupt); x++)
        consider(&best, x, value_at(s, x));
    return best;
}

/* Looks for a place between `top` and `next` with a larger value than `top`. The value at `next` is not
 * larger than at `top`. The maximum can lie between them if `top` is at the end of the values, or if the
 * places on its two sides are equally high. Then the values rise beside `top`, and halving the distance to
 * `top` finds such a place. */
static bool rise_find(const struct search *s, struct spot top, struct spot next, struct spot *found)
{
    enum { HALVINGS = 16 };
    double part = ldexp(1, -HALVINGS);
    if (!(value_at(s, top.x + part * (next.x - top.x)) > top.value))
        return false;
    for (part = 0.5; part >= ldexp(1, -HALVINGS) && !dom_raised(s->slope->interrupt); part /= 2) {
        const double x = top.x + part * (next.x - top.x);
        *found = (struct spot){x, value_at(s, x)};
        if (found->value > top.value)
            return true;
    }
    return false;
}

/* Looks for the maximum between a and b, among which m has the largest value. Either may be m itself. */
static struct spot between(struct search *s, struct spot a, struct spot m, struct spot b)
{
    enum { SIDE = 4, ALL = 2 * SIDE + 3 };
    struct spot p[ALL], best = {m.x, m.value}, inside;
    int count = 0, top = 0;
    p[count++] = a;
    for (int side = 0; side < 2; side++) {
        const struct spot from = side ? m : a, to = side ? b : m;
        for (int i = 1; i <= SIDE && from.x < to.x; i++) {
            const double x = from.x + (to.x - from.x) * i / (SIDE + 1), value = value_at(s, x);
            if (isfinite(value))
                p[count++] = (struct spot){x, value};
        }
        if (from.x < to.x)
            p[count++] = to;
    }
    for (int i = 0; i < count; i++) {
        consider(&best, p[i].x, p[i].value);
        top = p[i].value > p[top].value ? i : top;
    }
    if (top > 0 && top + 1 < count && p[top].value > p[top - 1].value && p[top].value > p[top + 1].value)
        return brent(s, p[top - 1], p[top], p[top + 1]);
    if (top > 0 && (top + 1 == count || p[top - 1].value == p[top].value) &&
        rise_find(s, p[top], p[top - 1], &inside))
        return brent(s, p[top - 1], inside, p[top]);
    if (top + 1 < count && (top == 0 || p[top + 1].value == p[top].value) &&
        rise_find(s, p[top], p[top + 1], &inside))
        return brent(s, p[top], inside, p[top + 1]);
    return best;
}

/* Returns the neighbour of point k on one side: the next point, or the end of the values before it. */
static struct spot neighbour(const struct search *s, size_t k, int side, bool *is_edge)
{
    const struct spot here = {x_of(s, k), s->value[k]};
    *is_edge = false;
    if (side < 0 ? k == 0 : k + 1 == s->count)
        return here;
    const size_t next = side < 0 ? k - 1 : k + 1;
    *is_edge = isnan(s->value[next]);
    return *is_edge ? edge_find(s, here, x_of(s, next)) : (struct spot){x_of(s, next), s->value[next]};
}

/* Looks around point k. */
static void look_around(struct search *s, size_t k)
{
    bool left, right;
    const struct spot a = neighbour(s, k, -1, &left), b = neighbour(s, k, 1, &right);
    struct spot m = {x_of(s, k), s->value[k]}, found;
    found = s->slope->whole ? whole_find(s, m, a.x, b.x) : between(s, a, m, b);
    if (found.value <= s->best.value)
        return;
    s->best = found;
    s->is_edge = (left && found.x == a.x) || (right && found.x == b.x);
}

/* ---- What is around the best place ---- */

/* Returns the largest difference of two values that counts as none. */
static double alike(const struct search *s)
{
    return s->slope->noise * fabs(s->best.value);
}

static bool is_best(const struct search *s, double x)
{
    return value_at(s, x) >= s->best.value - alike(s);
}

/* Returns how far the plateau reaches on one side. */
static double plateau_end(const struct search *s, int side)
{
    const double least = s->slope->whole ? 0 : s->slope->least * (s->slope->to - s->slope->from);
    double good = s->best.x, bad = side < 0 ? s->slope->from : s->slope->to;
    for (size_t i = 0; i < s->count; i++) {
        const size_t k = side < 0 ? s->count - 1 - i : i;
        const double x = x_of(s, k);
        if (side < 0 ? x >= good : x <= good)
            continue;
        bad = x;
        if (!(s->value[k] >= s->best.value - alike(s)))
            break;
        good = x;
    }
    while (fabs(good - bad) > least && !dom_raised(s->slope->interrupt)) {
        double middle = (good + bad) / 2;
        middle = s->slope->whole ? (side < 0 ? ceil(middle) : floor(middle)) : middle;
        if (middle == good || middle == bad)
            break;
        *(is_best(s, middle) ? &good : &bad) = middle;
    }
    if (s->slope->whole && good != bad && is_best(s, bad))
        good = bad;
    return good;
}

/* Finds the plateau around the best place, and returns false if there is none: all values on a plateau are
 * alike, which some places within it confirm. */
static bool plateau_find(const struct search *s, struct peak *p, bool before, bool after)
{
    enum { PARTS = 8 };
    const double low = before ? plateau_end(s, -1) : p->x, high = after ? plateau_end(s, 1) : p->x;
    for (int i = 1; i < PARTS && !s->slope->whole; i++) {
        const double x = low + (high - low) * i / PARTS;
        if (!(fabs(value_at(s, x) - p->value) <= alike(s)))
            return false;
    }
    p->low = low;
    p->high = high;
    return low < high;
}

/* Finds the plateau around the best place, if there is one, or how far this place may be off. */
static void around(const struct search *s, struct peak *p)
{
    const struct slope *f = s->slope;
    const double cell = (f->to - f->from) / (double)(s->count > 1 ? s->count - 1 : 1);
    double step = f->whole ? 1 : 0.05 * cell;
    const double before = f->from <= p->x - step ? value_at(s, p->x - step) : (double)NAN,
                 after = p->x + step <= f->to ? value_at(s, p->x + step) : (double)NAN,
                 worst = p->value - alike(s);
    if ((before >= worst || after >= worst) && plateau_find(s, p, before >= worst, after >= worst)) {
        double middle = (p->low + p->high) / 2;
        middle = f->whole ? floor(middle) : middle;
        if (is_best(s, middle))
            p->x = middle;
        return;
    }
    if (f->whole || p->end == PEAK_AT_FROM || p->end == PEAK_AT_TO)
        return;
    if (s->is_edge) {
        p->within = 1e-9 * cell;
        return;
    }
    /* Near a maximum the value falls as the square of the distance. So values that are wrong by their noise
     * move the place by the distance at which the value has fallen by this noise. */
    step = fmin(step, fmin(p->x - f->from, f->to - p->x));
    for (int i = 0; i < 40; i++, step /= 2) {
        const double drop = p->value - (value_at(s, p->x - step) + value_at(s, p->x + step)) / 2;
        if (!isfinite(drop))
            continue;
        p->within = drop > 0 ? step * sqrt(fmin(alike(s) / drop, 1)) : step;
        p->within = fmax(p->within, f->least * (f->to - f->from));
        p->off += fabs(drop) * pow(p->within / step, 2);
        break;
    }
}

/* Returns where the best place, or its plateau, lies. */
static enum peak_end end_of(const struct search *s, double x)
{
    const double h = s->slope->whole ? 1 : fmax(1e-9, 2 * s->slope->least) * (s->slope->to - s->slope->from);
    return x - s->slope->from < h / 2  ? PEAK_AT_FROM
           : s->slope->to - x < h / 2  ? PEAK_AT_TO
           : isnan(value_at(s, x + h)) ? PEAK_BEFORE_HOLE
           : isnan(value_at(s, x - h)) ? PEAK_AFTER_HOLE
                                       : PEAK_INSIDE;
}

/* For a plateau, returns on which side there is a hole. An end of the interval does not count. */
static enum peak_end plateau_ends(const struct search *s, const struct peak *p)
{
    const enum peak_end low = end_of(s, p->low), high = end_of(s, p->high);
    return high == PEAK_BEFORE_HOLE ? high : low == PEAK_AFTER_HOLE ? low : PEAK_INSIDE;
}

struct peak peak_find(const struct slope *slope, const double *value, size_t count, bool is_rough)
{
    struct search s = {
        .slope = slope, .value = value, .count = count, .best = {(double)NAN, -HUGE_VAL}, .lowest = HUGE_VAL};
    for (size_t k = 0; k < count; k++)
        s.lowest = fmin(s.lowest, value[k]);
    for (size_t k = 0; k < count && !dom_raised(slope->interrupt); k++) {
        const double left = k > 0 ? value[k - 1] : (double)NAN, here = value[k],
                     right = k + 1 < count ? value[k + 1] : (double)NAN;
        /* On a plateau, only its first and its last point have neighbours that may lead to a larger value. */
        if (!isnan(here) && !(left > here) && !(right > here) && !(left == here && right == here))
            look_around(&s, k);
    }
    struct peak p = {.x = s.best.x, .value = s.best.value, .low = s.best.x, .high = s.best.x};
    if (isnan(p.x))
        p.value = (double)NAN;
    if (isnan(p.x) || is_rough || dom_raised(slope->interrupt))
        return p;
    p.end = end_of(&s, p.x);
    p.off = alike(&s);
    around(&s, &p);
    if (p.low < p.high)
        p.end = plateau_ends(&s, &p);
    return p;
}
