/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The far tail: H and J of a train as power series in z = tan((theta_inf - theta) / 2). A domino at z has its
 * follower at f(z), which is a power series, too, and
 *
 *     H(z) = h(z) + r^-q H(f(z)),   J(z) / (1 + z^2)^2 = (1 + z^2)^-2 + r^-(q+1) f'(z)^2 J(f(z)) / (1 +
 * f^2)^2.
 *
 * Each coefficient follows from those before it.
 */
#include "geometry/far.h"

/* Finds f = (z - p) / (1 + z p), where p = tan(asin(X) / 2) = X / (1 + Y) and
 * X = 2 r L z (sin theta_inf - z cos theta_inf) / (1 + z^2). */
static void far_follower(const struct geometry *geometry, int order, real *f)
{
    real X[FAR_ORDER + 2] = {0}, Y[FAR_ORDER + 2] = {1}, p[FAR_ORDER + 2] = {0}, rL = geometry->rL;
    for (int k = 1; k <= order; k++) {
        X[k] = k == 1 ? 2 * rL * geometry->inf.x : k == 2 ? -2 * rL * geometry->inf.y : -X[k - 2];
        real square = 0, half = X[k]; /* Y^2 = 1 - X^2, p (1 + Y) = X */
        for (int j = 1; j < k; j++) {
            square += X[j] * X[k - j] + Y[j] * Y[k - j];
            half -= p[j] * Y[k - j];
        }
        Y[k] = -square / 2;
        p[k] = half / 2;
    }
    f[0] = 0;
    for (int k = 1; k <= order; k++) {
        f[k] = k == 1 ? 1 - p[k] : -p[k];
        for (int j = 1; j + 1 < k; j++)
            f[k] -= f[j] * p[k - 1 - j];
    }
}

/* Returns an upper bound of the terms that are left out over (z / radius)^order, by the last coefficients. */
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

/*
 * Returns a radius inside which the series converge: X = 1 and X = -1 are branch points of f, and theta =
 * -theta_inf is a fixed point as well.
 */
static real far_radius(const struct geometry *geometry)
{
    real o = geometry->rL * geometry->inf.x, rd = geometry->r * geometry->d, least = sqrt(1 / (1 + 2 * rd));
    real root = o * o - (1 - 2 * rd); /* (1 - 2 r d) z^2 + 2 o z + 1 = 0 */
    least = fmin(least, root > 0 ? 1 / (o + sqrt(root)) : 1 / sqrt(1 - 2 * rd));
    return fmin(least, geometry->inf.x / geometry->inf.y);
}

/* The cost of a series over that of a domino in a pass, FAR_COST + order^3 / FAR_CUBE, as measured. */
#define FAR_COST 2
#define FAR_CUBE 100

/* Returns the order that costs least for a train with this geometry in `passes` passes; 0: none pays. */
static int far_order(const struct geometry *geometry, real passes)
{
    real slope = 1 - geometry->rL * geometry->inf.x, fades = log(geometry->rq),
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

KERNEL void far_make(struct geometry *geometry, real passes)
{
    struct far *far = &geometry->far;
    far->order = 0;
    if (geometry->detaches || geometry->rounded.on || geometry->inf.y <= 0)
        return;
    const int n = far->order = far_order(geometry, passes);
    if (n == 0)
        return;
    const real w = geometry->weight, m = geometry->inertia, off = geometry->rL * geometry->inf.x,
               slope = 1 - off;
    real f[FAR_ORDER + 2], power[FAR_ORDER + 2] = {0}, H[FAR_ORDER + 2] = {0}, J[FAR_ORDER + 2] = {0},
                                             df[FAR_ORDER + 2], dpower[FAR_ORDER + 2];
    far_follower(geometry, n + 1, f);
    far->radius = far_radius(geometry);
    /* h = a cos + b sin of 2 atan z; its first coefficients are 2 b and -2 a. */
    for (int k = 1; k <= n; k++)
        H[k] = k == 1   ? -2 * geometry_height_slope(geometry, geometry->inf)
               : k == 2 ? -2 * geometry_height(geometry, geometry->inf)
                        : -H[k - 2];
    for (int k = 0, size = 1, sign = 1; k <= n; k += 2, size++, sign = -sign)
        J[k] = (real)(sign * size);
    for (int k = 1; k <= n + 1; k++) {
        power[k] = f[k];
        df[k - 1] = (real)k * f[k];
    }
    /* power holds f^j: when its turn comes, coefficient j of H, and j - 1 of J, lacks only its own term. */
    real slopes = 1, lost = 0; /* slope^j, and 1 - slope^j */
    for (int j = 1; j <= n + 1; j++) {
        lost += slopes * off;
        slopes *= slope;
        if (j <= n) {
            H[j] /= w * (geometry->rq_1 + lost); /* 1 - r^-q slope^j */
            for (int k = j + 1; k <= n; k++)
                H[k] += w * H[j] * power[k];
        }
        /* f'^2 f^(j-1) = f' (f^j)' / j */
        J[j - 1] /= 1 - m * slope * slopes;
        const real by = m * J[j - 1] / (real)j;
        for (int i = j; i <= n + 1; i++)
            dpower[i - 1] = by * (real)i * power[i];
        for (int k = j; k <= n; k++)
            for (int i = j - 1; i <= k; i++)
                J[k] += dpower[i] * df[k - i];
        for (int k = n + 1; k > j; k--) {
            real next = 0;
            for (int i = j; i < k; i++)
                next += power[i] * f[k - i];
            power[k] = next;
        }
        power[j] = 0;
    }
    for (int k = 0; k <= n; k++) {
        far->H[k] = H[k];
        far->J[k] = J[k];
    }
    far->rest_H = far_rest(far, H) * (real)(n + 1) / far->radius;
    far->rest_J = far_rest(far, J);
}
