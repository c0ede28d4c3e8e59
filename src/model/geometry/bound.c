/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "geometry/bound.h"

static void bound_geometry(const struct geometry *geometry, const struct link *k, struct bound *b)
{
    b->Y = b->arm = b->contact_slope = 0;
    if (!k->leads)
        return;
    if (k->tilt.x == 0) {
        b->Y = b->arm = 6 * ROUNDOFF * k->contact.Y;
        return;
    }
    real X = fabs(k->contact.X), Y = k->contact.Y, arm = k->contact.arm,
         rLx = geometry->r * geometry->L * k->tilt.x;
    real of_rLx = geometry->r * geometry->L * k->tilt.y * b->angle + 3 * ROUNDOFF * rLx;
    b->Y = X * rLx / Y * b->angle + 4 * ROUNDOFF * Y;
    /* Here geometry_contact computes the slope as 1 - r L x / Y. The fraction is at most 1/2, so a relative
     * error in Y changes the slope by at most half as much. */
    if (2 * rLx <= Y) {
        b->arm = b->Y + of_rLx + ROUNDOFF * arm;
        b->contact_slope = (of_rLx + rLx * b->Y / Y) / Y + ROUNDOFF;
        return;
    }
    real part = geometry->leave_by * (k->tilt.x * b->angle + 6 * ROUNDOFF * k->tilt.v) +
                4 * ROUNDOFF * geometry->leave_at;
    b->arm = (part + arm * (b->Y + of_rLx)) / (Y + rLx) + 2 * ROUNDOFF * arm;
    b->contact_slope = (b->arm + k->contact_slope * b->Y) / Y + ROUNDOFF * k->contact_slope;
}

KERNEL struct bound bound_head(const struct geometry *geometry, const struct link *head, real angle)
{
    struct bound b = {.angle = angle};
    bound_geometry(geometry, head, &b);
    return b;
}

KERNEL void bound_next(const struct geometry *geometry, const struct link *leader,
                       const struct link *follower, struct bound *b)
{
    /* X is the difference r s - r L v, so its rounding error is bounded by 4 ROUNDOFF (r s + r L v). */
    real terms = geometry->r * (geometry->s + geometry->L * leader->tilt.v);
    real contact = 4 * ROUNDOFF * leader->contact.Y * (terms + fabs(leader->contact.X));
    b->angle = leader->contact_slope * b->angle + contact + 5 * ROUNDOFF * follower->tilt.x;
    b->slope =
        leader->contact_slope * b->slope + leader->slope * b->contact_slope + ROUNDOFF * follower->slope;
    b->weight += 3 * ROUNDOFF;
    b->inertia += 4 * ROUNDOFF;
    bound_geometry(geometry, follower, b);
}

KERNEL real bound_J(const struct link *k, const struct bound *b)
{
    real slope = k->slope;
    return k->inertia * (slope * (2 * b->slope + slope * (b->inertia + 3 * ROUNDOFF)) + b->slope * b->slope);
}

KERNEL real bound_H1(const struct geometry *geometry, const struct link *k, const struct bound *b)
{
    real lift = geometry_height_slope(geometry, k->tilt);
    real lift_error = geometry_height(geometry, k->tilt) * b->angle +
                      3 * ROUNDOFF * geometry_height_terms(geometry, k->tilt);
    return k->weight * (fabs(lift) * (b->slope + k->slope * (b->weight + 2 * ROUNDOFF)) +
                        (k->slope + b->slope) * lift_error);
}

KERNEL real bound_energy_change(const struct geometry *geometry, struct tilt a, struct tilt b, real angle_a,
                                real angle_b, real t, real t_error)
{
    real lift = geometry_height_slope(geometry, a) + geometry_height_slope(geometry, b);
    real terms = geometry_height_terms(geometry, a) + geometry_height_terms(geometry, b);
    real lift_error = geometry_height(geometry, a) * angle_a + geometry_height(geometry, b) * angle_b +
                      4 * ROUNDOFF * terms;
    return fabs(lift) * t_error + (fabs(t) + t_error) * lift_error;
}

KERNEL real bound_tan_half(const struct link *a, const struct link *b, const struct bound *bound_a,
                           const struct bound *bound_b, real t, real t_error)
{
    real Y = a->contact.Y + b->contact.Y, F = (a->contact.arm + b->contact.arm) / Y;
    if (t == 0)
        return t_error;
    real of_F = (bound_a->arm + bound_b->arm + F * (bound_a->Y + bound_b->Y)) / Y + 3 * ROUNDOFF * F;
    return F * (t_error + 6 * ROUNDOFF * fabs(t)) + fabs(t) * (1 + t * t) * of_F;
}

KERNEL real bound_leaving(const struct geometry *geometry, const struct link *leader, const struct bound *b,
                          real t_f)
{
    real rL = geometry->r * geometry->L, x = leader->tilt.x, sines = geometry->leave.x + x,
         arm = leader->contact.arm;
    if (t_f == 0 || arm == 0)
        return b->arm;
    real of_whole = (b->Y + rL * leader->tilt.y * b->angle) / (leader->contact.Y + rL * x);
    return fabs(t_f) * (2 * b->arm / arm + 2 * of_whole + leader->tilt.y * b->angle / sines + 24 * ROUNDOFF);
}
