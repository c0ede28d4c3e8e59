/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Power series for the far tail of a chain, whose tilts are nearly theta_inf. */
#ifndef DOM_FAR_H
#define DOM_FAR_H

#include "geometry/chain.h"

/* Builds the series geometry->far. Its order is chosen to save the most time if `passes` passes use the
 * series. If edges are rounded, if a domino detaches, if theta_inf is pi/2, or if no series saves time, the
 * order is 0: there is no series. */
KERNEL void far_make(struct geometry *geometry, real passes);

/* Returns the variable of the series, tan((theta_inf - theta) / 2). */
KERNEL_LOOP real far_variable(const struct geometry *geometry, struct tilt t)
{
    real sine = geometry->inf.x * t.y - geometry->inf.y * t.x,
         cosine = geometry->inf.y * t.y + geometry->inf.x * t.x;
    return sine / (1 + cosine);
}

/*
 * Returns (z / radius)^order, from which bounds on the omitted terms follow. Multiplied by rest_H, this power
 * bounds the omitted terms of dH/dz. Multiplied by rest_J, it bounds the omitted terms of J. If z is too
 * large for the series, the result is infinity.
 */
KERNEL_LOOP real far_share(const struct far *far, real z)
{
    real part = fabs(z) / far->radius, square = part * part, share = 1;
    if (part > (real)0.5)
        return (real)INFINITY;
    for (int k = far->order; k > 1; k -= 2)
        share *= square;
    return share;
}

/*
 * Returns true if the omitted terms of a far series do not matter. `tail` is the value of the series, to be
 * added to the sum s, and `rest` is a bound on the omitted terms. `rest` is compared with the sum that
 * includes `tail`, because `tail` may cancel most of s.
 */
KERNEL_LOOP bool far_done(const struct series *s, real tail, real rest, real tol)
{
    return fabs(rest) <= TAIL_SHARE * fmax(tol * fabs(s->sum + tail), ROUNDOFF * s->size);
}

/* Returns H(theta_a) - H(theta_b) for a domino and all dominoes behind it. The arguments z_a and z_b are the
 * values of far_variable at the two tilts, and t is tan((theta_a - theta_b) / 2). */
KERNEL real far_difference(const struct far *far, real z_a, real z_b, real t)
{
    real sum = 0, part = 1, power = 1; /* `part` is (z_a^k - z_b^k) / (z_a - z_b) */
    for (int k = 1; k <= far->order; k++) {
        sum += far->H[k] * part;
        power *= z_b;
        part = part * z_a + power;
    }
    return -t * (1 + z_a * z_b) * sum;
}

/* Returns true if a and b are so close to theta_inf that the far series can replace them and all dominoes
 * behind them. If `slopes` is false, H1 is not needed. */
KERNEL_LOOP bool far_suffices(const struct geometry *geometry, const struct sum_state *state,
                              const struct link *a, const struct link *b, real t, const bool slopes)
{
    const struct far *far = &geometry->far;
    real share = far_share(far, far_variable(geometry, b->tilt)), H = a->weight * t;
    if (!far_done(&state->dH, -H * far->H[1], H * far->rest_H * share, geometry->tol))
        return false;
    /* Test again with the whole tail, not only its first term: the tail may cancel the sum. */
    real tail =
        a->weight * far_difference(far, far_variable(geometry, a->tilt), far_variable(geometry, b->tilt), t);
    if (!far_done(&state->dH, tail, H * far->rest_H * share, geometry->tol))
        return false;
    share = far_share(far, far_variable(geometry, a->tilt));
    real H1 = a->weight * a->slope / 2, J = a->inertia * a->slope * a->slope;
    return (!slopes || far_done(&state->H1, -H1 * far->H[1], H1 * far->rest_H * share, geometry->tol)) &&
           far_done(&state->J, J * far->J[0], J * far->rest_J * share, geometry->tol);
}

/* The sums over a domino and all dominoes behind it. `first` and `second` are the derivatives of H. */
struct far_tail {
    real dH, first, second, J;
};

/* Returns the sums that far_suffices allows. dH is the difference of H between two chains, and b is the
 * domino of the second chain that has the same number as `a`. */
KERNEL struct far_tail far_tail(const struct far *far, real z_a, real z_b, real t)
{
    real value = 0, first = 0, second = 0, J = 0, one = 1 + z_a * z_a; /* `second` is half of H'' */
    for (int k = far->order; k >= 0; k--) {
        second = second * z_a + first;
        first = first * z_a + value;
        value = value * z_a + far->H[k];
        J = J * z_a + far->J[k];
    }
    const real by = -one / 2; /* dz / dtheta */
    return (struct far_tail){.dH = far_difference(far, z_a, z_b, t),
                             .first = first * by,
                             .second = by * by * 2 * second - by * z_a * first,
                             .J = one * one * J};
}

#endif
