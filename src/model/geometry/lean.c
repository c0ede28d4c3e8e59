/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "geometry/lean.h"

/* r^q, and r^q - 1 free of cancellation. */
static void lean_powers(real r, real q, real *rq, real *rq_1)
{
    const int whole = (int)q;
    if (q == (real)whole && whole <= 8) { /* hollow and massive: r^q - 1 = (r - 1) (1 + r + ...) */
        real power = r, sum = 1;
        for (int k = 1; k < whole; k++) {
            sum += power;
            power *= r;
        }
        *rq = power;
        *rq_1 = (r - 1) * sum;
        return;
    }
    *rq = pow(r, q);
    /* The logarithm would cost digits where r^q is large, the difference where it is near 1. */
    *rq_1 = *rq > 2 ? *rq - 1 : expm1(q * log1p(r - 1));
}

KERNEL struct lean lean_read(const struct dom_train *t)
{
    struct lean g = {.s = (real)t->s,
                     .r = (real)t->r,
                     .d = (real)t->d,
                     .q = (real)t->q,
                     .tol = (real)t->tol,
                     .mu = (real)t->mu,
                     .n = CHAIN_ENDLESS,
                     .interrupt = t->interrupt,
                     .work = t->work};
    g.reach = sqrt(1 + g.d * g.d);
    return g;
}

static struct far far_make(const struct lean *g)
{
    real w = g->weight, m = g->inertia, x = g->inf.x, y = g->inf.y, d = g->d;
    /* theta_1 and its derivatives: of its slope 1 - r L x / Y, since Y' = 0 and Y'' = -(r L x)^2. */
    real off = g->r * g->L * x, slope = 1 - off, bend = -g->r * d, twist = off * (1 - off * off);
    real slope2 = slope * slope, slope3 = slope2 * slope;
    real h1 = d * y - x, h2 = -(y + d * x), h3 = -h1;
    struct far f = {.per_sine = 1 / x};
    f.half_cot = y * f.per_sine / 2;
    /* 1 - r^-q slope^k, from r^q - 1. */
    f.H1 = h1 / (w * (g->rq_1 + off));
    f.H2 = (h2 + w * bend * f.H1) / (w * (g->rq_1 + off * (1 + slope)));
    f.H3 = (h3 + w * (twist * f.H1 + 3 * slope * bend * f.H2)) / (w * (g->rq_1 + off * (1 + slope + slope2)));
    f.J0 = 1 / (1 - m * slope2);
    f.J1 = 2 * m * slope * bend * f.J0 / (1 - m * slope3);
    f.J2 =
        m * (2 * (bend * bend + slope * twist) * f.J0 + 5 * slope2 * bend * f.J1) / (1 - m * slope3 * slope);
    return f;
}

KERNEL enum dom_status lean_set(struct lean *g, real s, real r)
{
    real d = g->d, L = s + d;
    g->s = s;
    g->r = r;
    g->L = L;
    g->rs = r * s;
    g->rL = r * L;
    /* The fma gives 1 - r s with one rounding. */
    real short_of = fma(-r, s, 1);
    /* A unit in the last place of 1: no more than r s gains where s and r = 1/s are both rounded. */
    if (short_of < -REAL_EPSILON)
        return DOM_OUT_OF_REACH;
    g->short_of = fmax(short_of, 0);
    lean_powers(r, g->q, &g->rq, &g->rq_1);
    /* The kinetic energy (c6) is as small as r^-(2q+1); below this it would lose its digits. */
    if (!(g->rq * g->rq * r < REAL_EPSILON / REAL_MIN))
        return DOM_UNDERFLOW;
    g->weight = 1 / g->rq;
    g->inertia = g->weight / r;

    g->c = tilt_make(fmin(r * s, 1), sqrt(g->short_of * (1 + r * s)));
    real x_inf = sqrt(s * (s + 2 * d)) / L;
    g->inf = (struct tilt){x_inf, d / L, s / L};
    g->decay = g->weight * fmax(0, 1 - r * L * x_inf);

    /* (A17): theta_leave < theta_inf.  1 - cos theta_leave = (1/r^2 - s^2) / (2 d L). */
    g->leave_at = g->short_of * (1 + r * s);
    g->leave_by = 2 * d * L * r * r;
    real v_leave = g->leave_at / g->leave_by;
    g->falls_off = v_leave < g->inf.v;
    g->f = g->inf;
    if (g->falls_off) {
        g->leave = (struct tilt){sqrt(v_leave * (2 - v_leave)), 1 - v_leave, v_leave};
        /* (A18), and 1 - sin theta_f = (d - (1/r - L)) (d + (1/r - L)) r / (2 L) for the cosine. */
        real one_minus_x = (2 * r * d - g->short_of) * g->short_of / (2 * r * L);
        real x_f =
            2 * one_minus_x < 1 ? 1 - one_minus_x : fmin((1 + r * r * s * (s + 2 * d)) / (2 * r * L), 1);
        g->f = tilt_make(x_f, sqrt(one_minus_x * (2 - one_minus_x)));
    }
    if (!g->falls_off)
        g->far = far_make(g);
    return DOM_OK;
}

KERNEL enum dom_status lean_make(const struct dom_train *train, struct lean *lean)
{
    *lean = lean_read(train);
    return lean_set(lean, lean->s, lean->r);
}

KERNEL enum dom_status lean_tilt(const struct lean *lean, real theta, struct tilt *tilt)
{
    real theta_c = tilt_angle(lean->c);
    if (!(theta >= 0) || theta > theta_c * (1 + 2 * REAL_EPSILON))
        return DOM_BAD_TILT;
    *tilt = theta < theta_c ? tilt_make(sin(theta), cos(theta)) : lean->c;
    return DOM_OK;
}

KERNEL enum dom_status lean_make_tilted(const struct dom_train *train, dom_real theta, struct lean *lean,
                                        struct tilt *head)
{
    enum dom_status status = lean_make(train, lean);
    return status == DOM_OK ? lean_tilt(lean, (real)theta, head) : status;
}

KERNEL struct tilt lean_leader(const struct lean *g, struct tilt follower)
{
    /* (b8) with the follower given: A cos theta + B sin theta = d, of whose two roots the smaller. */
    real A = g->L - follower.x / g->r, B = follower.y / g->r;
    real R = hypot(A, B), root = sqrt(fmax((R - g->d) * (R + g->d), 0));
    return tilt_make(fmax((B * g->d - A * root) / (R * R), 0), (A * g->d + B * root) / (R * R));
}

/* ---- Errors, in angles: both coordinates of a tilt carry a few units of their own size ---- */

/* Of what was rounded at most `units` times in each coordinate. */
static real tilt_error(struct tilt t, real units)
{
    return units * UNIT * t.x * t.y;
}

KERNEL real lean_error_head(struct tilt head)
{
    return tilt_error(head, 4);
}

KERNEL real lean_error_f(const struct lean *g)
{
    return g->falls_off ? tilt_error(g->f, 12) : tilt_error(g->inf, 6);
}

/* theta_leave comes from its 1 - cos, whose derivative is the sine. */
static real lean_error_leave(const struct lean *g)
{
    return g->leave.x > 0 ? 6 * UNIT * g->leave.v / g->leave.x + tilt_error(g->leave, 2) : REAL_MIN;
}

/* ---- Public ---- */

KERNEL enum dom_status angles_find(const struct dom_train *train, struct dom_angles *angles,
                                   struct dom_angles *error)
{
    struct lean g;
    enum dom_status status = lean_make(train, &g);
    if (status != DOM_OK)
        return status;
    *angles = (struct dom_angles){
        .theta_c = tilt_angle(g.c),
        .theta_u = atan(g.d),
        .theta_inf = tilt_angle(g.inf),
        .theta_f = tilt_angle(g.f),
        .theta_leave = g.falls_off ? tilt_angle(g.leave) : REAL_NAN,
        .falls_off = g.falls_off,
    };
    if (error) /* the arc functions add one unit, or two */
        *error = (struct dom_angles){
            .theta_c = lean_error_head(g.c) + 2 * UNIT * angles->theta_c,
            .theta_u = 2 * UNIT * angles->theta_u,
            .theta_inf = tilt_error(g.inf, 6) + 2 * UNIT * angles->theta_inf,
            .theta_f = lean_error_f(&g) + 2 * UNIT * angles->theta_f,
            .theta_leave = g.falls_off ? lean_error_leave(&g) + 2 * UNIT * angles->theta_leave : DOM_NAN,
        };
    return DOM_OK;
}
