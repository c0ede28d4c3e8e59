/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * What a precision, or a method to compare with, can answer; NULL for what it cannot.
 * The members are the functions of domino.h without their "dom_".
 */
#ifndef DOM_KERNEL_H
#define DOM_KERNEL_H

#include "domino.h"

struct kernel {
    enum dom_status (*angles_find)(const struct dom_train *, struct dom_angles *, struct dom_angles *);
    enum dom_status (*contact_find)(const struct dom_train *, dom_real, struct dom_contact *,
                                    struct dom_contact *);
    enum dom_status (*chain_walk)(const struct dom_train *, dom_real, bool, dom_visit *, void *);
    enum dom_status (*energy_find)(const struct dom_train *, dom_real, struct dom_energy *,
                                   struct dom_energy *);
    enum dom_status (*fuel_find)(const struct dom_train *, struct dom_fuels *, struct dom_fuels *);
    enum dom_status (*launch_find)(const struct dom_train *, struct dom_launch *, struct dom_launch *);
    enum dom_status (*barrier_find)(const struct dom_train *, struct dom_barrier *, struct dom_barrier *);
    enum dom_status (*cycle_omegasq)(const struct dom_train *, dom_real, dom_real *, dom_real *);
    enum dom_status (*cycle_stop)(const struct dom_train *, dom_real *, dom_real *);
    enum dom_status (*cycle_duration)(const struct dom_train *, dom_real *, dom_real *);
    enum dom_status (*cycle_events)(const struct dom_train *, struct dom_event *, int *);
    enum dom_status (*cycle_state)(const struct dom_train *, dom_real, struct dom_state *,
                                   struct dom_state *);
    enum dom_status (*cycle_tilt)(const struct dom_train *, dom_real, dom_real *);
    enum dom_status (*cycle_walk)(const struct dom_train *, size_t, enum dom_spacing, bool, dom_state_visit *,
                                  void *);
    enum dom_status (*cycle_forces)(const struct dom_train *, dom_real, dom_force_visit *, void *);
    enum dom_status (*cycle_least_force)(const struct dom_train *, struct dom_least_force *);
    enum dom_status (*cycle_floor)(const struct dom_train *, struct dom_floor *);
    enum dom_status (*limit_rmax)(const struct dom_train *, struct dom_limit *, struct dom_limit *,
                                  enum dom_status *);
    enum dom_status (*limit_pair)(const struct dom_train *, struct dom_limit *, struct dom_limit *);
    enum dom_status (*limit_best)(const struct dom_train *, struct dom_best *, struct dom_best *);
    enum dom_status (*row_run)(const struct dom_row *, bool, dom_fall_visit *, void *, struct dom_verdict *);
    enum dom_status (*count_find)(dom_real, dom_real, dom_real, struct dom_count *, struct dom_count *);
};

extern const struct kernel kernel_float, kernel_double, kernel_quad, kernel_gsl, kernel_paper;

#endif
