/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The largest growth: the margin as a function of r, scanned upwards from r = 1 to the reach r = 1/s.
 * The margin need not be monotone (thin dominoes: it falls, rises again and drops near 1/s), so a dip
 * between two samples is looked into before the scan goes on.
 */
#include "barrier.h"

/* Samples a factor e of r, far from the reach; then a decade of 1 - r s each. */
#define SCAN_PER_E   8
#define SCAN_DECADES 8

/* What a cycle, or a push, leaves to climb with, and the barrier. */
struct margin {
    real kinetic, barrier;
    bool most; /* the barrier is only the highest that it can be */
    real error;
};

static real margin_left(const struct margin *m)
{
    return m->kinetic - m->barrier;
}

/* Between -1 and 1. */
static real margin_share(const struct margin *m)
{
    return margin_left(m) / (fabs(m->kinetic) + m->barrier + REAL_MIN);
}

struct margin_context {
    const struct dom_train *train;
    struct lean lean; /* of the train, for any s and r */
    size_t dominoes;  /* that are in motion: CHAIN_ENDLESS, or a pair */
    real s;
    enum dom_status (*margin)(const struct lean *, struct margin_context *, struct margin *);
    enum {
        MARGIN_SURE,   /* the barrier by a search for all tops */
        MARGIN_SIGN,   /* or, where that has the same sign, for the highest that it can be, or for one of its
                          tops */
        MARGIN_FOLLOW, /* one top, from r to r */
    } how;
    struct barrier barrier; /* of the last search */
    struct followed {
        real r, half;
    } last[2];              /* tops that were followed */
    struct barrier nearest; /* the one where the margin was closest to 0 */
    real share;             /* that it was, then */
    real error;             /* bound of that of the last margin, where wanted */
    bool errors;
    bool locked; /* by friction, at the last r */
    enum dom_status status;
};

/* The barrier that the kinetic energy is held against, as the context wants it; near: of barrier_near, or
 * NULL. */
static enum dom_status margin_barrier(const struct lean *g, struct margin_context *c, const struct sums *near,
                                      struct margin *m)
{
    struct barrier *b = &c->barrier, b_error = {0};
    real most = barrier_most(g), sure = 4 * g->tol;
    if (c->how == MARGIN_SIGN && m->kinetic * (1 - sure) > most) {
        m->barrier = most;
        m->most = true;
        return DOM_OK;
    }
    if (c->how != MARGIN_SURE && m->kinetic <= 0) { /* whatever the barrier is */
        m->barrier = 0;
        return DOM_OK;
    }
    enum dom_status status = DOM_NOT_CONVERGED;
    if (c->how != MARGIN_SURE) {
        bool top = barrier_follow(g, near, b);
        m->barrier = fmax(b->height, 0); /* that of the upright train */
        if (c->how == MARGIN_FOLLOW || (top && m->kinetic < b->height * (1 - sure)))
            return top ? DOM_OK : DOM_NOT_CONVERGED;
        if (top)
            status = barrier_tops(g, b);
    }
    if (status != DOM_OK)
        status = barrier_search(g, tilt_angle(g->c), c->errors ? g->tol / 8 : TOP_TOL(g), b);
    if (status == DOM_OK && c->errors)
        status = barrier_error(g, b, &b_error);
    m->barrier = b->height;
    m->error += b_error.height;
    return status;
}

/* Of the endless train (c8, corrected). */
static enum dom_status train_margin(const struct lean *g, struct margin_context *c, struct margin *m)
{
    struct launch launch, error = {0};
    struct sums near, at_c;
    enum dom_fuel fuel = c->train->fuel;
    enum dom_status status;
    bool both = c->how == MARGIN_FOLLOW && !g->falls_off;
    /* At r = 1 the fuels agree, and the closed one needs no train. */
    if (g->r == 1 && g->mu == 0 && energy_fuel_paper(g) <= 0)
        return DOM_NO_FUEL;
    if (both) {
        status = chain_both(g, barrier_near(g, &c->barrier), &near, &at_c);
        if (status != DOM_OK)
            return status;
        struct fuel f = fuel_of(g, &at_c);
        launch = launch_of(g, fuel, &f);
    } else {
        status = collision_launch(g, fuel, &launch, c->errors ? &error : NULL);
    }
    if (status == DOM_OK && g->r == 1 && launch.fuel <= 0)
        return DOM_NO_FUEL;
    *m = (struct margin){.kinetic = launch.kinetic, .error = error.kinetic};
    return status == DOM_OK ? margin_barrier(g, c, both ? &near : NULL, m) : status;
}

/* Of the pair after the collision (b13). */
static enum dom_status pair_margin(const struct lean *g, struct margin_context *c, struct margin *m)
{
    struct lean two = *g;
    two.n = c->dominoes;
    real u = g->reach;                        /* h(theta_u) (b2) */
    real sine = (g->c.x - g->d * g->c.y) / u; /* of theta_c - theta_u */
    real cosine = (g->c.y + g->d * g->c.x) / u;
    /* tau_1^2 omega_1c^2 = h(theta_u) - h(theta_c) (b5), without cancellation. */
    real omegasq_1c = u * sine * sine / (1 + cosine);
    if (g->mu > 0) {
        enum dom_status status = friction_flow(&two);
        if (status != DOM_OK)
            return status;
    }
    real k = g->inertia, T = g->mu > 0 ? g->flow->T : k, share = T / (1 + T); /* (b11) */
    real kinetic = (1 + k) * g->r * omegasq_1c * share * share;
    real sine_error = UNIT * (5 * g->c.x + 7 * g->d * g->c.y) / u, powers = 24 * UNIT;
    /* Before theta_u domino 1 has not tipped over when it hits (b0): no push, the barrier is not met. */
    *m = sine > 0 ? (struct margin){.kinetic = kinetic, .error = kinetic * (2 * sine_error / sine + powers)}
                  : (struct margin){.kinetic = 0};
    return margin_barrier(&two, c, NULL, m);
}

/* At the relative tolerance tol. */
static enum dom_status margin_to(struct margin_context *c, real r, real tol, struct margin *m)
{
    struct lean g = c->lean;
    struct flow flow;
    g.tol = tol;
    c->status = lean_set(&g, c->s, r);
    if (c->status == DOM_OK)
        lean_flow(&g, &flow);
    if (c->status == DOM_OK)
        c->status = c->margin(&g, c, m);
    c->locked = c->status == DOM_LOCKS;
    if (c->locked) { /* no margin, but a verdict; before that it stops, since the energy tends to 0 */
        c->status = DOM_OK;
        *m = (struct margin){.kinetic = -1};
    }
    c->error = m->error + UNIT * fabs(m->kinetic - m->barrier);
    return c->status;
}

static real margin_at(real r, void *context)
{
    struct margin_context *c = context;
    struct margin m = {0};
    c->how = MARGIN_SURE;
    return margin_to(c, r, c->lean.tol, &m) == DOM_OK ? margin_left(&m) : REAL_NAN;
}

static real margin_below(real r, void *context)
{
    return -margin_at(r, context);
}

#define ROUGH ((real)1e-3)

/*
 * Where its sign is what is wanted: as roughly as shows it.  Kinetic energy and barrier keep a tolerance
 * each, where the tails of all their sums together are less than half of it.
 */
static struct margin margin_sign(struct margin_context *c, real r)
{
    struct margin m = {.kinetic = REAL_NAN};
    real tol = fmax(ROUGH, c->lean.tol);
    c->how = c->train->mu > 0 ? MARGIN_SURE : MARGIN_SIGN;
    if (margin_to(c, r, tol, &m) == DOM_OK && fabs(margin_share(&m)) > 4 * tol)
        return m;
    c->how = MARGIN_SURE;
    margin_to(c, r, c->lean.tol, &m);
    return m;
}

/*
 * The margin as a share, which bends less on the way to a root, and as roughly as serves: the steps of a
 * search nearly square it.
 */
static real margin_follow(real r, void *context)
{
    struct margin_context *c = context;
    struct margin m = {0};
    real tol = c->lean.tol, next = fmax(tol, ROUGH * c->share * c->share), rough, share;
    struct followed *last = c->last;
    if (last[0].half > 0 && last[1].half > 0 && last[0].r != last[1].r) /* as the last two tops say */
        c->barrier.half =
            last[1].half + (last[1].half - last[0].half) / (last[1].r - last[0].r) * (r - last[1].r);
    do {
        rough = next;
        if (margin_to(c, r, rough, &m) != DOM_OK)
            return REAL_NAN;
        share = margin_share(&m);
        next = fmax(tol, ROUGH * share * share);
    } while (rough > tol && fabs(share) < 8 * rough);
    if (fabs(share) <= fmax(tol / 64, 4 * REAL_EPSILON)) /* the sums know no more of it */
        share = 0;
    last[0] = last[1];
    last[1] = (struct followed){r, c->barrier.half};
    if (fabs(share) <= c->share) {
        c->share = fabs(share);
        c->nearest = c->barrier;
    }
    return share;
}

/* The k-th sample of r between 1 and the reach; the last is 1/s itself, and larger k give it again. */
static real scan_sample(real s, int k)
{
    const real near = (real)0.1;
    real ln_reach = -log(s);
    int far = (int)ceil(fmax(ln_reach - near, 0) * SCAN_PER_E);
    if (k < far)
        return exp((real)k * fmax(ln_reach - near, 0) / (real)far);
    real short_of = fmin(near, 1 - s) * pow(10, (real)(far - k));
    return k - far > SCAN_DECADES ? 1 / s : fmax((1 - short_of) / s, 1);
}

/* A sample of the scan. */
struct edge {
    real r;
    struct margin margin;
};

struct limit {
    real r_max;
    enum dom_end ends;
};

/* Is the top that was followed to r the highest there? */
static bool limit_highest(struct margin_context *c, real r)
{
    struct lean g = c->lean;
    struct barrier b = c->nearest;
    if (lean_set(&g, c->s, r) != DOM_OK)
        return false;
    g.n = c->dominoes;
    return barrier_tops(&g, &b) == DOM_OK &&
           b.height <= c->nearest.height * (1 + fmax(g.tol, 4 * REAL_EPSILON));
}

/*
 * The root of the margin between lo and hi, for which the top of the barrier at hi is followed.  That it is
 * the highest also at the root is seen there by one more search; where it is not, all tops are searched at
 * every r.
 */
static enum dom_status limit_root(struct margin_context *c, const struct edge *lo, const struct edge *hi,
                                  real *r)
{
    real tol = c->lean.tol;
    enum num_status solver;
    if (c->train->mu == 0) {
        c->how = MARGIN_FOLLOW;
        c->share = 1;
        c->last[0].half = c->last[1].half = 0;
        solver = num_root_between(margin_follow, c, lo->r, margin_share(&lo->margin), hi->r,
                                  margin_share(&hi->margin), tol / 8, r);
        if (c->status == DOM_INTERRUPTED)
            return c->status;
        if (solver == NUM_OK && limit_highest(c, *r))
            return DOM_OK;
    }
    solver = num_root(margin_at, c, lo->r, hi->r, tol / 8, r);
    return model_status(c->status, solver);
}

/*
 * May the margin reach below 0 between the first and the last?  Where it is lowest in the middle; but kinetic
 * energy alone is smooth, and goes no deeper than a few times what the parabola through the three does.
 */
static bool dips(const struct edge edge[3])
{
    const struct margin *before = &edge[0].margin, *low = &edge[1].margin, *next = &edge[2].margin;
    real left = margin_left(low), down = margin_left(before) - left, up = margin_left(next) - left;
    real back = edge[1].r - edge[0].r, on = edge[2].r - edge[1].r;
    real bend = (up / on + down / back) / (back + on), slope = bend * back - down / back;
    bool smooth = before->most && low->most && next->most;
    return margin_left(next) >= 0 && down > 0 && up > 0 && !(smooth && left > slope * slope / bend);
}

/* First r > lo at which the margin, >= 0 at lo, is negative; DOM_END_REACH if there is none. */
static enum dom_status limit_scan(struct margin_context *c, int k, struct margin margin, struct limit *limit)
{
    real s = c->s, reach = 1 / s;
    struct edge edge[3] = {{REAL_NAN, {.kinetic = REAL_NAN}}, {scan_sample(s, k), margin}};
    while (edge[1].r < reach) {
        edge[2].r = scan_sample(s, ++k);
        edge[2].margin = margin_sign(c, edge[2].r);
        if (c->status != DOM_OK)
            return c->status;
        if (dips(edge)) {
            struct edge low = {0};
            enum num_status solver =
                num_maximum(margin_below, c, edge[0].r, edge[1].r, edge[2].r, (real)1e-6, &low.r);
            if (model_status(c->status, solver) == DOM_OK)
                low.margin = margin_sign(c, low.r);
            if (c->status != DOM_OK)
                return c->status;
            if (solver == NUM_OK && margin_left(&low.margin) < 0) {
                edge[1] = low.r < edge[1].r ? edge[0] : edge[1];
                edge[2] = low;
            }
        }
        if (margin_left(&edge[2].margin) < 0) {
            limit->ends = DOM_END_BARRIER;
            return limit_root(c, &edge[1], &edge[2], &limit->r_max);
        }
        edge[0] = edge[1];
        edge[1] = edge[2];
    }
    *limit = (struct limit){.r_max = reach, .ends = DOM_END_REACH};
    return DOM_OK;
}

/*
 * Of a root of the margin: what is left of the margin and what may be wrong with it, over its slope in r.
 * The slope is that of a difference wide enough to stand out from what may be wrong with both margins,
 * on this side of the reach.
 */
static enum dom_status limit_error(struct margin_context *c, const struct limit *limit, real *error)
{
    real r = limit->r_max, reach = 1 / c->s;
    *error = c->train->mu > 0 ? REAL_NAN : UNIT * r;
    if (limit->ends != DOM_END_BARRIER || c->train->mu > 0)
        return DOM_OK;
    c->errors = true;
    real margin = margin_at(r, c), wrong = c->error, slope = 0;
    c->errors = false;
    real widest = fmin((reach - r) / 4, r / 4), h = fmin(sqrt(REAL_EPSILON) * 64 * r, widest);
    for (; c->status == DOM_OK && slope == 0; h = fmin(8 * h, widest)) {
        real lo = fmax(r - h, 1), above = margin_at(r + h, c);
        real below = c->status == DOM_OK ? margin_at(lo, c) : above;
        if (fabs(above - below) > 8 * wrong || h >= widest)
            slope = fabs(above - below) > 2 * wrong ? fabs(above - below) / (r + h - lo) : REAL_MIN;
    }
    /* Where even the widest shows no slope, all that is known is that r lies between 1 and the reach. */
    *error += slope > REAL_MIN ? 2 * (fabs(margin) + wrong) / slope : reach - 1;
    /* Near the reach the margin bends: the bound holds if the margins at its ends have their signs for sure.
     */
    for (bool sure = false; c->status == DOM_OK && !sure && *error < reach - 1; *error *= sure ? 1 : 4) {
        real lo = fmax(r - *error, 1), hi = fmin(r + *error, reach);
        sure = (lo == 1 || margin_at(lo, c) > wrong) && (hi == reach || margin_at(hi, c) < -wrong);
    }
    return c->status;
}

/* As the caller wants it. */
static enum dom_status limit_public(struct margin_context *c, const struct limit *limit,
                                    struct dom_limit *wide, struct dom_limit *error)
{
    real r_error = 0;
    enum dom_status status = error ? limit_error(c, limit, &r_error) : DOM_OK;
    if (status != DOM_OK)
        return status;
    *wide = (struct dom_limit){.r_max = limit->r_max, .ends = limit->ends};
    if (error)
        *error = (struct dom_limit){.r_max = r_error, .ends = limit->ends};
    return DOM_OK;
}

static const struct limit no_limit = {.r_max = REAL_NAN, .ends = DOM_END_NONE};

static enum dom_status rmax_find(struct margin_context *c, struct limit *limit, enum dom_status *why)
{
    struct margin margin = margin_sign(c, 1);
    if (c->status == DOM_NO_FUEL || (c->status == DOM_OK && margin_left(&margin) < 0)) {
        *limit = no_limit;
        if (why)
            *why = c->status == DOM_NO_FUEL ? DOM_NO_FUEL : c->locked ? DOM_LOCKS : DOM_STOPS;
        return c->status = DOM_OK;
    }
    return c->status == DOM_OK ? limit_scan(c, 0, margin, limit) : c->status;
}

KERNEL enum dom_status limit_rmax(const struct dom_train *train, struct dom_limit *limit,
                                  struct dom_limit *error, enum dom_status *why)
{
    struct margin_context c = {.train = train,
                               .lean = lean_read(train),
                               .s = (real)train->s,
                               .dominoes = CHAIN_ENDLESS,
                               .margin = train_margin};
    struct limit found;
    enum dom_status status = rmax_find(&c, &found, why);
    return status == DOM_OK ? limit_public(&c, &found, limit, error) : status;
}

KERNEL enum dom_status limit_pair(const struct dom_train *train, struct dom_limit *limit,
                                  struct dom_limit *error)
{
    struct margin_context c = {
        .train = train, .lean = lean_read(train), .s = (real)train->s, .dominoes = 2, .margin = pair_margin};
    struct limit found = no_limit;
    real r = 0;
    for (int k = 0; r < 1 / c.s; k++) {
        r = scan_sample(c.s, k);
        struct margin margin = margin_sign(&c, r);
        if (c.status != DOM_OK)
            return c.status;
        if (margin_left(&margin) >= 0) {
            enum dom_status status = limit_scan(&c, k, margin, &found);
            if (status != DOM_OK)
                return status;
            break;
        }
    }
    return limit_public(&c, &found, limit, error);
}

/* ---- The best separation ---- */

static real rmax_at(real s, void *context)
{
    struct margin_context *c = context;
    struct limit limit;
    c->s = s;
    if (rmax_find(c, &limit, NULL) != DOM_OK)
        return REAL_NAN;
    return limit.ends == DOM_END_NONE ? 0 : limit.r_max;
}

/*
 * d r_max / d s by the nine-point rule.  Its error is (h / scale)^8, where r_max bends over a few percent
 * of s, and roundoff / h: least near this h.
 */
static real slope_step(real s)
{
    return (real)0.03 * exp(log(REAL_EPSILON) / 9) * s;
}

static real rmax_slope_by(real s, real h, void *context)
{
    static const int weight[] = {672, -168, 32, -3};
    real sum = 0;
    for (int k = 1; k <= 4; k++)
        sum += (real)weight[k - 1] * (rmax_at(s + (real)k * h, context) - rmax_at(s - (real)k * h, context));
    return sum / (840 * h);
}

static real rmax_slope(real s, void *context)
{
    return rmax_slope_by(s, slope_step(s), context);
}

#define BEST_RATIO    ((real)0.9) /* of successive separations */
#define BEST_PATIENCE 8           /* as many lower ones in a row end the search */
#define BEST_LOWEST   ((real)2e-6)

/* How much lower r_max is at s + step than the top; 0 behind a jump, whose lower side is not the top's. */
static real best_fall(struct margin_context *c, real s, real step, real top)
{
    real far = fabs(rmax_at(s + step, c) - top), near = fabs(rmax_at(s + step / 8, c) - top);
    return near > far / 2 && far > 64 * UNIT * top ? 0 : far;
}

/*
 * Near a smooth top r_max is flat: what rounding and tol leave of its slope bounds s, over the curvature;
 * at a kink or a jump s is bracketed to tol itself.  r_max may be off by as much as it changes over that.
 */
static enum dom_status best_error(struct margin_context *c, real s, bool smooth, struct dom_best *error)
{
    real h = slope_step(s), width = 4 * h, r_error = 0;
    struct limit limit;
    c->s = s;
    enum dom_status status = rmax_find(c, &limit, NULL);
    if (status == DOM_OK)
        status = limit_error(c, &limit, &r_error);
    real s_error = 2 * fmax((real)c->train->tol, 4 * REAL_EPSILON) * s;
    if (status == DOM_OK && smooth) {
        real bend = fabs(rmax_slope(s + width, c) - rmax_slope(s - width, c)) / (2 * width);
        /* Twice the step has 256 times the error of the rule. */
        real slope = rmax_slope(s, c), rule = fabs(rmax_slope_by(s, 2 * h, c) - slope) / 32;
        s_error = 2 * UNIT * s + (fabs(slope) + rule + 2 * r_error / h) / bend;
    }
    if (c->status == DOM_OK && status == DOM_OK)
        r_error += fmax(best_fall(c, s, -fmin(s_error, s / 2), limit.r_max),
                        best_fall(c, s, fmin(s_error, 1 - s), limit.r_max));
    *error = (struct dom_best){.s = s_error, .r_max = r_error};
    return status != DOM_OK ? status : c->status;
}

KERNEL enum dom_status limit_best(const struct dom_train *train, struct dom_best *best,
                                  struct dom_best *error)
{
    struct margin_context c = {
        .train = train, .lean = lean_read(train), .dominoes = CHAIN_ENDLESS, .margin = train_margin};
    real s = 1, top = s, height = rmax_at(s, &c);
    for (int lower = 0; lower < BEST_PATIENCE && c.status == DOM_OK && s > BEST_LOWEST;) {
        s *= BEST_RATIO;
        real value = rmax_at(s, &c);
        lower = value > height ? 0 : lower + 1;
        if (value > height) {
            height = value;
            top = s;
        }
    }
    if (c.status != DOM_OK)
        return c.status;
    if (!(height > 1) || top == 1)
        return DOM_NO_GROWTH;

    enum num_status solver =
        num_maximum(rmax_at, &c, top * BEST_RATIO, top, top / BEST_RATIO, (real)train->tol, &top);
    enum dom_status status = model_status(c.status, solver);
    if (status != DOM_OK)
        return status;
    height = rmax_at(top, &c);
    /* A smooth top is where the slope vanishes; at a kink or a jump that would lie lower. */
    real zero, width = fmax((real)1e-4, 16 * sqrt(REAL_EPSILON)) * top;
    solver = num_root(rmax_slope, &c, top - width, top + width, (real)train->tol, &zero);
    bool smooth = solver == NUM_OK && rmax_at(zero, &c) >= height * (1 - 16 * REAL_EPSILON);
    top = smooth ? zero : top;
    height = c.status == DOM_OK ? rmax_at(top, &c) : 0;
    if (c.status == DOM_OK && error)
        c.status = best_error(&c, top, smooth, error);
    if (c.status == DOM_OK)
        *best = (struct dom_best){.s = top, .r_max = height};
    return c.status;
}
