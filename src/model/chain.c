/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "bound.h"
#include "friction.h"

/* A pass of this many dominoes takes tens of milliseconds; at r = 1 only sqrt(s (s + 2 d)) < 2e-5 has more.
 */
#define LINKS_MAX ((size_t)2000000)

/* The tail of a sum may be this part of the tolerance, so that a result of several sums keeps it. */
#define TAIL_SHARE ((real)0.125)

static void link_lean(struct link *k)
{
    const struct lean *g = k->lean;
    /* Upright is leaned on in any case: it has just been hit, even in the limit theta_leave = 0. */
    k->leads = !g->falls_off || k->tilt.v < g->leave.v || k->tilt.x == 0;
    if (k->leads) {
        k->turn = lean_turn(g, k->tilt);
        k->step = k->turn.step;
    }
}

KERNEL struct link link_head(const struct lean *g, struct tilt head)
{
    struct link k = {.lean = g, .i = 0, .tilt = head, .slope = 1, .weight = 1, .inertia = 1};
    link_lean(&k);
    return k;
}

KERNEL void link_next(struct link *k)
{
    const struct lean *g = k->lean;
    k->i++;
    k->tilt = tilt_turn(k->tilt, k->turn);
    k->slope *= k->step;
    k->weight *= g->weight;
    k->inertia *= g->inertia;
    if (g->behind)
        k->lean = g->behind;
    link_lean(k);
}

KERNEL real link_bend(const struct link *leader, real bend, const struct link *follower)
{
    real X = leader->turn.X, Y = leader->turn.Y;
    if (leader->tilt.x == 0 && Y == 0)
        return 0;
    real turned = (follower->tilt.y + leader->step * leader->tilt.x * X) / (Y * Y);
    return leader->step * bend - leader->lean->r * leader->lean->L * turned * leader->slope * leader->slope;
}

/* A sum with a bound on the terms that have not been added yet. */
struct series {
    real sum, size;   /* of the terms, and of their absolute values */
    real lost;        /* what rounding took from the sum so far */
    real next, ratio; /* at most: the first of the terms to come, and each to the one before */
};

/* Compensated (Fast2Sum; a follower never counts for more than all before it, but in roundings). */
static void series_add(struct series *s, real term)
{
    real sum = s->sum + term;
    s->lost += fabs(s->sum) >= fabs(term) ? (s->sum - sum) + term : (term - sum) + s->sum;
    s->sum = sum;
    s->size += fabs(term);
}

/*
 * Does the tail matter?  The next terms are at most `term` times ratio, ratio^2, ...; below the unit
 * roundoff of what was added no tolerance needs them.
 */
static bool series_done(struct series *s, real term, real ratio, real tol)
{
    s->next = term * ratio;
    s->ratio = ratio;
    return s->next <= (1 - ratio) * fmax(TAIL_SHARE * tol * fabs(s->sum), UNIT / 2 * s->size);
}

/* Rounding of the sum, and its tail: 0 where the train has ended. */
static real series_error(const struct series *s, bool ended)
{
    real tail = ended || s->next == 0 ? 0 : s->next / (1 - s->ratio);
    return 2 * UNIT * (fabs(s->sum) + UNIT * s->size) + tail;
}

/* Every few thousand dominoes: has somebody asked to stop, is the train too long? */
static enum dom_status chain_watch(const struct lean *g, size_t i)
{
    if (i % 4096 != 0)
        return DOM_OK;
    if (dom_raised(g->interrupt))
        return DOM_INTERRUPTED;
    return i < LINKS_MAX ? DOM_OK : DOM_TOO_LONG;
}

static void chain_count(const struct lean *g, size_t n)
{
    if (!g->work)
        return;
    g->work->passes++;
    g->work->dominoes += n;
    g->work->longest = n > g->work->longest ? n : g->work->longest;
}

struct sum_state {
    struct series J, H1, dH;
    real left;
};

static void add_J(struct sum_state *a, const struct link *k)
{
    series_add(&a->J, k->inertia * k->slope * k->slope);
}

static void add_H1(struct sum_state *a, const struct link *k)
{
    series_add(&a->H1, k->weight * k->slope * (k->lean->d * k->tilt.y - k->tilt.x));
}

static bool done_J(struct sum_state *a, const struct link *k)
{
    const struct lean *g = k->lean;
    return series_done(&a->J, k->inertia * k->slope * k->slope,
                       fmax(g->inertia * k->step * k->step, g->decay_J), g->tol);
}

static bool done_H1(struct sum_state *a, const struct link *k, real tol)
{
    const struct lean *g = k->lean;
    return series_done(&a->H1, k->weight * k->slope * g->reach, fmax(g->weight * k->step, g->decay), tol);
}

static enum dom_status sum_result(const struct lean *g, const struct sum_state *a, size_t n,
                                  struct sums *sums)
{
    chain_count(g, n);
    *sums = (struct sums){.J = a->J.sum + a->J.lost,
                          .H1 = a->H1.sum + a->H1.lost,
                          .dH = a->dH.sum + a->dH.lost,
                          .left = a->left,
                          .n = n};
    return isfinite(sums->J) && isfinite(sums->H1) && isfinite(sums->dH) ? DOM_OK : DOM_NOT_FINITE;
}

KERNEL enum dom_status chain_sign(const struct lean *g, struct tilt head, real *H1)
{
    struct sum_state a = {0};
    struct sums sums;
    struct link k = link_head(g, head);
    for (;;) {
        enum dom_status status = chain_watch(g, k.i);
        if (status != DOM_OK)
            return status;
        add_H1(&a, &k);
        if (k.i + 1 >= g->n || !k.leads || done_H1(&a, &k, 1)) {
            status = sum_result(g, &a, k.i + 1, &sums);
            *H1 = sums.H1;
            return status;
        }
        link_next(&k);
    }
}

KERNEL enum dom_status chain_sum(const struct lean *g, struct tilt head, struct sums *sums)
{
    struct sum_state a = {0};
    struct link k = link_head(g, head);
    for (;;) {
        enum dom_status status = chain_watch(g, k.i);
        if (status != DOM_OK)
            return status;
        add_J(&a, &k);
        add_H1(&a, &k);
        if (k.i + 1 >= g->n || !k.leads || (done_J(&a, &k) && done_H1(&a, &k, g->tol)))
            return sum_result(g, &a, k.i + 1, sums);
        link_next(&k);
    }
}

/*
 * h(A) - h(B) of one domino at the tilts a and b, h = cos + d sin, from t = tan((A - B)/2): the product
 * form of 2 sin((A-B)/2) (d cos((A+B)/2) - sin((A+B)/2)), free of cancellation.
 */
static real rise(const struct lean *g, struct tilt a, struct tilt b, real t)
{
    return t * (g->d * (a.y + b.y) - (a.x + b.x));
}

/* The errors of chain_rise, where they are asked for. */
struct rise_error {
    struct bound a, b;
    real t;
    struct sums sums;
};

static struct rise_error error_head(const struct lean *g, const struct link *a, const struct link *b, real t)
{
    real angle = lean_error_head(a->tilt);
    return (struct rise_error){
        .a = bound_head(g, a, angle),
        .b = bound_head(g, b, 0),
        .t = (1 + t * t) * angle / 2 + 3 * UNIT * t,
    };
}

static void error_add(const struct lean *g, struct rise_error *e, const struct link *a, const struct link *b,
                      real t)
{
    real term = fabs(rise(g, a->tilt, b->tilt, t));
    e->sums.J += bound_J(a, &e->a);
    e->sums.H1 += bound_H1(g, a, &e->a);
    e->sums.dH += a->weight * (bound_rise(g, a->tilt, b->tilt, e->a.angle, e->b.angle, t, e->t) +
                               term * (e->a.weight + UNIT));
}

/*
 * tan((theta_f - theta_1) / 2) for the follower that leaves at theta_f and stood at theta_1 when its leader
 * was upright's: the step of chain_rise from theta_leave, where a = 0, so Y = r L x, and
 * cos - cos theta_leave = (leave_at - leave_by v) / leave_by is what the leader's arm is made of.
 */
static real leaving_half_turn(const struct lean *g, const struct link *leader)
{
    real rL = g->r * g->L, x = leader->tilt.x, sines = g->leave.x + x, Y = leader->turn.Y;
    if (sines == 0) /* r s = 1: it lies at theta_f from the first */
        return 0;
    real t = leader->turn.arm * (Y + rL * x) / (g->leave_by * sines);
    real whole = rL * g->leave.x + Y, F = leader->turn.arm / whole, G = rL * sines / whole;
    return t * F / (1 + t * t * G);
}

/*
 * Two chains run side by side: a from the head's tilt, b from upright.  With t = tan((theta_a - theta_b)/2)
 * of one domino, its follower has, exactly, t (1 - G) / (1 + t^2 G), G = r L (x_a + x_b) / (Y_a + Y_b),
 * because X_a - X_b = r L (y_a - y_b).  G is the slope's r L x / Y (b10) between the two tilts; so the
 * smallest differences keep their digits.
 */
static enum dom_status rise_between(const struct lean *g, struct tilt from, struct tilt head, real t,
                                    struct sums *sums, struct sums *error)
{
    struct sum_state state = {0};
    struct link a = link_head(g, head), b = link_head(g, from);
    struct rise_error e = error ? error_head(g, &a, &b, t) : (struct rise_error){.t = 0};
    bool ended = true;
    for (;;) {
        enum dom_status status = chain_watch(g, a.i);
        if (status != DOM_OK)
            return status;
        add_J(&state, &a);
        add_H1(&state, &a);
        series_add(&state.dH, a.weight * rise(a.lean, a.tilt, b.tilt, t));
        if (error)
            error_add(g, &e, &a, &b, t);
        if (a.i + 1 >= g->n || !b.leads)
            break;
        struct link leader = b;
        if (!a.leads) {
            /* The follower has left during this cycle: it keeps the energy of theta_f. */
            link_next(&b);
            real t_f = leaving_half_turn(g, &leader);
            state.left = b.weight * rise(g, g->f, b.tilt, t_f);
            series_add(&state.dH, state.left);
            if (error) {
                real angle = lean_error_f(g), t_error = bound_leaving(g, &leader, &e.b, t_f);
                bound_next(g, &leader, &b, &e.b);
                e.sums.dH += b.weight * (bound_rise(g, g->f, b.tilt, angle, e.b.angle, t_f, t_error) +
                                         fabs(rise(g, g->f, b.tilt, t_f)) * (e.b.weight + UNIT));
            }
            break;
        }
        /* F = 1 - G, from the arms: the smallest slopes keep their digits, too. */
        real Y = a.turn.Y + b.turn.Y, F = t == 0 ? 1 : (a.turn.arm + b.turn.arm) / Y;
        real G = t == 0 ? 0 : a.lean->r * a.lean->L * (a.tilt.x + b.tilt.x) / Y;
        real ratio = fmax(a.lean->weight * F, a.lean->decay);
        ended = false;
        if (series_done(&state.dH, a.weight * 2 * t * a.lean->reach, ratio, g->tol) && done_J(&state, &a) &&
            done_H1(&state, &a, g->tol))
            break;
        ended = true;
        if (error)
            e.t = bound_half_turn(&a, &b, &e.a, &e.b, t, e.t, F);
        t *= F / (1 + t * t * G);
        if (error) {
            struct link leader_a = a;
            link_next(&a);
            link_next(&b);
            bound_next(g, &leader_a, &a, &e.a);
            bound_next(g, &leader, &b, &e.b);
        } else {
            link_next(&a);
            link_next(&b);
        }
    }
    if (error)
        *error = (struct sums){.J = e.sums.J + series_error(&state.J, ended),
                               .H1 = e.sums.H1 + series_error(&state.H1, ended),
                               .dH = e.sums.dH + series_error(&state.dH, ended)};
    return sum_result(g, &state, a.i + 1, sums);
}

KERNEL enum dom_status chain_rise(const struct lean *g, struct tilt head, struct sums *sums,
                                  struct sums *error)
{
    return rise_between(g, (struct tilt){0, 1, 0}, head, head.x / (1 + head.y), sums, error);
}

KERNEL enum dom_status chain_rise_from(const struct lean *g, struct tilt from, struct tilt head,
                                       struct sums *sums)
{
    /* tan of half the difference. */
    real sine = head.x * from.y - head.y * from.x, cosine = head.y * from.y + head.x * from.x;
    return rise_between(g, from, head, sine / (1 + cosine), sums, NULL);
}

KERNEL enum dom_status chain_leave(const struct lean *g, bool *leaves, struct tilt *head, size_t *domino)
{
    *leaves = false;
    if (!g->falls_off)
        return DOM_OK;
    struct link b = link_head(g, (struct tilt){0, 1, 0});
    real passed = 1; /* S_i: where dominoes rub it need not vanish with the slope */
    while (b.leads) {
        enum dom_status status = chain_watch(g, b.i);
        if (status != DOM_OK)
            return status;
        /* Whether a domino falls off that carries less than rounding changes nothing. */
        if (b.i + 1 >= g->n || b.weight * fmax(b.slope, passed) < REAL_EPSILON * REAL_EPSILON)
            return DOM_OK;
        passed = g->mu > 0 ? passed * fabs(friction_share(&b)) : 0;
        link_next(&b);
    }
    /* Domino b.i has no follower at 0: it falls off when domino b.i - 1 comes to theta_leave. */
    *head = g->leave;
    for (size_t i = b.i; i > 1; i--)
        *head = lean_leader(g, *head);
    if (domino)
        *domino = b.i;
    *leaves = true;
    return DOM_OK;
}

KERNEL enum dom_status chain_edges(const struct lean *g, real end, real edge[CHAIN_EDGES], int *edges)
{
    bool leaves;
    struct tilt leave;
    enum dom_status status = chain_leave(g, &leaves, &leave, NULL);
    if (status != DOM_OK)
        return status;
    /* At r s = 1 the follower is gone for every theta > 0: H' jumps at 0, and its right limit counts. */
    edge[0] = g->short_of == 0 ? fmin(REAL_MIN, end) : 0;
    *edges = 1;
    real theta_leave = leaves ? tilt_angle(leave) : 0;
    if (theta_leave > edge[0] && theta_leave < end)
        edge[(*edges)++] = theta_leave;
    edge[(*edges)++] = end;
    return DOM_OK;
}

/* ---- Public ---- */

static struct dom_link link_public(const struct lean *g, const struct link *k)
{
    real b = k->leads ? k->turn.Y / g->r : REAL_NAN; /* (table 1) */
    return (struct dom_link){
        .i = k->i,
        .theta = tilt_angle(k->tilt),
        .slope = k->slope,
        .arm_a = k->leads ? k->turn.arm / g->r : REAL_NAN,
        .arm_b = b,
        .weight = k->weight,
    };
}

static struct dom_link link_error(const struct lean *g, const struct link *k, const struct bound *e)
{
    real b = k->leads ? e->Y / g->r + UNIT * k->turn.Y / g->r : REAL_NAN;
    return (struct dom_link){
        .theta = e->angle + 2 * UNIT * tilt_angle(k->tilt),
        .slope = e->slope,
        .arm_a = k->leads ? (e->arm + UNIT * k->turn.arm) / g->r : REAL_NAN,
        .arm_b = b,
        .weight = e->weight * k->weight,
    };
}

KERNEL enum dom_status chain_walk(const struct dom_train *train, dom_real theta, bool errors,
                                  dom_visit *visit, void *context)
{
    struct lean g;
    struct tilt head;
    enum dom_status status = lean_make_tilted(train, theta, &g, &head);
    struct sums sums = {0};
    if (status == DOM_OK)
        status = chain_sum(&g, head, &sums);
    if (status != DOM_OK)
        return status;
    struct link k = link_head(&g, head);
    struct bound e = bound_head(&g, &k, lean_error_head(head));
    for (;;) {
        if (dom_raised(g.interrupt)) /* rows may be slower to write than to compute */
            return DOM_INTERRUPTED;
        struct dom_link link = link_public(&g, &k), error;
        if (errors)
            error = link_error(&g, &k, &e);
        if (!visit(&link, errors ? &error : NULL, context) || !k.leads || k.i + 1 >= sums.n)
            return DOM_OK;
        struct link leader = k;
        link_next(&k);
        if (errors)
            bound_next(&g, &leader, &k, &e);
    }
}

KERNEL enum dom_status contact_find(const struct dom_train *train, dom_real theta,
                                    struct dom_contact *contact, struct dom_contact *error)
{
    struct lean g;
    struct tilt head;
    enum dom_status status = lean_make_tilted(train, theta, &g, &head);
    if (status != DOM_OK)
        return status;
    struct link k = link_head(&g, head), leader = k;
    struct dom_link link = link_public(&g, &k);
    struct bound e = bound_head(&g, &k, lean_error_head(head));
    struct dom_link link_bound = link_error(&g, &k, &e);
    bool leads = k.leads;
    real theta_1 = tilt_angle(g.f), slope = 0, angle_error = lean_error_f(&g), slope_error = 0;
    if (leads) {
        link_next(&k);
        bound_next(&g, &leader, &k, &e);
        theta_1 = tilt_angle(k.tilt);
        slope = k.slope;
        angle_error = e.angle;
        slope_error = e.slope;
    }
    *contact = (struct dom_contact){theta_1, slope, link.arm_a, link.arm_b};
    if (error)
        *error = (struct dom_contact){angle_error + 2 * UNIT * theta_1, slope_error, link_bound.arm_a,
                                      link_bound.arm_b};
    return DOM_OK;
}
