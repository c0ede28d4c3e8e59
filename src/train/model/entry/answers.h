/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The functions that answer a question once its values have been checked. Each does what the function of
 * domino.h or domino_row.h with the same name does. */
#pragma once

#include "geometry/request.h"
#include "numerics/real.h"

KERNEL enum dom_status angles_find(const struct request *train, struct dom_angles *angles);
KERNEL enum dom_status contact_find(const struct request *train, dom_real theta, struct dom_contact *contact);
KERNEL enum dom_status chain_walk(const struct request *train, dom_real theta, dom_visit *visit,
                                  void *context);
KERNEL enum dom_status energy_find(const struct request *train, dom_real theta, struct dom_energy *energy);
KERNEL enum dom_status fuel_find(const struct request *train, struct dom_fuels *fuels);
KERNEL enum dom_status launch_find(const struct request *train, struct dom_launch *launch);
KERNEL enum dom_status barrier_find(const struct request *train, struct dom_barrier *barrier);
KERNEL enum dom_status cycle_omegasq(const struct request *train, dom_real theta, dom_real *omegasq);
KERNEL enum dom_status cycle_duration(const struct request *train, dom_real *duration);
KERNEL enum dom_status cycle_events(const struct request *train, struct dom_event *events, int *count);
KERNEL enum dom_status cycle_state(const struct request *train, dom_real theta, struct dom_state *state);
KERNEL enum dom_status cycle_walk(const struct request *train, size_t count, enum dom_spacing by,
                                  dom_state_visit *visit, void *context);
KERNEL enum dom_status cycle_least_force(const struct request *train, struct dom_least_force *least);
KERNEL enum dom_status limit_rmax(const struct request *train, struct dom_limit *limit);
KERNEL enum dom_status limit_pair(const struct request *train, struct dom_limit *limit);
KERNEL enum dom_status limit_best(const struct request *train, struct dom_best *best);
KERNEL enum dom_status count_find(dom_real first, dom_real height, dom_real r, struct dom_count *count);
