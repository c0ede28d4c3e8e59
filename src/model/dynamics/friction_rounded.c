/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Friction between dominoes with rounded edges: the tip is a circle of radius rho_1, and the foot rolls
 * (geometry/rounded.h). About the lines of contact with the floor the arms, times r, are those of link_arm_a
 * and link_arm_b. The inertia of a domino changes with its tilt: A and B have i theta_i' and i theta_i'' + i'
 * theta_i'^2 / 2.
 */
#include "dynamics/flow.h"
#include "geometry/rounded.h"

KERNEL enum dom_status rounded_equation_of_motion(const struct geometry *geometry, struct tilt head,
                                                  struct equation_of_motion *equation)
{
    struct series A = {0}, B = {0}, C = {0};
    struct roller k = roller_head(geometry, head);
    real S = 1, noise = 1;
    bool wrong_side = false;
    for (;;) {
        const struct link *link = &k.link;
        const struct geometry *own = link->geometry;
        enum dom_status status = chain_watch(geometry, link->i);
        if (status != DOM_OK)
            return status;
        real i = geometry_inertia(own, link->tilt), slope = link->slope,
             turns = i * k.second_derivative + slope * slope * geometry_inertia_slope(own, link->tilt) / 2,
             lift = own->reach + fabs(own->rounded.roll);
        series_add(&A, link->inertia * S * i * slope);
        series_add(&B, link->inertia * S * turns);
        series_add(&C, -link->weight * S * geometry_lift(own, link->tilt) / 2);
        if (link->i + 1 >= geometry->n || !link->leads)
            break;
        real a = link_arm_a(link), b = link_arm_b(link), size = fabs(S), ratio = fabs(a / b),
             curve = fabs(k.second_derivative) + slope * slope * (fabs(k.rolling.curve) + 1),
             next = fmax(own->inertia * ratio, fmax(own->decay, own->decay_J));
        if (series_done(&C, link->weight * size * lift, fmax(own->weight * ratio, own->decay),
                        geometry->tol) &&
            series_done(&A, link->inertia * size * slope, next, geometry->tol) &&
            series_done(&B, link->inertia * size * curve, next, geometry->tol))
            break;
        wrong_side = wrong_side || b <= 0;
        noise += link->contact.X < 0 ? own->r * k.rolling.b / fabs(b) : 0;
        S *= a / b;
        roller_next(&k);
    }
    chain_count(geometry, k.link.i + 1);
    rounded_count(geometry);
    if (geometry->work)
        geometry->work->entered[DOM_EFFECT_friction]++;
    *equation = (struct equation_of_motion){.A = A.sum + A.lost,
                                            .B = B.sum + B.lost,
                                            .C = C.sum + C.lost,
                                            .A_size = A.size * noise,
                                            .B_size = B.size * noise,
                                            .C_size = C.size * noise,
                                            .n = k.link.i + 1};
    equation->locks = wrong_side || equation->A <= 0;
    return isfinite(equation->A) && isfinite(equation->B) && isfinite(equation->C) ? DOM_OK : DOM_NOT_FINITE;
}
