/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * What a precision, or a method to compare with, can answer; NULL for what it cannot.
 * The members are the functions of domino.h without their "dom_". Where a function takes bounds, NULL leaves
 * them out.
 */
#ifndef DOM_KERNEL_H
#define DOM_KERNEL_H

#include "geometry/request.h"

struct kernel {
    enum dom_status (*angles_find)(const struct request *, struct dom_angles *, struct dom_angles_error *);
    enum dom_status (*contact_find)(const struct request *, dom_real, struct dom_contact *,
                                    struct dom_contact_error *);
    enum dom_status (*chain_walk)(const struct request *, dom_real, dom_visit *, void *);
    enum dom_status (*energy_find)(const struct request *, dom_real, struct dom_energy *,
                                   struct dom_energy_error *);
    enum dom_status (*fuel_find)(const struct request *, struct dom_fuels *, struct dom_fuels_error *);
    enum dom_status (*launch_find)(const struct request *, struct dom_launch *, struct dom_launch_error *);
    enum dom_status (*barrier_find)(const struct request *, struct dom_barrier *, struct dom_barrier_error *);
    enum dom_status (*cycle_omegasq)(const struct request *, dom_real, dom_real *, dom_real *);
    enum dom_status (*cycle_stop)(const struct request *, dom_real *, dom_real *);
    enum dom_status (*cycle_duration)(const struct request *, dom_real *, dom_real *);
    enum dom_status (*cycle_events)(const struct request *, struct dom_event *, int *);
    enum dom_status (*cycle_state)(const struct request *, dom_real, struct dom_state *,
                                   struct dom_state_error *);
    enum dom_status (*cycle_tilt)(const struct request *, dom_real, dom_real *);
    enum dom_status (*cycle_walk)(const struct request *, size_t, enum dom_spacing, dom_state_visit *,
                                  void *);
    enum dom_status (*cycle_forces)(const struct request *, dom_real, dom_force_visit *, void *);
    enum dom_status (*cycle_least_force)(const struct request *, struct dom_least_force *);
    enum dom_status (*cycle_floor)(const struct request *, struct dom_floor *);
    enum dom_status (*limit_rmax)(const struct request *, struct dom_limit *, struct dom_limit_error *);
    enum dom_status (*limit_pair)(const struct request *, struct dom_limit *, struct dom_limit_error *);
    enum dom_status (*limit_best)(const struct request *, struct dom_best *, struct dom_best_error *);
    enum dom_status (*row_run)(const struct row_request *, bool, dom_fall_visit *, void *,
                               struct dom_verdict *);
    enum dom_status (*count_find)(dom_real, dom_real, dom_real, struct dom_count *, struct dom_count_error *);
};

extern const struct kernel kernel_float, kernel_double, kernel_quad, kernel_gsl, kernel_paper;

#endif
