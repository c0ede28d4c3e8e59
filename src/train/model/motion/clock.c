/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The time of a motion is the integral of the slowness 1/(tau omega) over the tilt.
 *
 * A clock stores the time as a Chebyshev series, not in the tilt, but in a variable x in which the time is
 * smooth. The slowness is infinite where the head starts or comes to rest, and it has a peak at the top of a
 * barrier. Let lo and `to` be the first and the last tilt. The tilt is
 *
 *     lo + (to - lo) sin^2 x       for a motion that starts at rest,
 *     lo + (to - lo) (2 x - x^2)   for a motion that only comes to rest,
 *     theta_m + width sinh x       for any other motion.
 *
 * The tilt at a given time is a root of the series.
 */
#include "motion/motion.h"

/* Very near a rest, the time hardly changes with x, and the energy would underflow. So the distance of x from
 * a rest is at least CLOSEST. */
#define CLOSEST sqrt(REAL_EPSILON)

/* Finds x at a tilt. */
static real clock_place(const struct clock *c, real theta)
{
    const real lo = c->segment->lo, part = fmin(fmax((theta - lo) / (c->to - lo), 0), 1);
    if (c->segment->start.omegasq == 0)
        return asin(sqrt(part));
    return c->rests ? part / (1 + sqrt(1 - part)) : asinh((theta - c->segment->barrier.theta_m) / c->width);
}

/* Finds dt/dx. */
static bool clock_rate(real x, void *context, struct num_rate *rate)
{
    const struct clock *c = context;
    struct segment *st = c->segment;
    const struct geometry *geometry = &st->geometry;
    const real span = c->to - st->lo;
    real squared = REAL_NAN, theta, by;
    if (st->start.omegasq == 0) {
        const real sine = fmax(sin(x), CLOSEST);
        theta = st->lo + span * sine * sine;
        by = 2 * span * sine * cos(x);
        st->status = dynamics_near_rest(geometry, st->lo, -span * sine * sine, &squared);
    } else if (c->rests) {
        const real left = fmax(1 - x, CLOSEST);
        theta = st->lo + span * x * (2 - x);
        by = 2 * span * left;
        if (theta >= c->smooth)
            st->status =
                dynamics_near_rest(geometry, c->to, fmin(span * left * left, c->to - c->smooth), &squared);
    } else {
        const real grow = expm1(x), back = grow / (1 + grow); /* exp x - exp -x would lose digits near 0 */
        theta = st->barrier.theta_m + c->width * (grow + back) / 2;
        by = c->width * (2 + grow - back) / 2;
    }
    if (st->status == DOM_OK && isnan(squared)) {
        st->status = dynamics_speed(geometry, &st->start, fmin(fmax(theta, st->lo), c->to), &squared);
        squared = 1 / squared;
    }
    *rate = (struct num_rate){.c = by * sqrt(squared)};
    return st->status == DOM_OK;
}

/* Near a point of rest, there may be another one, which the head does not reach. If they are closer together
 * than this fraction of the motion, panels are short. */
#define REST_WIDTH ((real)1e-6)

/* Makes the series, in pieces. A piece ends at the next edge of the barrier. Towards a rest, pieces become
 * shorter by the factor 8, and after it longer. */
static enum num_status clock_make(struct clock *c)
{
    const struct segment *st = c->segment;
    const real span = c->to - st->lo, width = REST_WIDTH * span;
    enum num_status solver = NUM_OK;
    c->time.integral = true;
    c->time.panels = 0;
    for (real theta = st->lo, next; theta < c->to && solver == NUM_OK; theta = next) {
        next = c->to;
        for (int i = 0; i < st->barrier.edges; i++)
            if (st->barrier.edge[i] > fmax(theta, REAL_MIN))
                next = fmin(next, st->barrier.edge[i]);
        if (c->rests && c->to - theta > 8 * width)
            next = fmin(next, c->to - (c->to - theta) / 8);
        if (st->start.omegasq == 0)
            next = fmin(next, st->lo + fmax(8 * (theta - st->lo), width));
        const real lo = clock_place(c, theta), hi = clock_place(c, next);
        if (lo < hi)
            solver = num_linear_solve(clock_rate, c, lo, hi, c->tol, &c->time);
    }
    return solver;
}

/* Returns the relative error of times, which rounding errors cause. It is large if the energy is hardly
 * enough for the barrier or, for a motion that starts at rest, if hardly anything sets it in motion. */
static real clock_noise(const struct segment *st)
{
    const real kinetic = st->start.kinetic, spare = kinetic - st->barrier.height;
    real slope = 0;
    if (kinetic != 0 || spare != 0)
        return fabs(16 * REAL_EPSILON * kinetic / spare);
    return dynamics_slope(&st->geometry, st->start.from, false, &slope) == DOM_OK && slope < 0
               ? 16 * REAL_EPSILON * st->geometry.steepest / -slope
               : (real)INFINITY;
}

KERNEL_SHARED enum dom_status clock_begin(struct clock *c, struct segment *st, real to, bool rests, real tol)
{
    const struct barrier *b = &st->barrier;
    const real noise = clock_noise(st), tol_sums = st->geometry.tol, spare = st->start.kinetic - b->height;
    c->segment = st;
    c->to = to;
    c->rests = rests;
    c->tol = fmax(tol / 8, noise);
    c->smooth = st->lo;
    /* If H were a parabola, the kinetic energy would have its complex zeros at this distance from theta_m. */
    c->width = b->height > 0 ? (b->theta_m - st->lo) * sqrt(fmax(spare, 0) / b->height) : to - st->lo;
    if (!(noise < (real)0.125))
        return DOM_NO_MARGIN;
    for (int i = 0; i < b->edges; i++)
        if (b->edge[i] < to)
            c->smooth = fmax(c->smooth, b->edge[i]);
    /* sums jump where the number of dominoes in them changes; the jumps must not disturb the series */
    st->geometry.tol /= 8;
    st->status = DOM_OK;
    enum num_status solver;
    /* With losses, the speed may have fewer digits than the tolerance asks for. */
    while ((solver = clock_make(c)) == NUM_NOT_CONVERGED && c->tol < sqrt(REAL_EPSILON))
        c->tol *= 64;
    st->geometry.tol = tol_sums;
    return model_status(st->status, solver);
}

KERNEL_SHARED void clock_free(struct clock *c)
{
    num_linear_free(&c->time);
}

KERNEL_SHARED real clock_time(const struct clock *c, real theta)
{
    if (c->time.panels == 0)
        return 0;
    const real x = clock_place(c, theta);
    return num_linear_moved(&c->time, x, x - c->time.panel[0].lo);
}

/* A root is the tilt at which the clock shows the time that is sought. */
static real clock_early(real theta, void *context)
{
    const struct clock *c = context;
    return clock_time(c, theta) - c->sought;
}

KERNEL_SHARED enum dom_status clock_tilt(struct clock *c, real time, real *theta)
{
    c->sought = time;
    const enum num_status solver = num_root(clock_early, c, c->segment->lo, c->to, c->tol, theta);
    if (solver != NUM_NOT_BRACKETED)
        return model_status(DOM_OK, solver);
    *theta = time > 0 ? c->to : c->segment->lo;
    return DOM_OK;
}
