/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Losses of dominoes with rounded edges (rounded.h). rounded_arms gives the lever arms. With rounded
 * edges, a domino's inertia i depends on its tilt. So its term in A contains i theta', and its term in B
 * contains i theta'' + (i'/2 + drag) theta'^2. Here i' is the derivative of i with respect to the domino's
 * tilt, and theta' and theta'' are the derivatives of this tilt with respect to the tilt of the head.
 */
#include "geometry/rounded.h"

/*
 * The rounding errors of S, theta' and theta'' of a domino, in units of the unit roundoff. The errors grow
 * where digits cancel. In the arm a, digits cancel when the follower is about to detach. In the arm b, digits
 * cancel if X < 0. They also cancel in the second derivative of the contact.
 */
struct rounding {
    real S, slope, second_derivative;
};

static void rounding_next(struct rounding *e, const struct walk *k, real S, real a, real b)
{
    const struct link *link = &k->link;
    const struct geometry *self = link->geometry;
    const real slope = fabs(link->slope), contact_slope = fabs(link->contact_slope), curve = fabs(k->curve),
               whole = self->r * k->b, ratio = fabs(a / b);
    const real of_b = link->contact.X < 0 ? (2 * whole - b) / fabs(b) : 1,
               of_curve = curve + 2 * (self->L * link->tilt.y + self->rounded.rho_1 * link->tilt.x) / k->b;
    e->S = e->S * ratio + fabs(S) * ((2 * whole - a) / fabs(b) + ratio * of_b);
    e->second_derivative = e->second_derivative * contact_slope + 2 * fabs(k->second_derivative) +
                           slope * (slope * of_curve + 2 * e->slope * curve);
    e->slope = e->slope * contact_slope + 2 * slope;
}

KERNEL enum dom_status rounded_equation(const struct geometry *geometry, struct tilt head,
                                        struct equation_of_motion *equation)
{
    struct series A = {0}, B = {0}, C = {0};
    struct walk k = rounded_begin(geometry, head);
    struct rounding e = {0};
    real S = 1, A_error = 0, B_error = 0, C_error = 0;
    bool wrong_side = false;
    for (;;) {
        const struct link *link = &k.link;
        const struct geometry *self = link->geometry;
        enum dom_status status = chain_watch(geometry, link->i);
        if (status != DOM_OK)
            return status;
        real i = geometry_inertia(self, link->tilt), half_i1 = geometry_inertia_slope(self, link->tilt) / 2,
             slope = link->slope, turns = i * k.second_derivative + slope * slope * (half_i1 + self->drag),
             size = fabs(S), lift = self->steepest + fabs(self->rounded.roll);
        series_add(&A, link->inertia * S * i * slope);
        series_add(&B, link->inertia * S * turns);
        series_add(&C, -link->weight * S * geometry_lift(self, link->tilt) / 2);
        A_error += link->inertia * i * (e.S * fabs(slope) + size * e.slope);
        B_error +=
            link->inertia *
            (e.S * fabs(turns) + size * (i * e.second_derivative +
                                         2 * fabs((half_i1 + self->drag) * slope) * (e.slope + fabs(slope))));
        C_error += link->weight * (e.S + size) * lift;
        if (link->i + 1 >= geometry->n || !link->leads)
            break;
        const struct arms arms = rounded_arms(link);
        real a = arms.a, b = arms.b, ratio = fabs(arms.ratio),
             curve = fabs(k.second_derivative) + slope * slope * (fabs(k.curve) + 1 + self->drag),
             next = fmax(self->inertia * ratio, fmax(self->decay, self->decay_J));
        if (series_done(&C, link->weight * size * lift, fmax(self->weight * ratio, self->decay),
                        geometry->tol) &&
            series_done(&A, link->inertia * size * slope, next, geometry->tol) &&
            series_done(&B, link->inertia * size * curve, next, geometry->tol))
            break;
        wrong_side = wrong_side || b <= 0;
        rounding_next(&e, &k, S, a, b);
        S *= arms.ratio;
        rounded_next(&k);
    }
    chain_count(geometry, k.link.i + 1);
    rounded_count(geometry);
    if (geometry->work && geometry->mu != 0)
        geometry->work->entered[DOM_EFFECT_friction]++;
    *equation = (struct equation_of_motion){.A = A.sum + A.lost,
                                            .B = B.sum + B.lost,
                                            .C = C.sum + C.lost,
                                            .A_size = A.size + A_error,
                                            .B_size = B.size + B_error,
                                            .C_size = C.size + C_error,
                                            .n = k.link.i + 1};
    equation->locks = wrong_side || equation->A <= 0;
    return isfinite(equation->A) && isfinite(equation->B) && isfinite(equation->C) ? DOM_OK : DOM_NOT_FINITE;
}
