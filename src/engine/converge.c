/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Ends the iterations of Chipmunk's solver when they have converged. Chipmunk has no test for convergence: in
 * each step, it makes a fixed number of iterations. But in each iteration, it calls a function of every
 * constraint, and it reads the number of iterations again. So a constraint is added that applies no impulses
 * and only observes the velocities. When the velocities hardly change any more, the constraint ends the loop
 * by lowering the number of iterations.
 */
#include "world.h"
#include <math.h>

/* The largest number of iterations in a step. */
enum { MOST = 1000 };

/* Called before the first iteration. Gravity and the impulses of the previous step are already applied. */
static void before_first(cpConstraint *watch, double factor)
{
    struct world *w = watch->userData;
    (void)factor;
    for (size_t k = 0; k < w->count; k++)
        w->body[k].begin = w->body[k].now = world_motion(w, k);
    w->change = (double)NAN;
}

static double motion_change(const struct motion *a, const struct motion *b)
{
    return fmax(fmax(fabs(a->v.x - b->v.x), fabs(a->v.y - b->v.y)), fabs(a->turns - b->turns));
}

/*
 * Called in each iteration. Estimates how much the velocities would change in all further iterations
 * together, by assuming that the changes form a geometric series. If the estimate is a small fraction of the
 * change in the whole step, ends the loop.
 */
static void each(cpConstraint *watch, double dt)
{
    struct world *w = watch->userData;
    const double last = w->change;
    double whole = w->row->g * dt;
    w->change = 0;
    for (size_t k = 0; k < w->count; k++) {
        struct body *b = &w->body[k];
        const struct motion now = world_motion(w, k);
        w->change = fmax(w->change, motion_change(&now, &b->now));
        whole = fmax(whole, motion_change(&now, &b->begin));
        b->now = now;
    }
    const double ratio = w->change / last;
    if (w->change == 0 || w->change * ratio <= w->tolerance * (1 - ratio) * whole)
        w->cp->cpSpaceSetIterations(w->space, 1);
}

static void prepare(cpConstraint *watch, double dt)
{
    (void)watch, (void)dt;
}

static double no_impulse(cpConstraint *watch)
{
    (void)watch;
    return 0;
}

void converge_begin(struct world *w)
{
    static const struct cpConstraintClass class = {prepare, before_first, each, no_impulse};
    w->watch = (struct cpConstraint){.klass = &class,
                                     .a = w->cp->cpSpaceGetStaticBody(w->space),
                                     .b = w->body[0].body,
                                     .collideBodies = cpTrue,
                                     .userData = w};
    w->cp->cpSpaceAddConstraint(w->space, &w->watch);
}

void converge_step(struct world *w)
{
    w->cp->cpSpaceSetIterations(w->space, MOST);
}

void converge_end(struct world *w)
{
    if (w->watch.space)
        w->cp->cpSpaceRemoveConstraint(w->space, &w->watch);
}
