/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "proof/model/rest.h"

struct rest rest_find(const struct growth *growth, const struct domino *domino, const struct contact *contact,
                      double power, double fall, int n)
{
    const struct shape *shape = growth->shape;
    struct rest rest = {.power = power};
    double x = least_0(tilt_sine(domino->v).lo), w = growth->weight.hi;
    rest.p = PROOF_BOUND(CONTRACTION, least_0(up(1 - down(growth->low.rL.lo * x))), 0);
    rest.ratio = growth->detaches_never ? up(rest.p * w) : w;
    double left = least_0(down(1 - rest.ratio)), per_step = up(contact->shift.hi);
    rest.series = up(1 / left);
    /* From domino to domino, dtheta_i/dtheta is multiplied by at most p, even if followers detach. */
    rest.tilts = up(up(up(shape->steepest * power) * domino->slope.hi) / least_0(down(1 - up(rest.p * w))));
    /* shift_i is dtheta_i/dr. From domino to domino, shift_(i+1) = step_i shift_i + c_i/Y_i <= p shift_i +
     * c_n/Y_n. So no shift exceeds the larger of the two numbers shift_n and (c_n/Y_n) / (1 - p). */
    rest.shift = larger(domino->shift.hi, up(per_step / least_0(down(1 - rest.p))));
    if (growth->detaches_never) {
        /* If no follower detaches, shift_(n+k) <= p^k shift_n + k p^(k-1) c_n/Y_n. */
        double most =
            up(up(domino->shift.hi * rest.series) + up(up(per_step * w) * up(rest.series * rest.series)));
        rest.slides = up(up(shape->steepest * power) * most);
        /* h(theta_n) - h(theta_inf) <= sqrt(1 + d^2) (theta_inf - theta_n), and theta_inf - theta_n <= c_n/(L
         * x_n). */
        rest.drop = up(up(up(shape->steepest * up(contact->X.hi / growth->r.lo)) / down(shape->L.lo * x)));
    } else {
        rest.slides = up(up(up(shape->steepest * power) * rest.shift) * rest.series);
        rest.drop = fall;
    }
    rest.drops = up(up(up(shape->q.hi / growth->r.lo) * up(power * rest.drop)) *
                    up(rest.series * up(n + up(rest.ratio * rest.series))));
    return rest;
}
