/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The paper's law of motion: contacts without friction take no energy. The sum of kinetic energy and height
 * is constant in a cycle (21; c3) and (51; d9), J(theta) w(theta) = J(0) w(0) - [H(theta) - H(0)], w = tau^2
 * omega^2. The collision leaves T / (1 + T) of the angular velocity, T = J(0) - 1 (22; c4). A cycle releases
 * the fuel P (25; c7). A train that repeats itself (23; c5) begins its cycle with the kinetic energy (24; c6)
 *
 *     K = P T / (r^q + T (r^q - 1)).
 *
 * Source: J. M. J. van Leeuwen, Domino Magnification.
 */
#ifndef DOM_ENERGY_BALANCE_H
#define DOM_ENERGY_BALANCE_H

#include "dynamics/dynamics.h"

/* The results of one pass at theta_c. */
struct fuel {
    real exact, paper;  /* both fuels (25; c7) */
    real inertia_ratio; /* J(0) - 1 = r^-(q+1) J(theta_c) (50; d8, corrected) */
};

/* Returns true if the paper's closed form of the fuel holds: only on a level floor and with sharp edges. */
KERNEL bool energy_paper_holds(const struct geometry *geometry)
{
    return geometry->g.along == 0 && geometry->law->closed_form;
}

/* Returns the fuel from the sums at theta_c. */
KERNEL struct fuel fuel_of(const struct geometry *geometry, const struct sums *at_c);

/* Finds the fuel, with bounds unless error is NULL. */
KERNEL enum dom_status energy_fuel(const struct geometry *geometry, struct fuel *fuel, struct fuel *error);

/* Returns the launch (24; c6) from the fuel of a pass. */
KERNEL struct launch launch_of(const struct geometry *geometry, enum dom_fuel fuel, const struct fuel *f);

/* Finds the acceleration from energies: half of dw/dtheta, from the derivative of (21; c3). Arguments as in
 * struct dynamics. */
KERNEL enum dom_status energy_acceleration(const struct geometry *geometry, struct tilt head, real w,
                                           real *acceleration, size_t *n);

static const struct dynamics energy_balance;

#endif
