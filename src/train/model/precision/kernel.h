/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A kernel is a table of functions for one precision, or for a comparison method (gsl or paper). Most of the
 * functions correspond to those in domino.h, without the prefix "dom_". If a comparison method cannot answer
 * a question, its function for this question is NULL.
 */
#ifndef DOM_KERNEL_H
#define DOM_KERNEL_H

#include "geometry/request.h"

/* Calls X(name, types of arguments) for each function. All functions return a status. */
#define KERNEL_FUNCTIONS(X)                                                                                  \
    X(angles_find, const struct request *, struct dom_angles *)                                              \
    X(contact_find, const struct request *, dom_real, struct dom_contact *)                                  \
    X(chain_walk, const struct request *, dom_real, dom_visit *, void *)                                     \
    X(energy_find, const struct request *, dom_real, struct dom_energy *)                                    \
    X(fuel_find, const struct request *, struct dom_fuels *)                                                 \
    X(launch_find, const struct request *, struct dom_launch *)                                              \
    X(barrier_find, const struct request *, struct dom_barrier *)                                            \
    X(cycle_omegasq, const struct request *, dom_real, dom_real *)                                           \
    X(cycle_stop, const struct request *, dom_real *)                                                        \
    X(cycle_duration, const struct request *, dom_real *)                                                    \
    X(cycle_events, const struct request *, struct dom_event *, int *)                                       \
    X(cycle_state, const struct request *, dom_real, struct dom_state *)                                     \
    X(cycle_tilt, const struct request *, dom_real, dom_real *)                                              \
    X(cycle_walk, const struct request *, size_t, enum dom_spacing, dom_state_visit *, void *)               \
    X(cycle_forces, const struct request *, dom_real, dom_force_visit *, void *)                             \
    X(cycle_least_force, const struct request *, struct dom_least_force *)                                   \
    X(cycle_floor, const struct request *, struct dom_floor *)                                               \
    X(limit_rmax, const struct request *, struct dom_limit *)                                                \
    X(limit_pair, const struct request *, struct dom_limit *)                                                \
    X(limit_best, const struct request *, struct dom_best *)                                                 \
    X(row_run, const struct row_request *, bool, dom_fall_visit *, void *, struct dom_verdict *)             \
    X(row_watch, const struct row_request *, const dom_real *, size_t, dom_moment_visit *, void *,           \
      struct dom_verdict *)                                                                                  \
    X(count_find, dom_real, dom_real, dom_real, const struct dom_compute *, struct dom_count *)

struct kernel {
#define KERNEL_MEMBER(name, ...) enum dom_status (*name)(__VA_ARGS__);
    KERNEL_FUNCTIONS(KERNEL_MEMBER)
#undef KERNEL_MEMBER
};

/* Each kernel is compiled once, with the types of one header. A bridge kernel (dispatch/bridge.c) converts
 * between the types of the two headers. */
#ifdef DOMQ
extern const struct kernel domq__kernel_float, domq__kernel_quad, domq__kernel_bridge;
#else
extern const struct kernel dom__kernel_double, dom__kernel_gsl, dom__kernel_paper, dom__kernel_bridge;

struct study; /* row/study.h */

/*
 * Studies run a row many times, in double. `begin` runs the row as planned. `run` then runs copies of it in
 * which the dominoes `first` to `last` have changed. If the `verdict` of `begin` is NULL, no row is planned,
 * and each row may differ in all dominoes, in its effects and in its push. Of their verdicts only `end` and
 * `domino` count. Call `end` even after an error.
 */
struct studies {
    enum dom_status (*begin)(const struct row_request *request, struct study **study,
                             struct dom_verdict *verdict);
    enum dom_status (*run)(struct study *study, const struct dom_row *row, size_t first, size_t last,
                           struct dom_verdict *verdict);
    void (*end)(struct study *study);
};
extern const struct studies dom__studies;
#endif

#endif
