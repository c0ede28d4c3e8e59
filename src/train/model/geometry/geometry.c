/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Sets what the passes of a train need for one separation and growth. Then the motion of one domino.
 * With sharp edges, the upper edge of a follower touches the flat back of its leader, and a domino turns
 * about the front edge of its foot. */
#include "geometry/geometry.h"

KERNEL void geometry_gravity(struct geometry *geometry, real along, real down)
{
    real d = geometry->d;
    geometry->g.along = along;
    geometry->g.down = down;
    geometry->h.x = d * down - along;
    geometry->h.y = down + d * along;
    geometry->upright_inertia = geometry->span = 1;
    geometry->rolls = false;
    geometry->rounded = (struct rounded){.tall = 1, .wide = d, .i.c = 1};
}

static void sharp_set(struct geometry *geometry)
{
    const real s = geometry->s, r = geometry->r, d = geometry->d, L = geometry->L;
    geometry->c = tilt_make(fmin(r * s, 1), sqrt(geometry->short_of * (1 + r * s)));
    real x_inf = sqrt(s * (s + 2 * d)) / L;
    geometry->inf = (struct tilt){x_inf, d / L, s / L};
    geometry->decay = geometry->weight * fmax(0, 1 - r * L * x_inf);

    /* Followers detach if theta_leave < theta_inf (41; A17). The tilt theta_leave follows from 1 - cos
     * theta_leave = (1/r^2 - s^2) / (2 d L). */
    geometry->leave_at = geometry->short_of * (1 + r * s);
    geometry->leave_by = 2 * d * L * r * r;
    real v_leave = geometry->leave_at / geometry->leave_by;
    geometry->detaches = v_leave < geometry->inf.v;
    geometry->f = geometry->inf;
    if (geometry->detaches) {
        geometry->leave = (struct tilt){sqrt(v_leave * (2 - v_leave)), 1 - v_leave, v_leave};
        /* Equation (42; A18) gives sin theta_f. The cosine follows from
         * 1 - sin theta_f = (d - (1/r - L)) (d + (1/r - L)) r / (2 L), where 1/r - L = short_of / r - d. */
        real one_minus_x = (2 * r * d - geometry->short_of) * geometry->short_of / (2 * r * L);
        real x_f =
            2 * one_minus_x < 1 ? 1 - one_minus_x : fmin((1 + r * r * s * (s + 2 * d)) / (2 * r * L), 1);
        geometry->f = tilt_make(x_f, sqrt(one_minus_x * (2 - one_minus_x)));
    }
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
    /* If s and r = 1/s are rounded, r s may exceed 1 by a unit in the last place. */
    if (short_of < -REAL_EPSILON)
        return DOM_OUT_OF_REACH;
    geometry->short_of = fmax(short_of, 0);
    const real q = geometry->q;
    const int whole = (int)q;
    if (q == (real)whole && whole <= 8) { /* r^q - 1 = (r - 1) (1 + r + ... + r^(q-1)) */
        real power = r, sum = 1;
        for (int k = 1; k < whole; k++, power *= r)
            sum += power;
        geometry->rq = power;
        geometry->rq_1 = (r - 1) * sum;
    } else {
        geometry->rq = pow(r, q);
        /* expm1(q ln r) is accurate for r^q near 1, but loses digits for large r^q. */
        geometry->rq_1 = geometry->rq > 2 ? geometry->rq - 1 : expm1(q * log1p(r - 1));
    }
    /* The kinetic energy (24; c6) decreases like r^-(2q+1), and must not underflow. */
    if (!(geometry->rq * geometry->rq * r < REAL_EPSILON / REAL_MIN))
        return DOM_UNDERFLOW;
    geometry->weight = 1 / geometry->rq;
    geometry->inertia = geometry->weight / r;

    geometry->far.order = 0;
    if (geometry->rolls)
        return rounded_set(geometry);
    sharp_set(geometry);
    return DOM_OK;
}

KERNEL_SHARED enum dom_status geometry_tilt(const struct geometry *geometry, real theta, struct tilt *tilt)
{
    /* If theta_c >= 0 and theta is less than c.x = sin theta_c, then theta is also less than theta_c. The
     * comparisons below give the same result with c.x instead of theta_c, and no arc tangent is needed. */
    const real theta_c = theta < geometry->c.x ? geometry->c.x : tilt_angle(geometry->c);
    if (!(theta >= geometry->lean) || theta > theta_c + fabs(theta_c) * 2 * REAL_EPSILON)
        return DOM_BAD_TILT;
    *tilt = theta < theta_c ? tilt_make(sin(theta), cos(theta)) : geometry->c;
    return DOM_OK;
}

KERNEL real geometry_half_u(const struct geometry *geometry)
{
    if (geometry->rounded.roll != 0)
        return tan(geometry_theta_u(geometry) / 2);
    return geometry->h.x / (geometry->h.y + geometry->steepest);
}

KERNEL_SHARED real geometry_theta_u(const struct geometry *geometry)
{
    real level = atan(geometry->h.x / geometry->h.y), part = geometry->rounded.roll / geometry->steepest;
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
    if (geometry->rolls)
        return rounded_leader(geometry, follower);
    /* If the follower's tilt is given, the contact equation (12; b8) is A cos theta + B sin theta = d. The
     * smaller root theta is the leader's tilt. */
    real A = geometry->L - follower.x / geometry->r, B = follower.y / geometry->r;
    real R = hypot(A, B), root = sqrt(fmax((R - geometry->d) * (R + geometry->d), 0));
    real least = geometry->lean < 0 ? sin(geometry->lean) : 0;
    return tilt_make(fmax((B * geometry->d - A * root) / (R * R), least),
                     (A * geometry->d + B * root) / (R * R));
}

KERNEL real geometry_paper_fuel(const struct geometry *geometry)
{
    real s = geometry->s, d = geometry->d, x = geometry->h.x, y = geometry->h.y;
    if (geometry->rolls)
        return rounded_fall(geometry, geometry->f);
    /* h(0) - h(theta_f) = sin theta_f (h.y tan(theta_f / 2) - h.x). */
    if (geometry->detaches)
        return geometry->f.x * (y * geometry->f.x / (1 + geometry->f.y) - x);
    /* This is h(0) - h(theta_inf), in a form that keeps its digits where the fuel is nearly 0. On a level
     * floor the fuel is 0 at s = 2 d^3 / (1 - d^2). */
    return s * fma(s, (y - x) * (y + x), -2 * d * x * x) /
           (geometry->L * (y * s + x * geometry->L * geometry->inf.x));
}

KERNEL real geometry_tipped_omegasq(const struct geometry *geometry)
{
    /* h(theta_u) (6; b2), and the sine and cosine of theta_c - theta_u */
    const real u = geometry->steepest, part = geometry->rounded.roll / u;
    real sine = -geometry_lift(geometry, geometry->c) / u,
         cosine = geometry_height(geometry, geometry->c) / u,
         fall = u * sine * sine / (1 + cosine); /* h(theta_u) - h(theta_c), if the foot does not roll uphill
                                                   or downhill */
    if (part != 0) {
        const real by = tilt_angle(geometry->c) - geometry_theta_u(geometry), half = sin(by / 2);
        sine = sin(by);
        fall = u * (2 * half * half * sqrt((1 - part) * (1 + part)) + part * (sine - by));
    }
    return sine > 0 ? fall / geometry_inertia(geometry, geometry->c) : 0;
}
