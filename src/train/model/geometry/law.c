/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reads a train, and sets what its passes need for one separation and growth. The laws of contact are in
 * sharp.c and rounded.c. */
#include "geometry/law.h"

/* Finds r^q, and r^q - 1 without cancellation. */
static void geometry_powers(real r, real q, real *rq, real *rq_1)
{
    const int whole = (int)q;
    if (q == (real)whole && whole <= 8) { /* r^q - 1 = (r - 1) (1 + r + ... + r^(q-1)) */
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
    /* expm1(q ln r) is accurate for r^q near 1, but loses digits for large r^q. */
    *rq_1 = *rq > 2 ? *rq - 1 : expm1(q * log1p(r - 1));
}

KERNEL struct geometry geometry_read(const struct request *t)
{
    struct geometry geometry = {.s = (real)t->s,
                                .r = (real)t->r,
                                .d = (real)t->d,
                                .q = (real)t->q,
                                .width = (real)t->width,
                                .tol = (real)t->tol,
                                .inertia_factor = 1,
                                .n = CHAIN_ENDLESS,
                                .interrupt = t->interrupt,
                                .work = t->work};
    geometry.steepest = sqrt(1 + geometry.d * geometry.d);
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
    geometry->upright_inertia = geometry->span = 1;
    geometry->law = &sharp_edges;
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
    /* If s and r = 1/s are rounded, r s may exceed 1 by a unit in the last place. */
    if (short_of < -REAL_EPSILON)
        return DOM_OUT_OF_REACH;
    geometry->short_of = fmax(short_of, 0);
    geometry_powers(r, geometry->q, &geometry->rq, &geometry->rq_1);
    /* The kinetic energy (24; c6) decreases like r^-(2q+1), and must not underflow. */
    if (!(geometry->rq * geometry->rq * r < REAL_EPSILON / REAL_MIN))
        return DOM_UNDERFLOW;
    geometry->weight = 1 / geometry->rq;
    geometry->inertia = geometry->weight / r;

    geometry->far.order = 0;
    return geometry->law->set(geometry);
}
