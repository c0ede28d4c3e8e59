/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The paper's law of motion: contacts without friction dissipate no energy. So the sum of kinetic and
 * potential energy is constant in a cycle; see (21; c3) and (51; d9). With w = tau^2 omega^2,
 *
 *     J(theta) w(theta) = J(0) w(0) - [H(theta) - H(0)].
 *
 * The collision at the start of the cycle does dissipate energy. It multiplies the angular velocity by
 * T / (1 + T), where T = J(0) - 1 is the inertia ratio (22; c4). During the cycle, the train releases the
 * fuel P (25; c7). If each cycle repeats the one before (23; c5), a cycle begins with the kinetic energy
 * (24; c6)
 *
 *     K = P T / (r^q + T (r^q - 1)).
 *
 * Source: J. M. J. van Leeuwen, Domino Magnification.
 */
#ifndef DOM_ENERGY_BALANCE_H
#define DOM_ENERGY_BALANCE_H

#include "dynamics/dynamics.h"

/* The results of one pass down the chain, with the head at theta_c. */
struct fuel {
    real exact, paper;  /* the fuel (25; c7) from the energy balance, and from the paper's closed form */
    real inertia_ratio; /* inertia ratio J(0) - 1 = r^-(q+1) J(theta_c) (50; d8, corrected) */
};

/* Returns true if the paper's closed form of the fuel is valid: on a level floor, with sharp edges. */
KERNEL bool energy_paper_holds(const struct geometry *geometry)
{
    return geometry->g.along == 0 && !geometry->law->rolls;
}

KERNEL struct fuel fuel_of(const struct geometry *geometry, const struct sums *at_c);

/* Finds the fuel (25; c7). */
KERNEL enum dom_status energy_fuel(const struct geometry *geometry, struct fuel *fuel);

/* Returns the launch (24; c6) of a train with the fuel and the inertia ratio in *f. */
KERNEL struct launch launch_of(const struct geometry *geometry, enum dom_fuel fuel, const struct fuel *f);

/* Finds the acceleration as half of dw/dtheta, from the equation of motion, with or without friction. The
 * arguments are those of `acceleration` in struct dynamics. */
KERNEL enum dom_status equation_acceleration(const struct geometry *geometry, struct tilt head, real w,
                                             real *acceleration, size_t *n);

static const struct dynamics energy_balance;

#endif
