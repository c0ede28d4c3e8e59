/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Shows quickly that a head keeps falling. In a study only the verdicts on thousands of random rows are
 * wanted, and most heads pass their barrier by far, so the search for the barrier can be left out. Without
 * this shortcut, studies of placement take three to five times as long. Only studies call it, but compiled
 * apart from contact_pushes it would be slower by a sixth.
 */
#include "row/row.h"

/*
 * Sums along a chain while its head turns from one tilt to another. A few digits of these sums suffice, so
 * rounding errors are not compensated. The sums yield an upper bound on the barrier: if a is `rise` and
 * b is `bend`, H(theta) - H(0) <= a theta - b theta^2 / 2, and the maximum of the right side is a^2 / (2 b).
 */
struct glide {
    real J, dH;
    real rise;  /* dH/dtheta at the first tilt of the head */
    real bend;  /* lower bound on -d2H/dtheta2, valid while H increases */
    real t;     /* tan(angle / 2) for the angle by which the current domino turns */
    real curve; /* upper bound on -theta_i'' of the current domino */
    bool rises; /* true if at least one follower gains height at first */
};

/* Adds a domino. Its state is *b when the head has its first tilt, and *a when the head has its last tilt. */
static void glide_add(struct glide *g, const struct link *a, const struct link *b)
{
    const struct geometry *self = a->geometry;
    const real lift = geometry_height_slope(self, b->tilt), height = geometry_height(self, a->tilt),
               slope = height > 0 ? a->slope : b->slope,
               fall = height > 0 ? -geometry_height_slope(self, a->tilt) : self->steepest;
    g->J += a->inertia * a->slope * a->slope;
    g->dH += a->weight * g->t * (self->h.x * (a->tilt.y + b->tilt.y) - self->h.y * (a->tilt.x + b->tilt.x));
    g->rise += a->weight * b->slope * lift;
    if (a->i == 0)
        return;
    g->rises = g->rises || lift > 0;
    g->bend += a->weight * (slope * slope * height - fmax(fall, 0) * g->curve);
}

/* Computes the bound `curve` for the next domino. From the state *b to the state *a, X and theta_1' decrease.
 * So both are largest at *b. Y is smallest at one of the two states, and this smallest value is used. */
static void glide_next(struct glide *g, const struct link *a, const struct link *b)
{
    const struct contact *c = &b->contact;
    const real Y = fmin(a->contact.Y, c->Y), y_1 = c->Y * b->tilt.y - c->X * b->tilt.x,
               turned = fmax(y_1, 0) + fmax(b->contact.slope * a->tilt.x * c->X, 0);
    g->curve = b->contact.slope * g->curve + a->geometry->rL * turned / (Y * Y) * b->slope * b->slope;
}

/* The last dominoes of the chain are left out of the bound on the barrier. To make up for this, the energy
 * must exceed the bound by this factor. */
#define GLIDE_ROOM ((real)1 + (real)1 / 64)

/* Returns true if the kinetic energy certainly exceeds the barrier. */
static bool glide_clears(const struct glide *g, const struct geometry *head, real kinetic)
{
    /* If no follower gains height, H decreases when the head is beyond theta_u. */
    const real height = geometry_height(head, standing),
               bend = g->bend + (g->rises ? fmin(height, geometry_height(head, head->c)) : height);
    const real rise = fmax(g->rise, 0);
    return bend > 0 && rise * rise * GLIDE_ROOM <= 2 * bend * kinetic;
}

/* Returns true if all dominoes after *a are negligible, so that the sums may end there. `shrink` is g->t of
 * the next domino, divided by g->t of the current one. */
static bool glide_done(struct glide *g, const struct link *a, real shrink, real tol)
{
    const struct geometry *self = a->geometry;
    const real ratio = fmax(self->weight * shrink, self->decay),
               rest = a->weight * 2 * g->t * self->steepest * ratio;
    if (!(rest <= (1 - ratio) * tol * fabs(g->dH)))
        return false;
    const real ratio_J = fmax(self->inertia * a->contact.slope * a->contact.slope, self->decay_J);
    return a->inertia * a->slope * a->slope * ratio_J <= (1 - ratio_J) * tol * g->J;
}

KERNEL_SHARED bool row_glides(const struct run *run, const struct geometry *head, struct start *at)
{
    const real tol = TAIL_SHARE * head->tol, kinetic = (1 + run->inertia_ratio) * run->omegasq;
    struct walk walk_a = {.link = link_head(head, head->c)}, walk_b = {.link = link_head(head, standing)};
    struct link *const a = &walk_a.link, *const b = &walk_b.link;
    struct glide g = {.t = half_of_tilt(head->c)};
    for (;;) {
        glide_add(&g, a, b);
        if (a->i + 1 == run->moving)
            break;
        if (!(a->tilt.v < a->geometry->leave.v) || !contact_pushes(&walk_a, &walk_b, PUSHES_HALVINGS))
            return false;
        const real shrink = pair_shrink(a, b, g.t);
        if (glide_done(&g, a, shrink, tol))
            break;
        g.t *= shrink;
        glide_next(&g, a, b);
        link_next(b);
        link_next(a);
    }
    *at = (struct start){.from = head->c, .J = g.J, .omegasq = (kinetic - g.dH) / g.J};
    return glide_clears(&g, head, kinetic);
}
