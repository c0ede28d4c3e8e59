/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DOM_ENERGY_H
#define DOM_ENERGY_H

#include "dynamics/friction.h"

/* What one pass at theta_c gives. */
struct fuel {
    real exact, paper;  /* both fuels (c7) */
    real inertia_ratio; /* J(0) - 1 = r^-(q+1) J(theta_c) (d8, corrected) */
};

/* 1 - h(theta_f): the closed form of (c7). */
KERNEL real energy_fuel_paper(const struct geometry *geometry);

/* From the sums at theta_c (chain_fall). */
KERNEL struct fuel fuel_of(const struct geometry *geometry, const struct sums *at_c);

/* error, where not NULL, gets bounds. */
KERNEL enum dom_status energy_fuel(const struct geometry *geometry, struct fuel *fuel, struct fuel *error);

#endif
