/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The same question about many trains. */
#pragma GCC visibility push(default) /* precision/shared.awk */
#include "domino_study.h"
#pragma GCC visibility pop
#include "numerics/interrupt.h"

/* X(QUESTION, function, structure), and AT for the questions that need a tilt. */
#define QUESTIONS(X, AT)                                                                                     \
    X(ANGLES, angles_find, struct dom_angles)                                                                \
    AT(CONTACT, contact_find, struct dom_contact)                                                            \
    AT(ENERGY, energy_find, struct dom_energy)                                                               \
    X(FUEL, fuel_find, struct dom_fuels)                                                                     \
    X(LAUNCH, launch_find, struct dom_launch)                                                                \
    X(BARRIER, barrier_find, struct dom_barrier)                                                             \
    AT(OMEGASQ, cycle_omegasq, double)                                                                       \
    X(DURATION, cycle_duration, double)                                                                      \
    X(RMAX, limit_rmax, struct dom_limit)                                                                    \
    X(PAIR, limit_pair, struct dom_limit) X(BEST, limit_best, struct dom_best)

enum dom_status dom_trains_ask(enum dom_question question, const struct dom_train *trains,
                               const double *tilts, size_t count, const struct dom_compute *compute,
                               void *answers, enum dom_status *statuses)
{
    bool interrupted = false;
    for (size_t k = 0; k < count; k++) {
        interrupted = interrupted || (compute && dom_interrupted(compute->interrupt));
        statuses[k] = DOM_INTERRUPTED;
        if (interrupted)
            continue;
        switch (question) {
#define ASK(name, find, structure)                                                                           \
    case DOM_ASK_##name:                                                                                     \
        statuses[k] = dom_##find(&trains[k], compute, (structure *)answers + k);                             \
        break;
#define ASK_AT(name, find, structure)                                                                        \
    case DOM_ASK_##name:                                                                                     \
        statuses[k] = dom_##find(&trains[k], compute, tilts[k], (structure *)answers + k);                   \
        break;
            QUESTIONS(ASK, ASK_AT)
        default:
            return DOM_NO_METHOD;
        }
        interrupted = statuses[k] == DOM_INTERRUPTED;
    }
    return interrupted ? DOM_INTERRUPTED : DOM_OK;
}
