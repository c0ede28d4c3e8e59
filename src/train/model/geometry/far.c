/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The sums over the far tail. Let theta be the tilt of the first domino of the tail, and z = tan((theta_inf -
 * theta) / 2). Then H and J of the tail are power series in z. The variable z of the follower is f(z), which
 * is another power series. So
 *
 *     H(z) = h(z) + r^(-q) H(f(z)),
 *     J(z) / (1 + z^2)^2 = (1 + z^2)^(-2) + r^(-(q+1)) f'(z)^2 J(f(z)) / (1 + f^2)^2.
 *
 * From these equations, each coefficient of H and J follows from the coefficients before it.
 */
#include "geometry/chain.h"

/* Finds the series f = (z - p) / (1 + z p) of the follower, where p = tan((theta_1 - theta) / 2). Returns 1 -
 * f'(0), which is small if s is small. Callers must not compute it as 1 - f[1], because digits would
 * cancel. */
static real far_follower(const struct geometry *geometry, int order, real *f)
{
    /* p = tan(asin(X) / 2) = X / (1 + Y), where X = 2 r L z (sin theta_inf - z cos theta_inf) / (1 + z^2). */
    real X[FAR_ORDER + 2], Y[FAR_ORDER + 2], p[FAR_ORDER + 2];
    const real rL = geometry->rL;
    f[0] = 0;
    for (int k = 1; k <= order; k++) {
        X[k] = k == 1 ? 2 * rL * geometry->inf.x : k == 2 ? -2 * rL * geometry->inf.y : -X[k - 2];
        real square = 0, half = X[k]; /* p follows from Y^2 = 1 - X^2 and p (1 + Y) = X */
        for (int j = 1; j < k; j++) {
            square += X[j] * X[k - j] + Y[j] * Y[k - j];
            half -= p[j] * Y[k - j];
        }
        Y[k] = -square / 2;
        p[k] = half / 2;
        f[k] = k == 1 ? 1 - p[k] : -p[k];
        for (int j = 1; j + 1 < k; j++)
            f[k] -= f[j] * p[k - 1 - j];
    }
    return p[1];
}

/* Returns a radius inside which the series converge. Inside this radius, f has no branch points, which lie
 * where X is 1 or -1. The second fixed point of f, which belongs to theta = -theta_inf, is not inside the
 * radius either. */
static real far_radius(const struct geometry *geometry)
{
    real o = geometry->rL * geometry->inf.x, rd = geometry->r * geometry->d, least = sqrt(1 / (1 + 2 * rd));
    real root = o * o - (1 - 2 * rd); /* the equation X = -1 is (1 - 2 r d) z^2 + 2 o z + 1 = 0 */
    least = fmin(least, root > 0 ? 1 / (o + sqrt(root)) : 1 / sqrt(1 - 2 * rd));
    return fmin(least, geometry->inf.x / geometry->inf.y);
}

/* Returns the order of the series that saves the most time in `passes` passes, or 0. Without series, a pass
 * visits n dominoes. With series of the order k, it visits about 2 n / (k + 2). Building the series takes as
 * long as k^3 / 100 dominoes; that was measured. */
static int far_order(const struct geometry *geometry, int passes)
{
    const real n = log(geometry->tol / 8) / log(fmax(geometry->decay, REAL_EPSILON));
    const int order = 2 * (int)((real)1.45 * sqrt(sqrt(n * (real)passes)) - (real)0.5);
    return order < FAR_FIRST ? 0 : order > FAR_ORDER ? FAR_ORDER : order;
}

/* Multiplies the series p by the series f, up to the index `last`. p begins at p[first], and f at f[1]. */
static void far_multiply(real *p, const real *f, int first, int last)
{
    for (int k = last; k > first; k--) {
        real next = 0;
        for (int i = first; i < k; i++)
            next += p[i] * f[k - i];
        p[k] = next;
    }
    p[first] = 0;
}

/* Returns 1 - cos theta at the tilt from which on the series are probably accurate enough, if the omitted
 * terms at a smaller tilt are too large by the factor `excess`. `half` is tan(theta / 2) at that tilt, and z
 * is tan((theta_inf - theta) / 2). Near the upright position, a difference of two tilts would have no digits.
 * The result is positive. If z shrinks to nearly 0 at once, `power` is NaN, and the next domino is tried. */
static real far_from(const struct far *far, real half, real z, real excess)
{
    const real more = fmax(fmax(-z * expm1(-far->power * log(excess)), z - far->radius / 2), 0),
               by = more / (1 + z * (z - more)), then = (half + by) / (1 - half * by);
    return fmax(2 * then * then / (1 + then * then), REAL_MIN);
}

/* Returns (z / radius)^order. Multiplied by rest_H or rest_J, it bounds the omitted terms of dH/dz or of J.
 */
static real far_share(const struct far *far, real z)
{
    const real square = (z / far->radius) * (z / far->radius);
    real share = 8; /* for safety */
    for (int k = far->order; k > 1; k -= 2)
        share *= square;
    return share;
}

KERNEL void far_make(struct geometry *geometry, int passes)
{
    struct far *far = &geometry->far;
    far->order = 0;
    if (geometry->rolls || geometry->detaches || geometry->inf.y <= 0 || geometry->n != CHAIN_ENDLESS ||
        !geometry->conservative)
        return;
    const int n = far->order = far_order(geometry, passes);
    if (n == 0)
        return;
    real f[FAR_ORDER + 2], df[FAR_ORDER + 2], power[FAR_ORDER + 2], squares[FAR_ORDER + 2];
    real *const H = far->H, *const J = far->J;
    const real w = geometry->weight, m = geometry->inertia, off = far_follower(geometry, n + 1, f),
               slope = 1 - off;
    /* The first domino of the tail has the energy h = a cos u + b sin u with u = 2 atan z, which is a + 2 b z
     * - 2 a z^2 - ..., and the inertia (1 + z^2)^(-2) = 1 - 2 z^2 + 3 z^4 - ... */
    H[1] = -2 * geometry_lift(geometry, geometry->inf);
    H[2] = -2 * geometry_height(geometry, geometry->inf);
    for (int k = 0; k <= n; k++) {
        if (k > 2)
            H[k] = -H[k - 2];
        J[k] = k % 2 ? 0 : (real)(k % 4 ? -k / 2 - 1 : k / 2 + 1);
        power[k] = f[k];
        df[k] = (real)(k + 1) * f[k + 1];
    }
    for (int k = 0; k <= n; k++) {
        real square = 0;
        for (int i = 0; i <= k; i++)
            square += df[i] * df[k - i];
        squares[k] = square;
    }
    /* At step j, `power` is the series f^j, and `squares` is the series f'^2 f^(j-1). H[j] and J[j - 1]
     * already contain all terms that come from earlier coefficients. */
    real slopes = 1, lost = 0; /* slope^j, and 1 - slope^j */
    for (int j = 1; j <= n + 1; j++) {
        lost += slopes * off;
        slopes *= slope;
        /* The equation for J[j - 1] is J[j - 1] = (terms so far) + m slope^(j+1) J[j - 1]. */
        J[j - 1] /= 1 - m * slope * slopes;
        const real J_m = m * J[j - 1];
        for (int k = j; k <= n; k++)
            J[k] += J_m * squares[k];
        if (j > n)
            break;
        far_multiply(squares, f, j - 1, n);
        H[j] /= w * (geometry->rq_1 + lost); /* 1 - r^-q slope^j */
        const real H_w = w * H[j];
        for (int k = j + 1; k <= n; k++)
            H[k] += H_w * power[k];
        far_multiply(power, f, j, n);
    }
    far->radius = far_radius(geometry);
    far->rest_H = 0;
    far->rest_J = 1; /* J[0] is at least 1 */
    real scale = 1;
    for (int k = 1; k <= n; k++) {
        far->rest_H = fmax(far->rest_H, fabs(H[k]) * scale);
        scale *= far->radius;
        far->rest_J = fmax(far->rest_J, fabs(J[k]) * scale);
    }
    /* from one domino to the next, z shrinks by the factor `slope`, and the omitted terms by slope^n decay */
    far->power = log(slope) / ((real)n * log(slope) + log(geometry->decay));
    const real first = half_of_tilt(geometry->inf);
    far->from = far_from(far, 0, first, far_share(far, first) / (TAIL_SHARE * geometry->tol));
}

/* Returns by which factor the bound `rest` on the omitted terms of a series is too large. It is compared with
 * the sum that includes the value `tail` of the series, because `tail` may cancel most of the sum. */
static real far_excess(const struct series *s, real tail, real rest, real tol)
{
    return fabs(rest) / (TAIL_SHARE * fmax(tol * fabs(s->sum + tail), ROUNDOFF * (s->size + fabs(tail))));
}

KERNEL real far_find(struct link a, struct tilt b, real t, struct sum_state sum, struct sums *tail)
{
    const struct geometry *geometry = a.geometry;
    const struct far *far = &geometry->far;
    const real z_a = tan_half_between(a.tilt, geometry->inf), z_b = tan_half_between(b, geometry->inf),
               z = fmax(fabs(z_a), fabs(z_b)), one = 1 + z_a * z_a, slope = a.slope, tol = geometry->tol,
               inertia = a.inertia * slope * slope;
    real difference = 0, part = 1, power = 1; /* `part` is (z_a^k - z_b^k) / (z_a - z_b) */
    for (int k = 1; k <= far->order; k++) {
        difference += far->H[k] * part;
        power *= z_b;
        part = part * z_a + power;
    }
    real H = 0, first = 0, second = 0, J = 0; /* `second` is half of the second derivative */
    for (int k = far->order; k >= 0; k--) {
        second = second * z_a + first;
        first = first * z_a + H;
        H = H * z_a + far->H[k];
        J = J * z_a + far->J[k];
    }
    *tail = (struct sums){.J = inertia * one * one * J,
                          .H1 = -a.weight * slope * first * one / 2,
                          .H2 = a.weight * one / 2 *
                                (slope * slope * (one * second + z_a * first) - a.second_derivative * first),
                          .dH = -a.weight * t * (1 + z_a * z_b) * difference};
    const real share = far_share(far, z), rest_H = a.weight * far->rest_H * share;
    real excess = fmax(far_excess(&sum.dH, tail->dH, rest_H * t, tol),
                       far_excess(&sum.J, tail->J, inertia * far->rest_J * share, tol));
    if (sum.H1.size > 0) /* H1 is needed */
        excess = fmax(excess, far_excess(&sum.H1, tail->H1, rest_H * slope / 2, tol));
    return excess > 1 ? far_from(far, fmin(half_of_tilt(a.tilt), half_of_tilt(b)), z, 2 * excess) : 0;
}
