/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DOM_ENERGY_H
#define DOM_ENERGY_H

#include "chain.h"

/* 1 - h(theta_f): the closed form of (c7). */
double energy_fuel_paper(const struct lean *lean);

/* Both fuels (c7), and T = J(0) - 1 = r^-(q+1) J(theta_c) (d8, corrected), from one pass at theta_c. */
enum dom_status energy_fuel(const struct lean *lean, struct dom_fuels *fuels, double *T);

#endif
