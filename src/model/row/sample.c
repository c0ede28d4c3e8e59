/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Runs many rows with random errors as fast as possible, since only the verdict on each row is wanted.
 *
 * A head need not be run precisely if it clearly keeps falling. For most heads, quickly computed bounds show
 * that the energy exceeds the barrier, and that no contact force is negative. The energy of the next head
 * then follows from one pass down the chain. This pass needs the tilts at two times: when the head is hit,
 * and when the head hits the next domino. The tilts at the first time are mostly known from the pass for the
 * previous head.
 *
 * If the bounds are not sharp enough, or if a domino detaches, row_head runs the head.
 */
#include "row/rough.h"
#include "row/run.h"
#include <stdlib.h>

struct random_row {
    struct row_request request;
    bool plain; /* true if the edges are sharp and the dominoes are plumb */
    bool rolls; /* true if the edges are rounded and there is friction */
    bool has_friction;
    /* A row with friction is first run roughly, unless a domino leans. `rough` is true during this run. If
     * the verdict of this run is in doubt, `doubt` is set to true, and the row is run again, precisely. */
    bool rough, doubt;
    struct rough_motion motion;
    real off_at_end; /* estimate of the error in omegasq at the end of the current head's motion */
    struct block *block;
    struct geometry *geometry;
    /* link[first] ... link[head] are the dominoes of the chain when domino `head` hits the next one */
    struct link *link;
    size_t first, head; /* `head` is SIZE_MAX if `link` holds no chain */
    /*
     * The dynamics for which dynamics_begin was called, or NULL if it was not called. geometry[0].dynamics
     * may differ later: one random row may have friction, and the next one none.
     */
    const struct dynamics *begun;
};

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
               turned = fmax(y_1, 0) + fmax(b->contact_slope * a->tilt.x * c->X, 0);
    g->curve = b->contact_slope * g->curve + a->geometry->rL * turned / (Y * Y) * b->slope * b->slope;
}

/* The last dominoes of the chain are left out of the bound on the barrier. To make up for this, the energy
 * must exceed the bound by this factor. */
#define GLIDE_ROOM ((real)1 + (real)1 / 64)

/* Returns true if the kinetic energy certainly exceeds the barrier. */
static bool glide_passes(const struct glide *g, const struct link *head, real kinetic)
{
    const struct geometry *self = head->geometry;
    /* If no follower gains height, H decreases when the head is beyond theta_u. */
    const real height = geometry_height(self, standing),
               bend = g->bend + (g->rises ? fmin(height, geometry_height(self, head->tilt)) : height);
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
    const real ratio_J = fmax(self->inertia * a->contact_slope * a->contact_slope, self->decay_J);
    if (!(a->inertia * a->slope * a->slope * ratio_J <= (1 - ratio_J) * tol * g->J))
        return false;
    return true;
}

/*
 * Returns the state of domino j at the moment when the head is hit. Domino j leans on `leader`. If j >=
 * `known`, the state is known from the stored chain. If j < `known`, it is computed from the state of
 * `leader`.
 */
static struct link link_before(const struct random_row *s, size_t j, size_t known, const struct link *leader)
{
    struct link k = *leader;
    if (j < known) {
        link_next(&k);
        return k;
    }
    k = s->link[j];
    k.slope = leader->slope * leader->contact_slope;
    return k;
}

/*
 * Returns true if it is certain that head k falls until it hits the next domino, or until it lies on the
 * floor if it is the last one. Sets *at to the state of the head at that moment and stores the chain in
 * s->link. All dominoes must be plumb and have sharp edges.
 */
static bool head_goes(struct random_row *s, const struct run *run, size_t k, struct start *at)
{
    const struct geometry *head = &s->geometry[k];
    const real tol = TAIL_SHARE * (real)s->request.tol, kinetic = (1 + run->inertia_ratio) * run->omegasq;
    const bool alone = run->moving == 1; /* a domino that moves alone has no friction */
    struct link a = link_head(head, head->c), b = link_head(head, standing);
    struct glide g = {.t = half_of_tilt(head->c)};
    const size_t known = k > 0 && s->head == k - 1 ? s->first : k;
    s->head = SIZE_MAX;
    for (;;) {
        s->first = k - a.i;
        s->link[s->first] = a;
        glide_add(&g, &a, &b);
        if (a.i + 1 == run->moving)
            break;
        if (!(a.tilt.v < a.geometry->leave.v) || !contact_pushes(&a, &b))
            return false;
        const real shrink = pair_shrink(&a, &b, g.t);
        if (glide_done(&g, &a, shrink, tol))
            break;
        g.t *= shrink;
        glide_next(&g, &a, &b);
        b = link_before(s, s->first - 1, known, &b);
        link_next(&a);
    }
    s->head = k;
    *at = (struct start){.from = head->c, .J = g.J, .omegasq = (kinetic - g.dH) / g.J};
    if (alone || !s->has_friction)
        return glide_passes(&g, &s->link[k], kinetic);
    if (!s->rough)
        return false;
    if (k + 1 == s->request.count && !g.rises) /* beyond theta_u, all dominoes only lose height */
        return rough_reaches(&s->motion, head, fmin(half_of_tilt(head->c), geometry_half_u(head)),
                             run->omegasq);
    return rough_descend(&s->motion, head, run->omegasq, &at->omegasq, &s->off_at_end);
}

/* Like head_goes, but for a row with rounded edges and friction. Stores no chain. */
static bool head_rolls(struct random_row *s, const struct run *run, size_t k, struct start *at)
{
    const struct geometry *head = &s->geometry[k];
    const struct contact_law *law = head->law;
    struct walk a = law->begin(head, head->c), b = law->begin(head, standing);
    const bool last = k + 1 == s->request.count;
    bool rises = false;
    while (a.link.i + 1 < run->moving) {
        const struct geometry *self = a.link.geometry;
        if (!a.link.leads || !law->pushes(&a, &b))
            return false;
        if (a.link.weight * fabs(a.link.slope) * self->decay < head->tol * (1 - self->decay))
            break;
        law->next(&a);
        law->next(&b);
        rises = rises || geometry_lift(b.link.geometry, b.link.tilt) > 0;
    }
    *at = (struct start){.from = head->c};
    if (last && !rises) /* beyond theta_u, all dominoes only lose height */
        return rough_reaches(&s->motion, head, fmin(half_of_tilt(head->c), geometry_half_u(head)),
                             run->omegasq);
    return rough_descend(&s->motion, head, run->omegasq, &at->omegasq, &s->off_at_end);
}

static bool head_certain(struct random_row *s, const struct run *run, size_t k, struct start *at)
{
    return run->omegasq > 0 &&
           (s->plain ? head_goes(s, run, k, at) : s->rolls && s->rough && head_rolls(s, run, k, at));
}

/* Computes the collision of head k with the next domino. The collision does not change the relative error in
 * omegasq. */
static enum dom_status sample_hit(struct random_row *s, struct run *run, size_t k,
                                  const struct geometry *hitting, const struct start *at)
{
    enum dom_status status = row_hit(run, k, hitting, at);
    s->motion.off = s->off_at_end / at->omegasq * run->omegasq;
    return status;
}

/* After a rough run, the sign of a contact force is certain only if the force is large enough. It must exceed
 * this fraction of the weight of the pushed domino. */
#define LEAST_CLEAR ((real)1 / 64)

/* Runs head k with row_head. In a rough run, omegasq has an error of up to s->motion.off. Sets s->doubt to
 * true if such an error may change the verdict. */
static enum dom_status head_run(struct random_row *s, struct run *run, size_t k)
{
    struct descent d;
    struct dom_fall fall;
    const real before = run->omegasq;
    enum dom_status status = row_head(run, k, &d, &fall);
    if (status != DOM_OK)
        return status;
    const bool tips = before == 0, pushes = fabs(d.least_force) > LEAST_CLEAR,
               sure = rough_sure(&s->motion, before, (real)fall.margin, (real)fall.kinetic);
    s->doubt = s->rough && !tips && !(pushes && sure && !d.locks);
    if (s->doubt || run->verdict.end != DOM_ROW_FALLS || k + 1 == s->request.count)
        return DOM_OK;
    s->off_at_end = tips ? 0 : s->motion.off * d.st.gain + rough_error(&d.st.geometry) * d.st.start.omegasq;
    return sample_hit(s, run, k, &d.st.geometry, &d.st.start);
}

static enum dom_status sample_falls(struct random_row *s, struct run *run)
{
    enum dom_status status = DOM_OK;
    row_launch(run);
    s->head = SIZE_MAX;
    s->motion.off = 0;
    s->doubt = false;
    for (size_t k = 0;
         k < s->request.count && status == DOM_OK && run->verdict.end == DOM_ROW_FALLS && !s->doubt; k++) {
        struct start at;
        s->geometry[k].n = run->moving;
        run->verdict.domino = k + 1;
        if (dom_interrupted(s->request.interrupt))
            return DOM_INTERRUPTED;
        s->off_at_end = 0;
        if (!head_certain(s, run, k, &at))
            status = head_run(s, run, k);
        else if (k + 1 < s->request.count)
            status = sample_hit(s, run, k, &s->geometry[k], &at);
    }
    return status;
}

static void sample_tol(struct random_row *s, bool rough)
{
    s->rough = rough;
    for (size_t k = 0; k < s->request.count; k++)
        s->geometry[k].tol = rough ? fmax((real)s->request.tol, ROUGH_TOL) : (real)s->request.tol;
}

/* Checks the row, fills in its blocks and geometry, and chooses the fast methods that can be used. */
static enum dom_status sample_make(struct random_row *s)
{
    size_t wrong;
    s->request.block = NULL;
    s->plain = true;
    enum dom_status status = row_check(&s->request, &wrong);
    for (size_t k = 0; k < s->request.count && status == DOM_OK; k++)
        s->block[k] = block_of(&s->request, k);
    s->request.block = s->block;
    for (size_t k = 0; k < s->request.count && status == DOM_OK; k++)
        status = row_geometry(&s->request, k, s->geometry);
    for (size_t k = 0; k < s->request.count && status == DOM_OK; k++)
        s->plain = s->plain && s->geometry[k].law->closed_form && s->request.domino[k].lean == 0;
    s->has_friction = status == DOM_OK && !s->geometry[0].dynamics->conservative;
    s->rolls = s->has_friction && !s->geometry[0].law->closed_form;
    return status;
}

KERNEL enum dom_status row_sample_begin(const struct row_request *request, struct random_row **sample)
{
    const size_t n = request->count;
    size_t wrong;
    *sample = NULL;
    enum dom_status status = row_check(request, &wrong);
    if (status != DOM_OK)
        return status;
    struct random_row *s = calloc(1, sizeof *s);
    if (!s)
        return DOM_NO_MEMORY;
    *s = (struct random_row){.request = *request,
                             .block = malloc(n * sizeof *s->block),
                             .geometry = malloc(n * sizeof *s->geometry),
                             .link = malloc(n * sizeof *s->link)};
    *sample = s;
    if (s->geometry)
        s->geometry[0] = (struct geometry){.dynamics = &energy_balance};
    if (!s->block || !s->geometry || !s->link)
        return DOM_NO_MEMORY;
    status = sample_make(s);
    if (status == DOM_OK) {
        s->begun = s->geometry[0].dynamics;
        status = dynamics_begin(s->geometry);
    }
    if (status != DOM_OK)
        return status;
    for (size_t k = 1; k < n; k++) /* all joints share the memory that dynamics_begin allocated */
        s->geometry[k].flow = s->geometry[0].flow;
    num_rough_begin(&s->motion.flow);
    return DOM_OK;
}

KERNEL enum dom_status row_sample_run(struct random_row *s, const struct dom_row *row, bool gaps,
                                      struct dom_verdict *verdict)
{
#define VALUE(effect, member, status) row->member,
    const dom_real effect[] = {DOM_DYNAMICS(VALUE)};
#undef VALUE
    const struct run fresh = {
        .request = &s->request, .geometry = s->geometry, .verdict = {.end = DOM_ROW_FALLS}};
    struct run run = fresh;
    enum dom_status status = DOM_OK;
    s->request.domino = row->domino;
    s->request.push = row->push;
    memcpy(s->request.effect, effect, sizeof effect);
    if (!gaps || !s->plain)
        status = sample_make(s);
    else
        row_gaps(&s->request, s->geometry);
    if (status == DOM_OK) {
        sample_tol(s, s->has_friction && (s->plain || s->rolls));
        status = sample_falls(s, &run);
    }
    if (status == DOM_OK && s->doubt) {
        sample_tol(s, false);
        run = fresh;
        status = sample_falls(s, &run);
    }
    *verdict = run.verdict;
    return status;
}

KERNEL enum dom_status row_sample_end(struct random_row *s)
{
    if (s && s->begun) {
        s->geometry[0].dynamics = s->begun;
        dynamics_end(&s->geometry[0]);
    }
    if (s) {
        free(s->block);
        free(s->geometry);
        free(s->link);
    }
    free(s);
    return DOM_OK;
}
