/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "lean.h"
#include <float.h>

enum dom_status lean_make_at(const struct dom_train *train, double r, struct lean *lean)
{
    struct dom_train t = *train;
    t.r = r;
    enum dom_status status = dom_train_check(&t);
    if (status != DOM_OK)
        return status;

    double s = t.s, d = t.d, q = t.q, L = s + d;
    double ln_r = log1p(r - 1);
    struct lean g = {.s = s, .r = r, .d = d, .q = q, .tol = t.tol, .interrupt = t.interrupt, .L = L};
    /* The fma gives 1 - r s with one rounding; r = 1/s, rounded, may overshoot by half a unit. */
    g.short_of = fmax(fma(-r, s, 1), 0);
    g.rq = pow(r, q);
    g.rq_1 = expm1(q * ln_r);
    g.weight = pow(r, -q);
    g.inertia = pow(r, -(q + 1));

    g.c = tilt_make(fmin(r * s, 1), sqrt(g.short_of * (1 + r * s)));
    double x_inf = sqrt(s * (s + 2 * d)) / L;
    g.inf = (struct tilt){x_inf, d / L, s / L};
    g.decay = g.weight * fmax(0, 1 - r * L * x_inf);

    /* (A17): theta_leave < theta_inf.  1 - cos theta_leave = (1/r^2 - s^2) / (2 d L). */
    double v_leave = g.short_of * (1 + r * s) / (2 * d * L * r * r);
    g.falls_off = v_leave < g.inf.v;
    g.f = g.inf;
    if (g.falls_off) {
        g.leave = (struct tilt){sqrt(v_leave * (2 - v_leave)), 1 - v_leave, v_leave};
        /* (A18), and 1 - sin theta_f = (d - (1/r - L)) (d + (1/r - L)) r / (2 L) for the cosine. */
        double x_f = fmin((1 + r * r * s * (s + 2 * d)) / (2 * r * L), 1);
        double one_minus_x = (2 * r * d - g.short_of) * g.short_of / (2 * r * L);
        g.f = tilt_make(x_f, sqrt(one_minus_x * (2 - one_minus_x)));
    }
    *lean = g;
    return DOM_OK;
}

enum dom_status lean_make(const struct dom_train *train, struct lean *lean)
{
    return lean_make_at(train, train->r, lean);
}

enum dom_status lean_tilt(const struct lean *lean, double theta, struct tilt *tilt)
{
    double theta_c = tilt_angle(lean->c);
    if (!(theta >= 0) || theta > theta_c * (1 + 2 * DBL_EPSILON))
        return DOM_BAD_TILT;
    *tilt = theta < theta_c ? tilt_make(sin(theta), cos(theta)) : lean->c;
    return DOM_OK;
}

enum dom_status lean_make_tilted(const struct dom_train *train, double theta, struct lean *lean,
                                 struct tilt *head)
{
    enum dom_status status = lean_make(train, lean);
    return status == DOM_OK ? lean_tilt(lean, theta, head) : status;
}

struct tilt lean_leader(const struct lean *g, struct tilt follower)
{
    /* (b8) with the follower given: A cos theta + B sin theta = d, of whose two roots the smaller. */
    double A = g->L - follower.x / g->r, B = follower.y / g->r;
    double R = hypot(A, B), root = sqrt(fmax((R - g->d) * (R + g->d), 0));
    return tilt_make(fmax((B * g->d - A * root) / (R * R), 0), (A * g->d + B * root) / (R * R));
}

enum dom_status dom_angles_find(const struct dom_train *train, struct dom_angles *angles)
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
        .theta_leave = g.falls_off ? tilt_angle(g.leave) : DOM_NAN,
        .falls_off = g.falls_off,
    };
    return DOM_OK;
}
