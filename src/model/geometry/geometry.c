/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "geometry/geometry.h"

/* Finds r^q, and r^q - 1 without cancellation. */
static void geometry_powers(real r, real q, real *rq, real *rq_1)
{
    const int whole = (int)q;
    if (q == (real)whole && whole <= 8) { /* hollow and solid: r^q - 1 = (r - 1) (1 + r + ...) */
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
    /* The logarithm would lose digits where r^q is large, the difference where r^q is near 1. */
    *rq_1 = *rq > 2 ? *rq - 1 : expm1(q * log1p(r - 1));
}

KERNEL struct geometry geometry_read(const struct request *t)
{
    struct geometry geometry = {.s = (real)t->s,
                                .r = (real)t->r,
                                .d = (real)t->d,
                                .q = (real)t->q,
                                .tol = (real)t->tol,
                                .box = 1,
                                .n = CHAIN_ENDLESS,
                                .interrupt = t->interrupt,
                                .work = t->work};
    geometry.reach = sqrt(1 + geometry.d * geometry.d);
    geometry_gravity(&geometry, 0, 1);
    return geometry;
}

KERNEL void geometry_gravity(struct geometry *geometry, real along, real down)
{
    real d = geometry->d;
    geometry->g.along = along;
    geometry->g.down = down;
    geometry->h.x = d * down - along;
    geometry->h.y = down + d * along;
    geometry->upright = geometry->span = 1;
    geometry->rounded = (struct rounded){.tall = 1, .wide = d, .i.c = 1};
}

KERNEL enum dom_status geometry_set(struct geometry *geometry, real s, real r)
{
    real d = geometry->d, L = s + d;
    geometry->s = s;
    geometry->r = r;
    geometry->L = L;
    geometry->rs = r * s;
    geometry->rL = r * L;
    /* The fma gives 1 - r s with one rounding. */
    real short_of = fma(-r, s, 1);
    /* A unit in the last place of 1: r s can exceed 1 by no more where s and r = 1/s are both rounded. */
    if (short_of < -REAL_EPSILON)
        return DOM_OUT_OF_REACH;
    geometry->short_of = fmax(short_of, 0);
    geometry_powers(r, geometry->q, &geometry->rq, &geometry->rq_1);
    /* The kinetic energy (24; c6) is as small as r^-(2q+1); below this limit it would lose its digits. */
    if (!(geometry->rq * geometry->rq * r < REAL_EPSILON / REAL_MIN))
        return DOM_UNDERFLOW;
    geometry->weight = 1 / geometry->rq;
    geometry->inertia = geometry->weight / r;

    geometry->c = tilt_make(fmin(r * s, 1), sqrt(geometry->short_of * (1 + r * s)));
    real x_inf = sqrt(s * (s + 2 * d)) / L;
    geometry->inf = (struct tilt){x_inf, d / L, s / L};
    geometry->decay = geometry->weight * fmax(0, 1 - r * L * x_inf);

    /* (41; A17): theta_leave < theta_inf.  1 - cos theta_leave = (1/r^2 - s^2) / (2 d L). */
    geometry->leave_at = geometry->short_of * (1 + r * s);
    geometry->leave_by = 2 * d * L * r * r;
    real v_leave = geometry->leave_at / geometry->leave_by;
    geometry->detaches = v_leave < geometry->inf.v;
    geometry->f = geometry->inf;
    if (geometry->detaches) {
        geometry->leave = (struct tilt){sqrt(v_leave * (2 - v_leave)), 1 - v_leave, v_leave};
        /* (42; A18), and 1 - sin theta_f = (d - (1/r - L)) (d + (1/r - L)) r / (2 L) for the cosine. */
        real one_minus_x = (2 * r * d - geometry->short_of) * geometry->short_of / (2 * r * L);
        real x_f =
            2 * one_minus_x < 1 ? 1 - one_minus_x : fmin((1 + r * r * s * (s + 2 * d)) / (2 * r * L), 1);
        geometry->f = tilt_make(x_f, sqrt(one_minus_x * (2 - one_minus_x)));
    }
    geometry->far.order = 0;
    if (geometry->rounded.on)
        return rounded_set(geometry);
    return DOM_OK;
}

KERNEL enum dom_status geometry_tilt(const struct geometry *geometry, real theta, struct tilt *tilt)
{
    real theta_c = tilt_angle(geometry->c);
    if (!(theta >= geometry->lean) ||
        theta > theta_c + fabs(theta_c) * 2 * fmax(REAL_EPSILON, DOM_REAL_EPSILON))
        return DOM_BAD_TILT;
    *tilt = theta < theta_c ? tilt_make(sin(theta), cos(theta)) : geometry->c;
    return DOM_OK;
}

KERNEL real geometry_half_u(const struct geometry *geometry)
{
    if (geometry->rounded.roll != 0)
        return tan(geometry_theta_u(geometry) / 2);
    return geometry->h.x / (geometry->h.y + geometry->reach);
}

KERNEL real geometry_theta_u(const struct geometry *geometry)
{
    real level = atan(geometry->h.x / geometry->h.y), part = geometry->rounded.roll / geometry->reach;
    return part == 0 ? level : fmax(level + atan2(part, sqrt((1 - part) * (1 + part))), 0);
}

KERNEL real geometry_rise_u(const struct geometry *geometry)
{
    real half = geometry_half_u(geometry);
    if (geometry->rounded.roll == 0)
        return geometry->h.x * half;
    struct tilt u = tilt_half(half);
    return half * (geometry->h.x * (1 + u.y) - geometry->h.y * u.x) + geometry->rounded.roll * 2 * atan(half);
}

KERNEL struct tilt geometry_leader(const struct geometry *geometry, struct tilt follower)
{
    if (geometry->rounded.on)
        return rounded_leader(geometry, follower);
    /* (12; b8) for a given follower: A cos theta + B sin theta = d, of whose two roots this is the
     * smaller. */
    real A = geometry->L - follower.x / geometry->r, B = follower.y / geometry->r;
    real R = hypot(A, B), root = sqrt(fmax((R - geometry->d) * (R + geometry->d), 0));
    real least = geometry->lean < 0 ? sin(geometry->lean) : 0;
    return tilt_make(fmax((B * geometry->d - A * root) / (R * R), least),
                     (A * geometry->d + B * root) / (R * R));
}

/* ---- Errors, in angles: both coordinates of a tilt carry a few units of their own size ---- */

KERNEL real tilt_error(struct tilt t, real units)
{
    return units * UNIT * t.x * t.y;
}

KERNEL real geometry_error_head(struct tilt head)
{
    return tilt_error(head, 4);
}

/* theta_u is the direction of (h.y, h.x), which is exact on a level floor. */
KERNEL real geometry_error_u(const struct geometry *geometry)
{
    real reach = geometry->reach;
    struct tilt u = tilt_make(geometry->h.x / reach, geometry->h.y / reach);
    return geometry->g.along == 0 ? 0 : 3 * UNIT * geometry_height_terms(geometry, u) / reach;
}

KERNEL real geometry_error_f(const struct geometry *geometry)
{
    return geometry->detaches ? tilt_error(geometry->f, 12) : tilt_error(geometry->inf, 6);
}

/* theta_leave comes from its 1 - cos, whose derivative is the sine. */
KERNEL real geometry_error_leave(const struct geometry *geometry)
{
    return geometry->leave.x > 0
               ? 6 * UNIT * geometry->leave.v / geometry->leave.x + tilt_error(geometry->leave, 2)
               : REAL_MIN;
}
