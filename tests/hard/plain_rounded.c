/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Trains with rounded edges, from the equation of the contact of two round edges, in long double. */
#include "plain.h"

#include <math.h>
#include <stdbool.h>

enum { LINKS = 4000, GRID = 48 };

struct rounded {
    long double s, d, q, r, rho, L, l, leave, h_end;
    int n;
    long double h0[LINKS];
};

static long double h_of(const struct rounded *t, long double theta)
{
    return 2 * t->rho + t->l * cosl(theta) + (t->d - 2 * t->rho) * sinl(theta);
}

/* The inertia about the line of contact, divided by that of the sharp block about its edge. */
static long double inertia(const struct rounded *t, long double theta)
{
    const long double d = t->d, rho = t->rho, u = 0.5L - rho, v = d / 2 - rho;
    return ((1 + d * d) / 12 + u * u + v * v + rho * rho + 2 * rho * (u * cosl(theta) + v * sinl(theta))) /
           ((1 + d * d) / 3);
}

/* Returns the tilt of the follower, by Newton's method, and the slope. */
static long double lean(const struct rounded *t, long double theta, long double *slope)
{
    const long double x = sinl(theta), y = cosl(theta), r = t->r, rho = t->rho, l = t->l;
    long double next = theta + asinl(fminl(r * (t->L * y - t->d), 0.999L)), by_next = 1, by_theta = -1;
    for (int i = 0; i < 60; i++) {
        const long double a = -t->L + rho * (1 - 1 / r) + rho * next / r - rho * theta + l / r * sinl(next),
                          b = rho / r - rho + l / r * cosl(next), f = a * y - b * x + (t->d - rho) + rho / r;
        by_next = (rho / r + l / r * cosl(next)) * y + l / r * sinl(next) * x;
        by_theta = -rho * y - a * x - b * y;
        const long double step = f / by_next;
        next -= step;
        if (fabsl(step) < 1e-9L && i > 1 && fabsl(step) <= 4e-19L * next)
            break;
    }
    *slope = theta == 0 ? 1 : -by_theta / by_next;
    return next;
}

/* Finds the tilt at which a follower leaves. A follower never leaves if the slope is positive up to the tilt
 * at which leader and follower are parallel. */
static void find_leave(struct rounded *t)
{
    long double lo = 0, hi = 0, slope;
    t->leave = INFINITY;
    for (int k = 1; k <= 400 && isinf(t->leave); k++) {
        hi = 1.57L * k / 400;
        const long double next = lean(t, hi, &slope);
        if (slope > 0 && next <= hi)
            break;
        if (slope <= 0)
            t->leave = hi;
        else
            lo = hi;
    }
    if (isinf(t->leave)) {
        for (int i = 0; i < 100; i++) {
            const long double middle = (lo + hi) / 2;
            *(lean(t, middle, &slope) > middle ? &lo : &hi) = middle;
        }
        t->h_end = h_of(t, lo);
        return;
    }
    for (int i = 0; i < 100; i++) {
        const long double middle = (lo + hi) / 2;
        lean(t, middle, &slope);
        *(slope > 0 ? &lo : &hi) = middle;
    }
    t->leave = lo;
    t->h_end = h_of(t, lean(t, lo, &slope));
}

static long double change(const struct rounded *t, long double theta)
{
    long double sum = 0, w = 1, slope;
    for (int i = 0; i < t->n; i++, w *= powl(t->r, -t->q)) {
        const bool stays = theta < t->leave;
        sum += w * (h_of(t, theta) - t->h0[i]);
        if (!stays) {
            for (i++, w *= powl(t->r, -t->q); i < t->n; i++, w *= powl(t->r, -t->q))
                sum += w * (t->h_end - t->h0[i]);
            break;
        }
        theta = lean(t, theta, &slope);
    }
    return sum;
}

static long double slope_at(const struct rounded *t, long double theta)
{
    long double sum = 0, w = 1, slope, by = 1;
    for (int i = 0; i < t->n; i++, w *= powl(t->r, -t->q)) {
        sum += w * by * ((t->d - 2 * t->rho) * cosl(theta) - t->l * sinl(theta));
        if (!(theta < t->leave))
            break;
        theta = lean(t, theta, &slope);
        by *= slope;
    }
    return sum;
}

long double plain_share_rounded(long double s, long double d, long double q, long double rho, long double r)
{
    static struct rounded t; /* large */
    t.s = s;
    t.d = d;
    t.q = q;
    t.r = r;
    t.rho = rho;
    t.L = s + d;
    t.l = 1 - 2 * rho;
    long double theta = 0, P = 0, T = 0, w = 1, v = 1, by = 1, slope, contact = asinl(fminl(r * s, 0.999L));
    const long double less = powl(r, -q);
    find_leave(&t);
    for (t.n = 0; t.n < LINKS;) {
        const long double h = h_of(&t, theta);
        t.h0[t.n++] = h;
        if (!(theta < t.leave) || w * by < 1e-22L) {
            P += w * (h - t.h_end);
            break;
        }
        theta = lean(&t, theta, &slope);
        by *= slope;
        P += w * (h - h_of(&t, theta));
        w *= less;
        v *= less / r;
        T += v * inertia(&t, theta) * by * by;
    }
    const long double K = P * T / ((inertia(&t, 0) + T) / less - T);
    for (int i = 0; i < 60; i++)
        contact -= (rho * contact + t.l * sinl(contact) - r * s) / (rho + t.l * cosl(contact));
    const long double end = fminl(contact, atanl((d - 2 * rho) / t.l));
    long double most = fmaxl(change(&t, end), 0);
    for (int k = 1; k <= GRID; k++) {
        long double lo = end * (k - 1) / GRID, hi = end * k / GRID;
        if (!(slope_at(&t, lo) > 0 && slope_at(&t, hi) <= 0))
            continue;
        for (int i = 0; i < 40; i++) {
            const long double middle = (lo + hi) / 2;
            *(slope_at(&t, middle) > 0 ? &lo : &hi) = middle;
        }
        most = fmaxl(most, change(&t, hi));
    }
    return K > 0 ? 1 - most / K : -1;
}
