/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Trains with friction between the dominoes, in long double: the linear equation of motion of tau^2 omega^2,
 * integrated by collocation at Gauss points. */
#include "plain.h"

#include <math.h>
#include <stdbool.h>

enum { STAGES = 8, STEPS = 12, GRID = 48 };

struct rubbing {
    long double s, d, q, r, mu, L, leave;
};

struct terms {
    long double A, B, C;
};

static struct terms terms_at(const struct rubbing *t, long double theta)
{
    struct terms sum = {0};
    long double w = 1, v = 1, S = 1, by = 1, bend = 0;
    for (int i = 0; i < 4000; i++) {
        const long double x = sinl(theta), y = cosl(theta), X = t->r * (t->L * y - t->d),
                          Y = sqrtl((1 - X) * (1 + X)), phi = theta == 0 ? 1 : 1 - t->r * t->L * x / Y;
        sum.A += v * S * by;
        sum.B += v * S * bend;
        sum.C += w * S * (x - t->d * y) / 2;
        if (!(theta < t->leave) || fabsl(w * S) < 1e-22L)
            break;
        theta += asinl(X);
        bend = phi * bend - t->r * t->L * (cosl(theta) + phi * x * X) / (Y * Y) * by * by;
        by *= phi;
        S *= (Y / t->r - t->L * x - t->mu * t->d) * t->r / (Y + t->mu * X);
        w *= powl(t->r, -t->q);
        v *= powl(t->r, -t->q - 1);
    }
    return sum;
}

/* Solves a x = b, with pivots; two right sides. */
static void solve(long double a[STAGES][STAGES], long double b[STAGES][2])
{
    for (int k = 0; k < STAGES; k++) {
        int top = k;
        for (int i = k + 1; i < STAGES; i++)
            top = fabsl(a[i][k]) > fabsl(a[top][k]) ? i : top;
        for (int j = 0; j < STAGES; j++) {
            const long double t = a[k][j];
            a[k][j] = a[top][j];
            a[top][j] = t;
        }
        for (int j = 0; j < 2; j++) {
            const long double t = b[k][j];
            b[k][j] = b[top][j];
            b[top][j] = t;
        }
        for (int i = 0; i < STAGES; i++) {
            const long double f = i == k ? 0 : a[i][k] / a[k][k];
            for (int j = k; j < STAGES; j++)
                a[i][j] -= f * a[k][j];
            for (int j = 0; j < 2; j++)
                b[i][j] -= f * b[k][j];
        }
    }
    for (int i = 0; i < STAGES; i++)
        for (int j = 0; j < 2; j++)
            b[i][j] /= a[i][i];
}

/* Gauss points in [0, 1], and the integrals of the Lagrange polynomials: whole[j] from 0 to 1, part[i][j]
 * from 0 to point i. */
static long double point[STAGES], whole[STAGES], part[STAGES][STAGES];

static long double legendre(long double x, long double *slope)
{
    long double p0 = 1, p1 = x;
    for (int k = 2; k <= STAGES; k++) {
        const long double p = ((2 * k - 1) * x * p1 - (k - 1) * p0) / k;
        p0 = p1;
        p1 = p;
    }
    *slope = STAGES * (x * p1 - p0) / (x * x - 1);
    return p1;
}

static void find_rule(void)
{
    if (whole[0] > 0)
        return;
    long double slope;
    for (int i = 0; i < STAGES; i++) {
        long double x = -cosl(3.14159265358979L * (i + 0.75L) / (STAGES + 0.5L));
        for (int k = 0; k < 20; k++)
            x -= legendre(x, &slope) / slope;
        legendre(x, &slope);
        point[i] = (1 + x) / 2;
        whole[i] = 1 / ((1 - x * x) * slope * slope);
    }
    /* part[i][j] is the integral of the polynomial of degree 7 that is 1 at point j: Gauss's rule is exact */
    for (int i = 0; i < STAGES; i++)
        for (int j = 0; j < STAGES; j++) {
            part[i][j] = 0;
            for (int k = 0; k < STAGES; k++) {
                long double l = 1;
                for (int m = 0; m < STAGES; m++)
                    l *= m == j ? 1 : (point[i] * point[k] - point[m]) / (point[j] - point[m]);
                part[i][j] += point[i] * whole[k] * l;
            }
        }
}

/* Continues w = at[0] + at[1] w(0) from one tilt to another: (A/2) w' + B w = C. */
static void integrate(const struct rubbing *t, long double from, long double to, long double at[2])
{
    const long double h = (to - from) / STEPS;
    for (int n = 0; n < STEPS && h > 0; n++) {
        long double m[STAGES][STAGES], f[STAGES][2], a[STAGES];
        for (int i = 0; i < STAGES; i++) {
            const struct terms s = terms_at(t, from + h * (n + point[i]));
            a[i] = -2 * s.B / s.A;
            f[i][0] = a[i] * at[0] + 2 * s.C / s.A;
            f[i][1] = a[i] * at[1];
            for (int j = 0; j < STAGES; j++)
                m[i][j] = (i == j) - h * a[i] * part[i][j];
        }
        solve(m, f);
        for (int i = 0; i < STAGES; i++)
            for (int j = 0; j < 2; j++)
                at[j] += h * whole[i] * f[i][j];
    }
}

static long double detached_at(const struct rubbing *t, long double end)
{
    long double theta = 0, lo = 0, hi = end;
    int links = 0;
    if (isinf(t->leave))
        return end;
    for (; theta < t->leave && links < 4000; links++)
        theta += asinl(t->r * (t->L * cosl(theta) - t->d));
    /* domino links - 1 passes theta_leave during the cycle */
    for (int k = 0; k < 100; k++) {
        const long double middle = (lo + hi) / 2;
        theta = middle;
        for (int i = 0; i < links - 1 && theta < t->leave; i++)
            theta += asinl(t->r * (t->L * cosl(theta) - t->d));
        *(theta < t->leave ? &lo : &hi) = middle;
    }
    return lo;
}

long double plain_share_rubbing(long double s, long double d, long double q, long double mu, long double r)
{
    struct rubbing t = {.s = s, .d = d, .q = q, .r = r, .mu = mu, .L = s + d, .leave = INFINITY};
    const long double LL = t.L * t.L, end = asinl(r * s);
    find_rule();
    if (1 / (r * r) < LL - d * d)
        t.leave = acosl(fminl((LL + d * d - 1 / (r * r)) / (2 * d * t.L), 1));
    const long double jump = detached_at(&t, end), J0 = terms_at(&t, 0).A;
    long double at[2] = {0, 1}, need = 0, done = 0;
    for (int k = 1; k <= 2 * GRID; k++) {
        const bool late = k > GRID;
        const long double from = late ? jump : 0, to = late ? end : jump, width = (to - from) / GRID;
        long double lo = from + width * (k - 1 - (late ? GRID : 0)), hi = lo + width;
        if (!(width > 1e-15L))
            continue;
        const long double top = hi;
        if (terms_at(&t, lo + width * 1e-12L).C < 0 && terms_at(&t, hi - width * 1e-12L).C >= 0) {
            for (int i = 0; i < 70; i++) {
                const long double middle = (lo + hi) / 2;
                *(terms_at(&t, middle).C < 0 ? &lo : &hi) = middle;
            }
            integrate(&t, done, hi, at);
            done = hi;
            need = fmaxl(need, -at[0] / at[1]);
        }
        if (k == GRID || k == 2 * GRID) {
            integrate(&t, done, top, at);
            done = top;
            need = fmaxl(need, -at[0] / at[1]);
        }
    }
    const long double kappa = r * (J0 - 1) / J0 * (J0 - 1) / J0, w = kappa * at[0] / (1 - kappa * at[1]);
    return w > 0 ? 1 - need / w : -1;
}
