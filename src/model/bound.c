/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "bound.h"

/* Of Y and of the step of the lean on this domino. */
static void bound_lean(const struct lean *g, const struct link *k, struct bound *b)
{
    b->Y = b->step = 0;
    if (!k->leads || k->tilt.x == 0) {
        b->Y = k->leads ? 6 * UNIT * k->turn.Y : 0;
        return;
    }
    real X = fabs(k->turn.X), Y = k->turn.Y, arm = g->r * g->L * k->tilt.x; /* -dX/dtheta */
    real G = arm / Y;                                                       /* 1 - step, in [0, 1] */
    b->Y = X * G * b->angle + 6 * UNIT * Y;
    b->step = G * (k->tilt.y / k->tilt.x * b->angle + b->Y / Y + 5 * UNIT) + UNIT;
}

KERNEL struct bound bound_head(const struct lean *g, const struct link *head, real angle)
{
    struct bound b = {.angle = angle};
    bound_lean(g, head, &b);
    return b;
}

KERNEL void bound_next(const struct lean *g, const struct link *leader, const struct link *follower,
                       struct bound *b)
{
    /* X and Y each carry 6 units of the positive terms that they are made of. */
    real made_of = g->r * (g->s + g->L * leader->tilt.v);
    real turn = 6 * UNIT * leader->turn.Y * (made_of + fabs(leader->turn.X));
    real powers = UNIT * log(g->r);
    b->angle = leader->step * b->angle + turn + 4 * UNIT * follower->tilt.x;
    b->slope = leader->step * b->slope + leader->slope * b->step + UNIT * follower->slope;
    b->weight += 3 * UNIT + g->q * powers / 2;
    b->inertia += 3 * UNIT + (g->q + 1) * powers;
    bound_lean(g, follower, b);
}

KERNEL real bound_J(const struct link *k, const struct bound *b)
{
    real slope = k->slope;
    return k->inertia * (slope * (2 * b->slope + slope * (b->inertia + 3 * UNIT)) + b->slope * b->slope);
}

KERNEL real bound_H1(const struct lean *g, const struct link *k, const struct bound *b)
{
    real lift = g->d * k->tilt.y - k->tilt.x, made_of = g->d * k->tilt.y + k->tilt.x;
    real lift_error = (g->d * k->tilt.x + k->tilt.y) * b->angle + 3 * UNIT * made_of;
    return k->weight *
           (fabs(lift) * (b->slope + k->slope * (b->weight + 2 * UNIT)) + (k->slope + b->slope) * lift_error);
}

KERNEL real bound_rise(const struct lean *g, struct tilt a, struct tilt b, real angle_a, real angle_b, real t,
                       real t_error)
{
    real cosines = g->d * (a.y + b.y), sines = a.x + b.x;
    real lift_error =
        (g->d * a.x + a.y) * angle_a + (g->d * b.x + b.y) * angle_b + 4 * UNIT * (cosines + sines);
    return fabs(cosines - sines) * t_error + (fabs(t) + t_error) * lift_error;
}

KERNEL real bound_half_turn(const struct lean *g, const struct link *a, const struct link *b,
                            const struct bound *bound_a, const struct bound *bound_b, real t, real t_error,
                            real G)
{
    (void)g;
    real sines = a->tilt.x + b->tilt.x, Y = a->turn.Y + b->turn.Y;
    if (t == 0 || sines == 0)
        return t_error;
    real of_sines = (a->tilt.y * bound_a->angle + b->tilt.y * bound_b->angle) / sines;
    real of_G = G * (of_sines + (bound_a->Y + bound_b->Y) / Y + 6 * UNIT);
    return fabs(1 - G) * (t_error + 6 * UNIT * fabs(t)) + fabs(t) * (1 + t * t) * of_G;
}
