/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dynamics/friction.h"

/*
 * From A(theta) = 1 + r^-(q+1) S_1 theta_1' A(theta_1) and its kind, derived twice at theta_1 = theta =
 * theta_inf, where X = 0 and Y = 1.
 */
static struct far_rubbing far_rubbing_make(const struct geometry *geometry)
{
    real w = geometry->weight, m = geometry->inertia, x = geometry->inf.x, y = geometry->inf.y,
         d = geometry->d, mu = geometry->mu;
    real o = geometry->r * geometry->L * x, p = geometry->r * d; /* -X' and -X'' */
    /* theta_1', as a function of theta, and theta_1'', each with its derivatives. */
    const real step[] = {1 - o, -p, o * (1 - o * o)}, contact[] = {-p, step[2], p * (1 - 6 * o * o)};
    /* S_1 = a / b. */
    const real above[] = {1 - o - mu * p, -p, o * (1 - o)}, below1 = -mu * o, below2 = -o * o - mu * p;
    const real S1 = above[1] - above[0] * below1,
               S[] = {above[0], S1, above[2] - 2 * S1 * below1 - above[0] * below2};
    const real k = step[0], k1 = step[1];
    /* Of the products S theta_1', S theta_1'^2 and S theta_1''. */
    const real a[] = {S[0] * k, S[1] * k + S[0] * k1, S[2] * k + 2 * S[1] * k1 + S[0] * step[2]};
    const real b[] = {a[0] * k, a[1] * k + a[0] * k1, a[2] * k + 2 * a[1] * k1 + a[0] * step[2]};
    const real c[] = {S[0] * contact[0], S[1] * contact[0] + S[0] * contact[1],
                      S[2] * contact[0] + 2 * S[1] * contact[1] + S[0] * contact[2]};
    const real h[] = {(x - d * y) / 2, (y + d * x) / 2, (d * y - x) / 2};
    struct far_rubbing f = {.known = fabs(above[0]) < 1};
    /* 1 - r^-q S_1, from r^q - 1. */
    f.C[0] = h[0] / (w * (geometry->rq_1 + o + mu * p));
    f.C[1] = (h[1] + w * S[1] * f.C[0]) / (1 - w * S[0] * k);
    f.C[2] = (h[2] + w * (S[2] * f.C[0] + (2 * S[1] * k + S[0] * k1) * f.C[1])) / (1 - w * S[0] * k * k);
    f.A[0] = 1 / (1 - m * a[0]);
    f.A[1] = m * a[1] * f.A[0] / (1 - m * a[0] * k);
    f.A[2] = m * (a[2] * f.A[0] + (2 * a[1] * k + a[0] * k1) * f.A[1]) / (1 - m * a[0] * k * k);
    f.B[0] = m * c[0] * f.A[0] / (1 - m * b[0]);
    f.B[1] = m * (b[1] * f.B[0] + c[1] * f.A[0] + c[0] * k * f.A[1]) / (1 - m * b[0] * k);
    f.B[2] = m *
             (b[2] * f.B[0] + (2 * b[1] * k + b[0] * k1) * f.B[1] + c[2] * f.A[0] +
              (2 * c[1] * k + c[0] * k1) * f.A[1] + c[0] * k * k * f.A[2]) /
             (1 - m * b[0] * k * k);
    return f;
}

KERNEL void geometry_flow(struct geometry *geometry, struct flow *flow)
{
    geometry->flow = flow;
    if (geometry->mu == 0)
        return;
    flow->solution.panels = 0;
    flow->far.known = false;
    if (!geometry->detaches)
        flow->far = far_rubbing_make(geometry);
}

KERNEL void flow_free(struct flow *flow)
{
    num_linear_free(&flow->solution);
}

static void friction_count(const struct geometry *geometry, size_t n)
{
    chain_count(geometry, n);
    if (geometry->work)
        geometry->work->entered[DOM_EFFECT_friction]++;
}

/* One domino, its S_i, and theta_i''. */
struct rubbing {
    struct link link;
    real S, second_derivative;
    real noise;  /* of S, in roundings: more than 1 where b = Y + mu X cancels, since X < 0 */
    bool behind; /* a force passes behind the hinge of a follower, which lies too flat: b <= 0 */
};

static void rubbing_next(struct rubbing *k)
{
    struct link leader = k->link;
    real b = contact_arm_b(&leader);
    k->behind = k->behind || b <= 0;
    k->noise +=
        leader.contact.X < 0 ? (leader.contact.Y - leader.geometry->mu * leader.contact.X) / fabs(b) - 1 : 0;
    k->S *= torque_ratio(&k->link);
    link_next(&k->link);
    k->second_derivative = link_second_derivative(&leader, k->second_derivative, &k->link);
}

static void drive_add(const struct rubbing *k, struct series *C)
{
    const struct link *link = &k->link;
    series_add(C, link->weight * k->S * (link->tilt.x - link->geometry->d * link->tilt.y) / 2);
}

/*
 * Is C known to a tolerance, and are all three sums?  Far down, dominoes pass on no more than near the end of
 * an endless train.
 */
static bool drive_done(const struct rubbing *k, struct series *C, real tol)
{
    const struct geometry *geometry = k->link.geometry;
    real ratio = fmax(geometry->weight * fabs(torque_ratio(&k->link)), geometry->decay);
    return series_done(C, k->link.weight * fabs(k->S) * geometry->reach, ratio, tol);
}

static bool rubbing_done(const struct rubbing *k, struct series *A, struct series *B, struct series *C)
{
    const struct link *link = &k->link;
    const struct geometry *geometry = link->geometry;
    real S = fabs(k->S), Y = link->contact.Y,
         margin_slope = geometry->r * geometry->L / (Y * Y) * link->slope * link->slope;
    real ratio = fmax(geometry->inertia * fabs(torque_ratio(link)), fmax(geometry->decay, geometry->decay_J));
    return drive_done(k, C, geometry->tol) &&
           series_done(A, link->inertia * S * link->slope, ratio, geometry->tol) &&
           series_done(B, link->inertia * S * (fabs(k->second_derivative) + margin_slope), ratio,
                       geometry->tol);
}

static real far_value(const real f[3], real e)
{
    return f[0] - f[1] * e + f[2] * e * e / 2;
}

/* The rest of C from this domino on, where it is so near to theta_inf that the last term does not matter. */
static bool drive_closes(const struct rubbing *k, struct series *C, real tol)
{
    const struct link *link = &k->link;
    const struct geometry *geometry = link->geometry;
    if (geometry->n != CHAIN_ENDLESS || geometry->behind || !geometry->flow->far.known)
        return false;
    const struct far_rubbing *far = &geometry->flow->far;
    real e = far_off(geometry, link->tilt), part = link->weight * k->S;
    if (e > geometry->inf.x / 16 || !far_done(C, part * far->C[0], part * far->C[2] * e * e, tol))
        return false;
    series_add(C, part * far_value(far->C, e));
    return true;
}

/* The same of all three. */
static bool rubbing_closes(const struct rubbing *k, struct series *A, struct series *B, struct series *C)
{
    const struct link *link = &k->link;
    const struct geometry *geometry = link->geometry;
    const struct far_rubbing *far = &geometry->flow->far;
    real e = far_off(geometry, link->tilt), part = link->inertia * k->S, slope = link->slope;
    if (geometry->n != CHAIN_ENDLESS || geometry->behind || !far->known ||
        !far_done(A, part * slope * far->A[0], part * slope * far->A[2] * e * e, geometry->tol))
        return false;
    real rest = part * (k->second_derivative * far->A[0] + slope * slope * far->B[0]),
         last = part * (fabs(k->second_derivative * far->A[2]) + slope * slope * fabs(far->B[2])) * e * e;
    if (!far_done(B, rest, last, geometry->tol) || !drive_closes(k, C, geometry->tol))
        return false;
    series_add(A, part * slope * far_value(far->A, e));
    series_add(B,
               part * (k->second_derivative * far_value(far->A, e) + slope * slope * far_value(far->B, e)));
    return true;
}

KERNEL enum dom_status friction_equation_of_motion(const struct geometry *geometry, struct tilt head,
                                                   struct equation_of_motion *equation_of_motion)
{
    struct series A = {0}, B = {0}, C = {0};
    struct rubbing k = {.link = link_head(geometry, head), .S = 1, .noise = 1};
    for (;;) {
        const struct link *link = &k.link;
        enum dom_status status = chain_watch(geometry, link->i);
        if (status != DOM_OK)
            return status;
        if (rubbing_closes(&k, &A, &B, &C))
            break;
        series_add(&A, link->inertia * k.S * link->slope);
        series_add(&B, link->inertia * k.S * k.second_derivative);
        drive_add(&k, &C);
        if (link->i + 1 >= geometry->n || !link->leads || rubbing_done(&k, &A, &B, &C))
            break;
        rubbing_next(&k);
    }
    friction_count(geometry, k.link.i + 1);
    *equation_of_motion = (struct equation_of_motion){.A = A.sum + A.lost,
                                                      .B = B.sum + B.lost,
                                                      .C = C.sum + C.lost,
                                                      .A_size = A.size * k.noise,
                                                      .B_size = B.size * k.noise,
                                                      .C_size = C.size * k.noise,
                                                      .n = k.link.i + 1};
    equation_of_motion->locks = k.behind || equation_of_motion->A <= 0;
    return isfinite(equation_of_motion->A) && isfinite(equation_of_motion->B) &&
                   isfinite(equation_of_motion->C)
               ? DOM_OK
               : DOM_NOT_FINITE;
}

KERNEL enum dom_status friction_drive(const struct geometry *geometry, struct tilt head, real tol,
                                      real *drive)
{
    struct series C = {0};
    struct rubbing k = {.link = link_head(geometry, head), .S = 1};
    for (;;) {
        enum dom_status status = chain_watch(geometry, k.link.i);
        if (status != DOM_OK)
            return status;
        if (drive_closes(&k, &C, tol))
            break;
        drive_add(&k, &C);
        if (k.link.i + 1 >= geometry->n || !k.link.leads || drive_done(&k, &C, tol))
            break;
        k.S *= torque_ratio(&k.link);
        link_next(&k.link);
    }
    friction_count(geometry, k.link.i + 1);
    *drive = C.sum + C.lost;
    return isfinite(*drive) ? DOM_OK : DOM_NOT_FINITE;
}

/* Of all passes of a flow, some hundred: in double they take half a second. */
#define FLOW_DOMINOES ((size_t)8000000)

struct flow_context {
    const struct geometry *geometry;
    enum dom_status status;
    real locked;     /* the last tilt that was found locked */
    size_t dominoes; /* so far */
};

/* dw/dtheta = -2 B / A w + 2 C / A. */
static bool flow_rate(real theta, void *context, struct num_rate *rate)
{
    struct flow_context *f = context;
    struct tilt head;
    struct equation_of_motion equation_of_motion = {.n = 0};
    f->status = geometry_tilt(f->geometry, theta, &head);
    if (f->status == DOM_OK)
        f->status = friction_equation_of_motion(f->geometry, head, &equation_of_motion);
    f->dominoes += f->status == DOM_OK ? equation_of_motion.n : 0;
    if (f->dominoes > FLOW_DOMINOES)
        f->status = DOM_TOO_LONG;
    if (f->status == DOM_OK && equation_of_motion.locks) {
        f->status = DOM_LOCKS;
        f->locked = theta;
    }
    if (f->status != DOM_OK)
        return false;
    const real units = 32 * UNIT / equation_of_motion.A,
               of_A = equation_of_motion.A_size / equation_of_motion.A;
    *rate =
        (struct num_rate){.p = -2 * equation_of_motion.B / equation_of_motion.A,
                          .c = 2 * equation_of_motion.C / equation_of_motion.A,
                          .p_noise = units * (equation_of_motion.B_size + fabs(equation_of_motion.B) * of_A),
                          .c_noise = units * (equation_of_motion.C_size + fabs(equation_of_motion.C) * of_A)};
    return true;
}

/* The hitting train has all but the head, which stands upright. */
static enum dom_status flow_collision(const struct geometry *geometry, struct flow *flow)
{
    struct equation_of_motion at_c;
    struct sums sums;
    struct geometry hitting = *geometry;
    struct link upright = link_head(geometry, standing);
    hitting.n = geometry->n == CHAIN_ENDLESS ? CHAIN_ENDLESS : geometry->n - 1;
    enum dom_status status =
        contact_arm_a(&upright) > 0 ? friction_equation_of_motion(&hitting, geometry->c, &at_c) : DOM_LOCKS;
    if (status == DOM_OK)
        status = chain_sum(&hitting, geometry->c, &sums);
    if (status != DOM_OK)
        return status;
    flow->inertia_ratio = geometry->inertia * torque_ratio(&upright) * at_c.A;
    flow->J0 = 1 + geometry->inertia * sums.J;
    flow->J_c = sums.J;
    return flow->inertia_ratio > 0 ? DOM_OK : DOM_LOCKS;
}

/*
 * From upright on, u moves by d^2 up to theta ~ d, and by much more behind: it is told apart there on panels
 * of its own, and so it is near the tilt sqrt(1 - r s), where followers come down.
 */
static enum dom_status flow_finely(struct flow_context *c, real tol, real *lo, real hi)
{
    const struct geometry *geometry = c->geometry;
    real finest = geometry->short_of > 0 ? fmin(geometry->d, sqrt(geometry->short_of)) : geometry->d;
    for (real to = finest; *lo < to && to < hi / 8; to *= 8) {
        enum num_status solver = num_linear_solve(flow_rate, c, *lo, to, tol / 8, &geometry->flow->solution);
        if (solver != NUM_OK)
            return model_status(c->status, solver);
        *lo = to;
    }
    return DOM_OK;
}

/* Over the smooth parts between the edges. */
static enum dom_status flow_solve(struct flow_context *c, real tol, const real *edge, int edges)
{
    for (int i = 1; i < edges; i++) {
        real lo = edge[i - 1];
        enum dom_status status = lo <= REAL_MIN ? flow_finely(c, tol, &lo, edge[i]) : DOM_OK;
        if (status != DOM_OK)
            return status;
        enum num_status solver =
            num_linear_solve(flow_rate, c, lo, edge[i], tol / 8, &c->geometry->flow->solution);
        if (solver != NUM_OK)
            return model_status(c->status, solver);
    }
    return DOM_OK;
}

/* To a series a sum that ends elsewhere is a jump: it must stay below what the series resolves. */
static struct geometry flow_begin(const struct geometry *geometry)
{
    struct geometry fine = *geometry;
    fine.tol = fmax(geometry->tol / 64, 64 * REAL_EPSILON);
    geometry->flow->solution.panels = 0;
    geometry->flow->tol = geometry->tol;
    return fine;
}

KERNEL enum dom_status friction_flow(const struct geometry *geometry)
{
    struct flow *flow = geometry->flow;
    if (flow->solution.panels > 0 && flow->tol <= geometry->tol)
        return DOM_OK;
    struct geometry fine = flow_begin(geometry);
    real edge[CHAIN_EDGES];
    int edges;
    enum dom_status status = chain_edges(geometry, tilt_angle(geometry->c), edge, &edges);
    if (status != DOM_OK)
        return status;
    struct flow_context c = {.geometry = &fine};
    status = flow_collision(&fine, flow);
    return status == DOM_OK ? flow_solve(&c, geometry->tol, edge, edges) : status;
}

/* How far the flow has come. */
static real flow_end(const struct flow *flow, real lo)
{
    return flow->solution.panels > 0 ? flow->solution.panel[flow->solution.panels - 1].hi : lo;
}

/*
 * Comes to where A vanishes as near as the tolerance asks, by halving the way to a tilt that is locked; the
 * panels become as short as what is left, since 2 B / A has a pole there.
 */
static enum dom_status flow_to_lock(const struct geometry *fine, real tol, real lo, real locked, real *hi)
{
    struct flow_context c = {.geometry = fine, .status = DOM_OK, .locked = locked};
    struct flow *flow = fine->flow;
    for (;;) {
        real from = flow_end(flow, lo), to = from + (c.locked - from) / 2;
        if (!(c.locked - from > tol * c.locked && to > from && to < c.locked))
            break;
        enum num_status solver = num_linear_solve(flow_rate, &c, from, to, tol / 8, &flow->solution);
        if (solver == NUM_NOT_CONVERGED && c.status == DOM_OK)
            break; /* so near to the pole that its panels have no digits left */
        if (solver != NUM_OK && c.status != DOM_LOCKS)
            return model_status(c.status, solver);
    }
    *hi = flow_end(flow, lo);
    return DOM_LOCKS;
}

/* Where panels became too short before a pole: a locked tilt close behind; NaN where there is none. */
static real flow_locked_near(const struct geometry *geometry, real from, real hi)
{
    for (real step = 4 * REAL_EPSILON * hi; from + step < hi; step *= 2) {
        struct tilt head;
        struct equation_of_motion equation_of_motion;
        if (geometry_tilt(geometry, from + step, &head) != DOM_OK ||
            friction_equation_of_motion(geometry, head, &equation_of_motion) != DOM_OK)
            break;
        if (equation_of_motion.locks)
            return from + step;
    }
    return REAL_NAN;
}

KERNEL enum dom_status friction_flow_piece(const struct geometry *geometry, real J0, real lo, real *hi)
{
    struct geometry fine = flow_begin(geometry);
    struct flow_context c = {.geometry = &fine, .locked = REAL_NAN};
    geometry->flow->J0 = J0;
    enum dom_status status = flow_solve(&c, geometry->tol, (real[]){lo, *hi}, 2);
    if (status == DOM_NOT_CONVERGED)
        c.locked = flow_locked_near(&fine, flow_end(geometry->flow, lo), *hi);
    bool locks = status == DOM_LOCKS || (status == DOM_NOT_CONVERGED && !isnan(c.locked));
    return locks ? flow_to_lock(&fine, geometry->tol, lo, c.locked, hi) : status;
}

KERNEL void friction_at(const struct geometry *geometry, real theta, real *ln_G, real *u)
{
    num_linear_at(&geometry->flow->solution, theta, ln_G, u);
    *u = -*u;
}

KERNEL real friction_climb(const struct geometry *geometry, real theta)
{
    real ln_G, u;
    friction_at(geometry, theta, &ln_G, &u);
    return geometry->flow->J0 * u;
}

KERNEL real friction_omegasq(const struct geometry *geometry, real omegasq_0, real theta)
{
    real ln_G, u;
    friction_at(geometry, theta, &ln_G, &u);
    return exp(ln_G) * (omegasq_0 - u);
}

KERNEL real friction_left(const struct geometry *geometry, real end, real by)
{
    real ln_G, u;
    friction_at(geometry, end - by, &ln_G, &u);
    return -exp(ln_G) * num_linear_moved(&geometry->flow->solution, end, by);
}

KERNEL enum dom_status friction_rate(const struct geometry *geometry, struct tilt head, real theta,
                                     real *rate)
{
    struct equation_of_motion equation_of_motion;
    real ln_G, u;
    enum dom_status status = friction_equation_of_motion(geometry, head, &equation_of_motion);
    friction_at(geometry, theta, &ln_G, &u);
    *rate = -2 * equation_of_motion.C / (equation_of_motion.A * exp(ln_G));
    return status;
}

KERNEL enum dom_status friction_flow_spent(const struct geometry *geometry, struct tilt from, real lo,
                                           real omegasq, real *hi)
{
    real rate = 0, ln_G, u;
    bool cut = false;
    enum dom_status status = friction_rate(geometry, from, lo, &rate);
    if (status != DOM_OK || !(rate > 0))
        return status;
    for (real close = lo + 4 * omegasq / rate; close < *hi && close > lo; close = lo + 4 * (close - lo)) {
        cut = true;
        status = friction_flow_piece(geometry, geometry->flow->J0, lo, &close);
        if (status != DOM_OK)
            return status;
        friction_at(geometry, close, &ln_G, &u);
        if (u >= omegasq) {
            *hi = close;
            return DOM_OK;
        }
    }
    /* It goes on for long enough to be seen in the whole. */
    return cut ? friction_flow_piece(geometry, geometry->flow->J0, lo, hi) : DOM_OK;
}
