/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "geometry/geometry.h"

KERNEL enum dom_status geometry_tilt(const struct geometry *geometry, real theta, struct tilt *tilt)
{
    /* If theta_c >= 0 and theta is less than c.x = sin theta_c, then theta is also less than theta_c. The
     * comparisons below give the same result with c.x instead of theta_c, and no arc tangent is needed. */
    const real theta_c = theta < geometry->c.x ? geometry->c.x : tilt_angle(geometry->c);
    if (!(theta >= geometry->lean) || theta > theta_c + fabs(theta_c) * 2 * REAL_EPSILON)
        return DOM_BAD_TILT;
    *tilt = theta < theta_c ? tilt_make(sin(theta), cos(theta)) : geometry->c;
    return DOM_OK;
}

KERNEL real geometry_half_u(const struct geometry *geometry)
{
    if (geometry->rounded.roll != 0)
        return tan(geometry_theta_u(geometry) / 2);
    return geometry->h.x / (geometry->h.y + geometry->steepest);
}

KERNEL real geometry_theta_u(const struct geometry *geometry)
{
    real level = atan(geometry->h.x / geometry->h.y), part = geometry->rounded.roll / geometry->steepest;
    return part == 0 ? level : fmax(level + atan2(part, sqrt((1 - part) * (1 + part))), 0);
}

KERNEL real geometry_rise_u(const struct geometry *geometry)
{
    real half = geometry_half_u(geometry);
    if (geometry->rounded.roll == 0)
        return geometry->h.x * half;
    struct tilt u = tilt_half(half);
    return half * (geometry->h.x * (1 + u.y) - geometry->h.y * u.x) + geometry->rounded.roll * 2 * atan(half);
}

KERNEL real geometry_tips_at(const struct geometry *geometry)
{
    const struct rounded *of = &geometry->rounded;
    if (of->rho == 0)
        return geometry->h.x / geometry->steepest;
    const real theta = geometry_theta_u(geometry);
    return of->rho * theta + of->tall * sin(theta);
}

KERNEL void geometry_tips(const struct geometry *geometry, real *sine, real *cosine)
{
    real u = geometry->steepest; /* h(theta_u) (6; b2) */
    *sine = -geometry_lift(geometry, geometry->c) / u;
    *cosine = geometry_height(geometry, geometry->c) / u;
}
