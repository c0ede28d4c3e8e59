/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The search for the barrier, the global maximum of H(theta) - H(0) over a cycle, and its tilt theta_m
 * (26; c8). H may increase again after a pushing follower has detached, so the first maximum need not be the
 * highest. H and H' are continuous. H'' jumps where a domino detaches. So the search brackets the sign
 * changes of H' in each smooth piece and compares all maxima.
 */
#include "energy/barrier.h"

/*
 * The number of samples in each smooth piece. In 1,000,000 random trains, 8 samples found every maximum that
 * 150 samples found. tests/hard/test_sweep.c compares barriers with those of a reference.
 */
#define BARRIER_SAMPLES 8

/* The positions of the samples in a piece, as fractions of its width: sin^2(pi k / 16). */
static const float sample_place[BARRIER_SAMPLES - 1] = {0.03806f, 0.14645f, 0.30866f, 0.50000f,
                                                        0.69134f, 0.85355f, 0.96194f};

struct slope_context {
    const struct geometry *geometry;
    struct tilt from; /* H at this tilt is subtracted from all heights */
    real known;       /* tan(theta / 2) of a known maximum of H; negative if none is known */
    enum dom_status status;
};

/* Returns the slope of the required energy at p = tan(theta / 2), the variable of the searches. */
static real slope_of_H(real p, void *context)
{
    struct slope_context *c = context;
    real slope = 0;
    c->status = dynamics_slope(c->geometry, tilt_half(p), false, &slope);
    return c->status == DOM_OK ? slope : REAL_NAN;
}

static void barrier_keep(struct barrier *b, real p, real height)
{
    if (height > b->height) {
        b->height = height;
        b->half = p;
    }
}

/* If H at p, or the energy that dominoes with losses need to reach p, is higher than the barrier in *b,
 * stores p and this height in *b. */
static enum dom_status barrier_try(const struct slope_context *c, real p, struct barrier *b)
{
    const struct geometry *geometry = c->geometry;
    struct sums sums;
    real ln_G, u;
    if (geometry->conservative) {
        const enum dom_status status = chain_change(geometry, c->from, tilt_half(p), PASS_PLAIN, &sums);
        if (status == DOM_OK)
            barrier_keep(b, p, sums.dH);
        return status;
    }
    flow_at(geometry, 2 * atan(p), &ln_G, &u);
    barrier_keep(b, p, geometry->flow->J0 * u);
    return DOM_OK;
}

#define TOP_STEPS 200

/*
 * Searches [lo, hi] for a top, a local maximum of H, by Newton's method: the slope H1 of H is 0 there. The
 * variable is p = tan(theta / 2), which begins at top->half. If `bracketed` is true, H is known to increase
 * at lo and to decrease at hi. If a step is impossible or leaves the bracket, p moves to an end of the
 * bracket at which the sign of the slope is not known yet. If both signs are known, p moves to the middle of
 * the bracket. The error of top->height is proportional to the cube of the last step.
 */
static enum dom_status barrier_climb(const struct slope_context *c, real lo, real hi, bool bracketed,
                                     real tol, struct barrier *top)
{
    /* Changes of p are relative to |p| plus tan of half the initial backward lean, because p may be 0. */
    const real backwards = fmax(-half_of_tilt(c->from), 0);
    bool rises = bracketed, falls = bracketed;
    real before = 1, p = top->half;
    tol = fmax(tol, 4 * REAL_EPSILON);
    for (int i = 0; i < TOP_STEPS; i++) {
        struct sums at;
        enum dom_status status =
            chain_change(c->geometry, c->from, tilt_half(p), PASS_SECOND_DERIVATIVE, &at);
        if (status != DOM_OK)
            return status;
        const bool up = at.H1 > 0;
        rises = rises || up;
        falls = falls || !up;
        real step = -at.H1 / at.H2, next = p + step * (1 + p * p) / 2;
        /* H still increases towards this end of the bracket, so the top is at this end */
        if (p == (up ? hi : lo)) {
            next = p;
            step = 0;
        }
        *(up ? &lo : &hi) = p;
        const bool newton = step == 0 || (at.H2 < 0 && next >= lo && next <= hi), closed = rises && falls;
        if (!newton)
            next = !falls ? hi : !rises ? lo : (lo + hi) / 2;
        const real moved = !newton ? 1 : next == p ? 0 : fabs(next - p) / (fabs(next) + backwards);
        if (moved <= tol || (closed && hi - lo <= 4 * REAL_EPSILON * (fabs(hi) + backwards))) {
            top->half = next;
            top->height = newton ? at.dH + at.H1 * step / 2 : at.dH;
            return DOM_OK;
        }
        /* at a kink of H', Newton's method oscillates */
        p = closed && i > 2 && moved > before / 2 ? (lo + hi) / 2 : next;
        before = moved;
    }
    return DOM_NOT_CONVERGED;
}

struct sample {
    real p, slope;
};

/* Samples the sign of the slope at p. If H has a top between the last sample and this one, finds it. */
static void barrier_sample(struct slope_context *c, real p, real tol, struct sample *last, struct barrier *b)
{
    struct sample next = {.p = p};
    if (c->status == DOM_OK)
        c->status = dynamics_slope(c->geometry, tilt_half(p), true, &next.slope);
    if (c->status != DOM_OK)
        return;
    if (last->slope > 0 && next.slope <= 0 && !c->geometry->conservative) {
        real at = p;
        const enum num_status solver =
            num_root_between(slope_of_H, c, last->p, last->slope, p, next.slope, tol, &at);
        c->status = model_status(c->status, solver);
        if (c->status == DOM_OK)
            c->status = barrier_try(c, at, b);
    } else if (last->slope > 0 && next.slope <= 0 && !(last->p <= c->known && c->known <= p)) {
        const real root = last->p + last->slope / (last->slope - next.slope) * (p - last->p);
        struct barrier top = {.half = root};
        c->status = barrier_climb(c, last->p, p, true, tol, &top);
        if (c->status == DOM_OK)
            barrier_keep(b, top.half, top.height);
    }
    *last = next;
}

/* Returns true if the head passes theta_u in the cycle and H certainly decreases beyond theta_u (6; b2). H
 * decreases there because the head loses height, and so do its followers, which lean even more. */
static bool falls_above_u(const struct geometry *geometry)
{
    return geometry->conservative && !geometry->follower && geometry_lift(geometry, geometry->c) < 0;
}

/*
 * Returns true if H is proved to have a single top, that is, a single local maximum. It has a single top if
 * it is concave up to the tilt theta_u, because above theta_u it decreases: there the head and its followers
 * all lose height (6; b2). The code below tests a condition under which H is concave up to theta_u. The
 * condition is derived as follows.
 *
 * Let c = r L / cos theta_c. With rounded edges, let l = 1 - 2 rho. Then (r L + (r + 1) rho) / l takes the
 * place of r L. Since Y_i >= Y_0 = cos theta_c, equations (12; b8) and (14; b10) give
 *
 *     theta_(i+1)'' >= theta_1' theta_i'' - c theta_i'^2,   theta_1' <= 1.
 *
 * So -theta_i'' is at most c times the sum of theta_j'^2 over j < i. The second derivative H'' is the sum of
 * w^i (h_i'' theta_i'^2 + h_i' theta_i'') over all dominoes i, where w = r^-q. Let g be an upper bound on
 * -h_i'. Then the terms of H'' that contain theta_j'^2 add up to at most
 *
 *     w^j theta_j'^2 (h_j'' + bends),   bends = g c (w + w^2 + ...).
 *
 * For every domino, -h'' = h, because h = h.y cos theta + h.x sin theta. The head, which is between 0 and
 * theta_u, has h >= h(0) = h.y. A follower has h >= `least`, the smaller of h(0) and h(theta_f), and
 * theta_j'^2 <= 1. A follower that has detached adds nothing to H''. So H is concave if the sum of these
 * bounds is negative.
 */
KERNEL bool barrier_single(const struct geometry *geometry)
{
    const struct rounded *of = &geometry->rounded;
    const real c = (geometry->rL + (geometry->r + 1) * of->rho) / of->tall / geometry->c.y,
               w = geometry->weight, sum = w / (1 - w),
               bends = -geometry_lift(geometry, geometry->f) * c * sum,
               least = fmin(geometry->h.y, geometry_height(geometry, geometry->f));
    return of->roll == 0 && geometry->conservative && !geometry->follower &&
           bends + fmax(bends - least, 0) * sum < geometry->h.y;
}

/*
 * Finds the highest maximum of H in one smooth piece. The samples have the Chebyshev spacing, which is dense
 * near the ends of the piece, where dominoes detach. If the head begins to move in this piece, `begins` is
 * true, and H can change on small scales. So there are further samples at tilts that are small compared with
 * d and sqrt(1 - r s).
 */
static enum dom_status barrier_scan(struct slope_context *c, real lo, real hi, bool begins, real tol,
                                    struct barrier *b)
{
    const struct geometry *geometry = c->geometry;
    const bool falls = c->from.x == 0 && falls_above_u(geometry);
    if (falls)
        hi = fmin(hi, geometry_half_u(geometry));
    if (hi <= lo)
        return DOM_OK;
    /* After domino 1 has detached, the head moves alone, so H increases up to theta_u. */
    if (falls && geometry->detaches && tilt_half((lo + hi) / 2).v > geometry->leave.v)
        return c->known >= lo ? DOM_OK : barrier_try(c, hi, b);
    struct sample last = {.p = lo};
    barrier_sample(c, lo, tol, &last, b);
    for (real p = geometry_finest(geometry) / 32;
         begins && p < (real)sample_place[0] * (hi - lo) && (p > lo || lo > REAL_MIN); p *= 4)
        barrier_sample(c, lo + p, tol, &last, b);
    for (int k = 0; k + 1 < BARRIER_SAMPLES; k++)
        barrier_sample(c, lo + (real)sample_place[k] * (hi - lo), tol, &last, b);
    barrier_sample(c, hi, tol, &last, b);
    if (c->status == DOM_OK && last.slope > 0)
        /* H increases up to the end of the piece, so the maximum may be there */
        c->status = barrier_try(c, hi, b);
    return c->status;
}

/*
 * Searches the smooth pieces between the edges of *b for the barrier. Heights are relative to H at `from`,
 * the first edge. If b->height is positive, *b already holds a maximum of H.
 */
static enum dom_status barrier_pieces(const struct geometry *geometry, struct tilt from, real tol,
                                      struct barrier *b)
{
    struct slope_context c = {.geometry = geometry, .from = from, .known = b->height > 0 ? b->half : -1};
    enum dom_status status = DOM_OK;
    bool upright = from.x == 0, begins = upright || (geometry->lean != 0 && b->edge[0] == geometry->lean);
    real end = b->edge[b->edges - 1], lo = upright ? b->edge[0] : half_of_tilt(from);
    if (upright && barrier_single(geometry)) {
        b->half = fmin(tan(end / 2), geometry_half_u(geometry)) / 2;
        status = barrier_climb(&c, 0, 2 * b->half, false, tol, b);
        b->height = fmax(b->height, 0);
    } else
        for (int i = 1; status == DOM_OK && i < b->edges; i++) {
            real hi = tan(b->edge[i] / 2);
            status = barrier_scan(&c, lo, hi, begins && i == 1, tol, b);
            lo = hi;
        }
    if (b->height > 0)
        b->theta_m = fmin(2 * atan(b->half), end);
    return status;
}

KERNEL enum dom_status barrier_up_to(const struct geometry *geometry, struct tilt from, real end,
                                     struct barrier *b)
{
    int last = 0;
    b->height = 0;
    b->half = half_of_tilt(from);
    b->theta_m = from.x == 0 ? 0 : b->edge[0];
    while (last + 1 < b->edges && b->edge[last] < end)
        last++;
    b->edge[last] = end;
    b->edges = last + 1;
    return barrier_pieces(geometry, from, geometry->tol / 8, b);
}

KERNEL enum dom_status barrier_search(const struct geometry *geometry, bool known, real tol,
                                      struct barrier *b)
{
    if (!known || b->height <= 0) /* a known top may be no higher than the upright position */
        *b = (struct barrier){.height = 0};
    if (known && barrier_single(geometry))
        return DOM_OK;
    enum dom_status status = geometry->conservative ? DOM_OK : flow_solve(geometry);
    if (status == DOM_OK)
        status = chain_edges(geometry, b->edge, &b->edges, &b->leave, &b->domino);
    return status == DOM_OK ? barrier_pieces(geometry, standing, tol, b) : status;
}

KERNEL bool barrier_follow(const struct geometry *geometry, real tol, struct barrier *b)
{
    struct slope_context c = {.geometry = geometry, .from = standing, .known = -1};
    /* the last tilt at which H may increase */
    const real last = falls_above_u(geometry) ? geometry_half_u(geometry) : half_of_tilt(geometry->c);
    b->half = b->half > 0 ? fmin(b->half, last) : last / 2;
    return barrier_climb(&c, 0, last, false, tol, b) == DOM_OK;
}

KERNEL real barrier_most(const struct geometry *geometry)
{
    /*
     * During a cycle, each domino moves from its own initial tilt to the initial tilt of its follower. So no
     * two dominoes pass the same tilts. Since a follower weighs at most as much as its leader, H increases by
     * less than h(theta_u) - h(0), the rise of a head that moves alone from 0 to theta_u.
     */
    return geometry_rise_u(geometry);
}
