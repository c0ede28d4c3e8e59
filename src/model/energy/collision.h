/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DOM_COLLISION_H
#define DOM_COLLISION_H

#include "energy/energy.h"

struct launch {
    real fuel;           /* P, the one in use */
    real J0;             /* J(0) */
    real velocity_ratio; /* omega(0) / omega_1(theta_c) */
    real omegasq;        /* tau^2 omega(0)^2 */
    real kinetic;        /* J(0) tau^2 omega(0)^2 */
};

/* (c6) from the fuel of a pass; without friction. */
KERNEL struct launch launch_of(const struct geometry *geometry, enum dom_fuel fuel, const struct fuel *f);

/* (c6) as it stands: where P <= 0 the squares come out negative, and no error is raised. */
KERNEL enum dom_status collision_launch(const struct geometry *geometry, enum dom_fuel fuel,
                                        struct launch *launch, struct launch *error);

#endif
