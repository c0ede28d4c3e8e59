/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The collision (c4): the struck domino, upright, and the chain that hits it move on as one.  With the
 * inertia ratio T = r^-(q+1) J(theta_c), J the inertia of the chain (with friction S_1 A in its place), the
 * angular momentum that all the contacts pass on is kept:
 *
 *     (1 + T) omega(0) = T omega_1(theta_c).
 */
#ifndef DOM_COLLISION_H
#define DOM_COLLISION_H

#include "numerics/real.h"

/* Returns omega(0) / omega_1(theta_c), what a collision keeps of the angular velocity. */
KERNEL real collision_velocity_ratio(real inertia_ratio)
{
    return inertia_ratio / (1 + inertia_ratio);
}

/* How a cycle begins, in units of the head. */
struct launch {
    real fuel;           /* P, the one in use */
    real J0;             /* J(0) */
    real inertia_ratio;  /* T of the collision */
    real velocity_ratio; /* omega(0) / omega_1(theta_c) */
    real omegasq;        /* tau^2 omega(0)^2 */
    real kinetic;        /* J(0) tau^2 omega(0)^2 */
    real arrives;        /* kinetic energy at theta_c, of a train that gets there */
};

#endif
