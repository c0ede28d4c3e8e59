/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "reference.h"

#include <stdlib.h>

struct sketch sketch_of(const struct ref *ref)
{
    const long double r = mpfr_get_ld(ref->in[REF_R], MPFR_RNDN);
    struct sketch k = {.s = mpfr_get_ld(ref->in[REF_S], MPFR_RNDN),
                       .d = mpfr_get_ld(ref->in[REF_D], MPFR_RNDN),
                       .r = r,
                       .rq = powl(r, -mpfr_get_ld(ref->in[REF_Q], MPFR_RNDN)),
                       .dominoes = ref->dominoes};
    k.L = k.s + k.d;
    k.theta_c = asinl(fminl(1, r * k.s));
    long double room = k.s * (k.s + 2 * k.d), rr = 1 / (r * r);
    k.detaches = rr < room;
    k.theta_f = k.detaches ? asinl(fminl(1, (rr + room) * r / (2 * k.L))) : acosl(k.d / k.L);
    /* Long double has too few bits for the 1 - r s of a train in quad precision. */
    k.theta_leave = k.detaches ? mpfr_get_ld(ref->theta_leave, MPFR_RNDN) : 4;
    if (isnan(k.theta_leave)) /* the reference has no theta_leave: rounding decides about detaching */
        k.theta_leave = k.theta_c;
    k.cut = 1e-13L * (k.detaches ? 1 : 1 - k.rq * (1 - r * sqrtl(room)));
    return k;
}

/* Replaces a domino at the tilt *theta by its follower. Returns false if there is none. */
static bool follow(const struct sketch *k, long double *theta, long double *slope)
{
    if (k->detaches && *theta >= k->theta_leave)
        return false;
    long double X = fminl(1, k->r * (k->L * cosl(*theta) - k->d));
    if (X >= 1)
        return false;
    *slope *= 1 - k->r * k->L * sinl(*theta) / sqrtl((1 - X) * (1 + X));
    *theta += asinl(X);
    return true;
}

long double sketch_slope(const struct sketch *k, long double tilt)
{
    long double theta = tilt, slope = 1, w = 1, sum = 0;
    for (size_t i = 0; i < k->dominoes; i++) {
        sum += w * slope * (k->d * cosl(theta) - sinl(theta));
        w *= k->rq;
        if (!follow(k, &theta, &slope) || w * slope < k->cut)
            break;
    }
    return sum;
}

/* Returns h(at) - h(from) without cancellation, which would hide the barrier of a thin domino. */
static long double energy_gain(const struct sketch *k, long double at, long double from)
{
    long double half = (at - from) / 2, middle = (at + from) / 2;
    return 2 * sinl(half) * (k->d * cosl(middle) - sinl(middle));
}

long double sketch_energy_change(const struct sketch *k, long double tilt)
{
    long double at = tilt, from = 0, slope = 1, ignored = 1, w = 1, sum = 0;
    bool up = true, down = true;
    for (size_t i = 0; i < k->dominoes && (up || down) && w * slope > k->cut; i++) {
        sum += w * energy_gain(k, at, from);
        w *= k->rq;
        if (up && !(up = follow(k, &at, &ignored)))
            at = k->theta_f;
        if (down && !(down = follow(k, &from, &slope)))
            from = k->theta_f;
    }
    return sum;
}

static int ascending(const void *a, const void *b)
{
    long double x = *(const long double *)a, y = *(const long double *)b;
    return (x > y) - (x < y);
}

long double sketch_leaving(const struct sketch *k)
{
    if (!k->detaches)
        return k->theta_c;
    long double lo = 0, hi = k->theta_c;
    size_t leader = 0;
    for (long double theta = k->theta_c, slope = 1; theta < k->theta_leave && leader < 1000; leader++)
        if (!follow(k, &theta, &slope))
            break;
    for (int j = 0; j < 80; j++) {
        long double tilt = (lo + hi) / 2, theta = tilt, slope = 1;
        for (size_t i = 0; i < leader; i++)
            if (!follow(k, &theta, &slope))
                theta = k->theta_leave;
        *(theta < k->theta_leave ? &lo : &hi) = tilt;
    }
    return hi;
}

int sketch_nodes(const struct sketch *k, long double node[SKETCH_NODES])
{
    const long double c = k->theta_c, leave = sketch_leaving(k);
    int n = 0;
    node[n++] = 0;
    for (int j = 1; j <= 60; j++)
        node[n++] = c * powl(10, -(long double)j / 4);
    for (int j = 1; j <= 64; j++)
        node[n++] = c * j / 64;
    for (int j = 1; j <= 30; j++) {
        node[n++] = leave + (c - leave) * powl(10, -(long double)j / 3);
        node[n++] = leave - leave * powl(10, -(long double)j / 3);
    }
    node[n++] = leave;
    qsort(node, (size_t)n, sizeof *node, ascending);
    return n;
}
