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

/* Returns a factor for a bound: the omitted terms of a series are at most this factor multiplied by (z /
 * radius)^order. The factor is estimated from the last coefficients. */
static real far_rest(const struct far *far, const real *series)
{
    real most = 0, power = 1;
    for (int k = 1; k <= far->order; k++) {
        power *= far->radius;
        if (k + 3 > far->order)
            most = fmax(most, fabs(series[k]) * power);
    }
    return 16 * most;
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

/* Building a series takes FAR_COST + order^3 / FAR_CUBE times as long as handling one domino in a pass. Both
 * constants were measured. */
#define FAR_COST 2
#define FAR_CUBE 100

/* Returns the order of the series that saves the most time, or 0 if no series saves time. `passes` is the
 * number of passes that use the series. The cost of building the series is divided among these passes. */
static int far_order(const struct geometry *geometry, real passes)
{
    real slope = geometry->decay * geometry->rq, fades = log(geometry->rq),
         closer = slope > REAL_EPSILON ? -log(slope) : 64, digits = -log(geometry->tol / 8);
    real least = digits / (fades + closer);
    int best = 0;
    for (int order = FAR_FIRST; order <= FAR_ORDER && FAR_COST < least * passes; order += 2) {
        real cube = (real)(order * order * order),
             cost = digits / (fades + (real)(order + 1) * closer) + (FAR_COST + cube / FAR_CUBE) / passes;
        if (cost < least) {
            best = order;
            least = cost;
        }
    }
    return best;
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

/* Finds the contributions of the first domino of the tail to H and J. */
static void far_own(const struct geometry *geometry, int n, real *H, real *J)
{
    /* h is a cos u + b sin u with u = 2 atan z, that is a + 2 b z - 2 a z^2 + ..., and (1 + z^2)^(-2) is
     * 1 - 2 z^2 + 3 z^4 - ... */
    const real height = geometry_height(geometry, geometry->inf);
    H[0] = 0;
    for (int k = 0; k <= n; k++) {
        if (k > 0)
            H[k] = k == 1   ? -2 * geometry_height_slope(geometry, geometry->inf)
                   : k == 2 ? -2 * height
                            : -H[k - 2];
        J[k] = k % 2 ? 0 : (real)(k % 4 ? -k / 2 - 1 : k / 2 + 1);
    }
}

KERNEL void far_make(struct geometry *geometry, real passes)
{
    struct far *far = &geometry->far;
    far->order = 0;
    if (geometry->rolls || geometry->detaches || geometry->inf.y <= 0)
        return;
    const int n = far->order = far_order(geometry, passes);
    if (n == 0)
        return;
    real f[FAR_ORDER + 2], df[FAR_ORDER + 2], power[FAR_ORDER + 2], squares[FAR_ORDER + 2];
    real *const H = far->H, *const J = far->J;
    const real w = geometry->weight, m = geometry->inertia, off = far_follower(geometry, n + 1, f),
               slope = 1 - off;
    far->radius = far_radius(geometry);
    far_own(geometry, n, H, J);
    for (int k = 0; k <= n; k++) {
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
    far->rest_H = far_rest(far, H) * (real)(n + 1) / far->radius;
    far->rest_J = far_rest(far, J);
}
