/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Shows quickly that a head keeps falling. In a study only the verdicts on thousands of random rows are
 * wanted, and most heads pass their barrier by far, so the search for the barrier can be left out. Without
 * this shortcut, studies of placement take three to five times as long.
 */
#include "dynamics/dynamics.h"
#include "row/study.h"
#include <stdlib.h>

/* ---- Without friction: bounds from one pass down the chain ---- */

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

/* Edges are sharp, and the chain moves without friction. */
static bool quick_glides(const struct run *run, const struct geometry *head, struct start *at)
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

/* ---- With friction: a solution of the equation of motion from a few tilts ---- */

/* The errors of a rough solution are estimated from the last terms of its series. omegasq at the end of the
 * motion may have this relative error, and the head must clear the barrier by several times the error. */
#define ROUGH_ERROR ((real)1 / 256)
#define ROUGH_TIMES 4

/* Number of tilts at which the required energy is sampled to find its maximum. */
enum { ROUGH_PLACES = 12 };

/* Returns the largest u up to the tilt hi (dynamics.h), from samples and parabolas through them. The samples are
 * equally spaced in the square root of the tilt, since thin dominoes have their barrier at a small tilt. */
static real rough_need(const struct geometry *head, real hi)
{
    real most = 0, last = 0, self = 0, next;
    for (int i = 1; i <= ROUGH_PLACES; i++) {
        flow_at(head, hi * (real)(i * i) / (ROUGH_PLACES * ROUGH_PLACES), NULL, &next);
        const real bend = 2 * self - last - next;
        most = fmax(most, next);
        if (i > 1 && self >= last && self >= next && bend > 0)
            most = fmax(most, self + (next - last) * (next - last) / (8 * bend));
        last = self;
        self = next;
    }
    return most;
}

/* Returns the last tilt that the head must reach to fall. For the last head of a row whose followers only
 * lose height, this is theta_u. Any other head must reach the next domino. */
static real rough_end(const struct run *run, size_t k)
{
    const struct geometry *head = &run->geometry[k];
    bool rises = k + 1 < run->request->count;
    for (size_t j = k; !rises && j-- > k + 1 - run->moving;)
        rises = geometry_lift(&run->geometry[j], run->geometry[j].c) > 0;
    return fmin(tilt_angle(head->c), rises ? (real)INFINITY : geometry_theta_u(head));
}

/* With drag there is no proof that contacts push, so the forces at a few tilts decide, as in a precise run.
 */
static bool rough_pushes(const struct geometry *head, real w, real hi)
{
    const struct segment st = {.geometry = *head, .hi = hi, .start = {.from = standing, .omegasq = w}};
    real least = (real)INFINITY;
    return segment_contact(&st, hi, &least) == DOM_OK && least > LEAST_CLEAR;
}

static bool quick_rolls(const struct run *run, size_t k, struct start *at)
{
    const struct geometry *head = &run->geometry[k];
    const struct num_linear *solution = &head->flow->solution;
    const real hi = rough_end(run, k), w = run->omegasq;
    struct sums sums;
    real ln_G, u;
    const bool proves = losses_end_alone(head);
    if (chain_change(head, standing, head->c, PASS_PUSHES, &sums) != DOM_OK || (proves && !sums.pushes) ||
        sums.left != 0 || !flow_rough(head, hi))
        return false;
    flow_at(head, hi, &ln_G, &u);
    *at = (struct start){.from = head->c, .J = sums.J, .omegasq = exp(ln_G) * (w - u)};
    const real off = solution->v_error + solution->ln_G_error * (w - u);
    return off <= ROUGH_ERROR * (w - u) &&
           w - rough_need(head, hi) > ROUGH_CLEAR * w + ROUGH_TIMES * solution->v_error &&
           (proves || rough_pushes(head, w, hi));
}

KERNEL bool study_passes(struct run *run, size_t k, struct start *at)
{
    const struct study *s = run->study;
    struct geometry *head = &run->geometry[k];
    /* only a first domino that is released can lean here */
    if (!s || !s->quick || !(run->omegasq > 0) || head->lean != 0)
        return false;
    head->n = run->moving;
    if (head->conservative || (run->moving == 1 && losses_end_alone(head)))
        return !head->rolls && quick_glides(run, head, at);
    return s->rough && quick_rolls(run, k, at);
}
