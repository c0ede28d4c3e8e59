/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The paper's law of motion: contacts without friction take no energy.  Kinetic energy and height together
 * are kept through a cycle (c3), J(theta) w(theta) = J(0) w(0) - [H(theta) - H(0)], w = tau^2 omega^2; the
 * collision keeps the share T / (1 + T) of the angular velocity, T = J(0) - 1 (c4); what a cycle sets free is
 * the fuel P (c7), and a train that repeats itself begins its cycle with the kinetic energy (c6)
 *
 *     K = P T / (r^q + T (r^q - 1)).
 *
 * Source: J. M. J. van Leeuwen, Domino Magnification.
 */
#ifndef DOM_ENERGY_BALANCE_H
#define DOM_ENERGY_BALANCE_H

#include "dynamics/dynamics.h"

/* What one pass at theta_c gives. */
struct fuel {
    real exact, paper;  /* both fuels (c7) */
    real inertia_ratio; /* J(0) - 1 = r^-(q+1) J(theta_c) (d8, corrected) */
};

/* h(0) - h(theta_f): the closed form of (c7). */
KERNEL real energy_fuel_paper(const struct geometry *geometry);

/* From the sums at theta_c (chain_fall). */
KERNEL struct fuel fuel_of(const struct geometry *geometry, const struct sums *at_c);

/* error, where not NULL, gets bounds. */
KERNEL enum dom_status energy_fuel(const struct geometry *geometry, struct fuel *fuel, struct fuel *error);

/* (c6) from the fuel of a pass. */
KERNEL struct launch launch_of(const struct geometry *geometry, enum dom_fuel fuel, const struct fuel *f);

/* The acceleration by energies, half of dw/dtheta from (c3) differentiated; as in struct dynamics. */
KERNEL enum dom_status energy_acceleration(const struct geometry *geometry, struct tilt head, real w,
                                           real *acceleration, size_t *n);

static const struct dynamics energy_balance;

#endif
